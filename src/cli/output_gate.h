// What can be refused about an output before anything is rendered.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/image_formats.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace facet::cli {

struct OutputRules {
    bool make_folders = false;   ///< --mkdirs
    bool keep_existing = false;  ///< --no-clobber
};

/// The format that a file's ending asks for; nothing where it names none that can be written.
[[nodiscard]] std::optional<tables::ImageFormat> format_of(const std::filesystem::path& output);

/// Checks `output`: its ending is a format that can be written, its folder is there (or is made),
/// it can be written, it may be replaced, and it is none of `inputs` (by device and inode, so
/// through links too). Errors: usage, input_invalid.
[[nodiscard]] base::Status check_output(const std::filesystem::path& output,
                                        const OutputRules& rules,
                                        std::span<const std::string> inputs);

}  // namespace facet::cli
