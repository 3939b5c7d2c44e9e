// All the pages of a course into a folder, or the skeleton of a new lesson.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/progress.h"
#include "teach/lesson.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facet::teach {

struct CourseRequest {
    std::vector<std::string> lessons;  ///< names or folders; none: all of the program's own
    std::filesystem::path output;
    std::string language = "en";
    bool force = false;  ///< replaces pages in a folder that is not empty
};
struct Course {
    std::filesystem::path index;
    std::size_t lesson_count = 0;
    std::size_t bytes = 0;
};

/// Makes every page in memory and then writes them: on an error nothing is written. Errors: usage
/// (no such lesson or language, the folder is not empty), input_invalid (a lesson's), those of the
/// renderer.
[[nodiscard]] base::Result<Course> make_course(const CourseRequest& request, base::Log& log,
                                               const base::Progress& progress);

/// A folder with a lesson to begin from, named as its last part. Errors: usage (it is there
/// already, or the name is none for a folder), those of writing.
[[nodiscard]] base::Status make_skeleton(const std::filesystem::path& folder);

}  // namespace facet::teach
