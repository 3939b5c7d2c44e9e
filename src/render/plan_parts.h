// Steps of make_plan() in files of their own, and what all its steps say mistakes with.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/text.h"
#include "render/plan.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::render {

[[nodiscard]] inline tl::unexpected<base::Error> usage(std::string option, std::string what,
                                                       std::string found, std::string remedy) {
    return base::fail({.code = base::ErrorCode::usage,
                       .file = std::move(option),
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = std::move(remedy)});
}

/// Index of `text` among `names`.
[[nodiscard]] inline base::Result<std::size_t> choose(const char* option, std::string_view text,
                                                      std::span<const std::string> names) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return i;
    return usage(option, "no such value", std::string(text), base::suggestion(text, names));
}

template <class Rows>
[[nodiscard]] std::vector<std::string> keys(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(row.key);
    return names;
}

/// Errors of all: usage, naming the option.
[[nodiscard]] base::Status plan_camera(const tables::Settings& settings, Plan& plan);
[[nodiscard]] base::Status plan_exposure(const tables::Settings& settings, Plan& plan);
[[nodiscard]] base::Status plan_probe(const tables::Settings& settings, Plan& plan);
[[nodiscard]] base::Status plan_gamut(const tables::Settings& settings, Plan& plan);
/// After all that it depends on. Errors: feature_missing too.
[[nodiscard]] base::Status plan_resampling(const tables::Settings& settings, Plan& plan);

}  // namespace facet::render
