// The settings of a picture as options.
// SPDX-License-Identifier: MIT
#include "cli/setting_flags.h"

#include "base/text.h"
#include "tables/settings_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace facet::cli {
namespace {

using tables::Setting;
using tables::Settings;

std::string variable_name(const Setting& row) {
    std::string name = "FACET_";
    for (const char c : row.key)
        name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}
bool has_variable(const Setting& row) { return row.group == "Machine"; }

}  // namespace

void TypedSettings::declare(std::vector<Flag>& flags,
                            const std::function<bool(const Setting&)>& wanted) {
    for (std::size_t i = 0; i < tables::settings.size(); ++i) {
        const Setting& row = tables::settings[i];
        if (wanted && !wanted(row)) continue;
        Flag flag{.names = tables::flag_name(row.key),
                  .target = &texts[i],
                  .value = std::string(row.value),
                  .group = std::string(row.group),
                  .help = std::string(row.help),
                  .rare = row.rare};
        if (std::holds_alternative<tables::Flag Settings::*>(row.field)) flag.target = &switches[i];
        flags.push_back(std::move(flag));
    }
}

base::Result<Settings> TypedSettings::read() const {
    Settings settings;
    for (std::size_t i = 0; i < tables::settings.size(); ++i) {
        const Setting& row = tables::settings[i];
        std::vector<std::string> given = texts[i];
        if (switches[i]) given = {"1"};
        const std::string variable = variable_name(row);
        const char* set =
            has_variable(row) && given.empty() ? std::getenv(variable.c_str()) : nullptr;
        if (set != nullptr && *set != '\0') given = {set};
        if (auto read = tables::assign(settings, row, given); !read) {
            base::Error error = read.error();
            if (set != nullptr) error.file = variable;
            return base::fail(std::move(error));
        }
    }
    return settings;
}

base::Warnings unknown_environment(char** environment) {
    std::vector<std::string> known{"FACET_CACHE"};
    for (const Setting& row : tables::settings)
        if (has_variable(row)) known.push_back(variable_name(row));
    base::Warnings warnings;
    for (char** entry = environment; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const std::string_view name = text.substr(0, text.find('='));
        if (!name.starts_with("FACET_") || std::ranges::find(known, name) != known.end()) continue;
        const auto close = base::nearest(name, known);
        warnings.push_back(
            {.file = std::string(name),
             .what = "this environment variable is ignored",
             .remedy = close.empty() ? "" : "did you mean " + base::join(close, ", ")});
    }
    return warnings;
}

}  // namespace facet::cli
