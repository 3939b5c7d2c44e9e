// Outputs: refused early, for a reason that can be read.
// SPDX-License-Identifier: MIT
#include "cli/output_gate.h"

#include "base/file.h"
#include "base/text.h"

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

std::string ending_of(const fs::path& output) {
    std::string ending = output.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

base::Status check_ending(const fs::path& output) {
    if (format_of(output)) return {};
    std::vector<std::string> known;
    for (const auto& row : tables::image_formats)
        if (row.writes)
            for (const std::string_view ending : base::split(row.endings, ','))
                known.push_back(fmt::format(".{}", ending));
    const std::string ending = ending_of(output);
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

std::optional<tables::ImageFormat> format_of(const fs::path& output) {
    const std::string ending = ending_of(output);
    for (std::size_t i = 0; i < tables::image_formats.size(); ++i) {
        const auto& row = tables::image_formats[i];
        if (!row.writes || ending.empty()) continue;
        const auto endings = base::split(row.endings, ',');
        if (std::ranges::find(endings, std::string_view(ending).substr(1)) != endings.end())
            return static_cast<tables::ImageFormat>(i);
    }
    return std::nullopt;
}

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
