// Paths in a job file: relative to it, and nowhere else unless allowed.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job_values.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facet::batch {

class JobPaths {
public:
    /// `allowed`: further folders that may be read.
    JobPaths(std::filesystem::path folder, std::vector<std::string> allowed)
        : folder_(std::move(folder)), allowed_(std::move(allowed)) {}

    /// Names of scenes with their patterns written out; a pattern or file that names nothing is a
    /// warning. Errors: input_invalid (no text, standard input, outside the job's folder).
    [[nodiscard]] base::Status resolve_scenes(const Given& given, std::vector<Json>& scenes,
                                              base::Warnings& warnings) const;
    /// Makes a value that names a file (an environment, a texture, a preset's file) that file's
    /// path. Errors: likewise.
    [[nodiscard]] base::Status resolve(const Given& given, Json& value) const;

private:
    [[nodiscard]] base::Result<std::string> in_job(const std::string& text) const;

    std::filesystem::path folder_;
    std::vector<std::string> allowed_;
};

}  // namespace facet::batch
