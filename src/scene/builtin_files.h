// Files that come with the program and are named builtin:NAME.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene {

/// A kind of file below the data folder.
struct BuiltinKind {
    std::string_view folder;  ///< as "resources/lamps"
    std::string_view ending;  ///< with its dot
    std::string_view what;    ///< as an error names one
};
inline constexpr BuiltinKind builtin_scenes{"resources/scenes", ".glb", "scene"};
inline constexpr BuiltinKind builtin_lamps{"resources/lamps", ".ies", "lamp"};
inline constexpr BuiltinKind builtin_textures{"resources/textures", ".png", "texture"};

/// Names of all there are, without `builtin:`, in order; none without a data folder.
[[nodiscard]] std::vector<std::string> builtin_names(const BuiltinKind& kind);
/// The file of `builtin:NAME`; any other name is a path itself. Errors: usage (no such NAME).
[[nodiscard]] base::Result<std::filesystem::path> file_of(const std::string& name,
                                                          const BuiltinKind& kind);

}  // namespace facet::scene
