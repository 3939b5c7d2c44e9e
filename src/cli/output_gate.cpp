// Outputs: refused early, for a reason that can be read.
// SPDX-License-Identifier: MIT
#include "cli/output_gate.h"

#include "base/file.h"
#include "base/text.h"
#include "tables/image_formats.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <vector>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::fail;

std::vector<std::string> writable_endings() {
    std::vector<std::string> endings;
    for (const auto& row : tables::image_formats)
        if (row.writes)
            for (const std::string_view ending : base::split(row.endings, ','))
                endings.push_back(fmt::format(".{}", ending));
    return endings;
}

base::Status check_ending(const fs::path& output) {
    std::string ending = output.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto known = writable_endings();
    if (std::ranges::find(known, ending) != known.end()) return {};
    return fail(
        {.code = ErrorCode::usage,
         .file = output.string(),
         .what = ending.empty() ? "has no ending that names a format" : "no format has this ending",
         .found = ending,
         .remedy = "endings: " + base::join(known, " ")});
}

base::Status check_not_input(const fs::path& output, std::span<const std::string> inputs) {
    std::error_code error;
    for (const std::string& input : inputs)
        if (fs::exists(input, error) && fs::equivalent(output, input, error) && !error)
            return fail({.code = ErrorCode::usage,
                         .file = output.string(),
                         .what = "is an input too",
                         .found = input,
                         .remedy = "choose another output"});
    return {};
}

}  // namespace

base::Status check_output(const fs::path& output, const OutputRules& rules,
                          std::span<const std::string> inputs) {
    if (auto ending = check_ending(output); !ending) return ending;
    std::error_code error;
    if (rules.make_folders && output.has_parent_path()) {
        fs::create_directories(output.parent_path(), error);
        if (error)
            return fail({.code = ErrorCode::input_invalid,
                         .file = output.parent_path().string(),
                         .what = "cannot be made: " + error.message()});
    }
    if (auto writable = base::check_writable(output); !writable) return writable;
    if (!fs::exists(output, error)) return {};
    if (rules.keep_existing)
        return fail({.code = ErrorCode::usage,
                     .file = output.string(),
                     .what = "is there already",
                     .remedy = "leave out --no-clobber to replace it"});
    return check_not_input(output, inputs);
}

}  // namespace facet::cli
