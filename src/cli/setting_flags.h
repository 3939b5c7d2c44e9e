// The settings of a picture as options: one flag a row of tables/settings.def.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "cli/flags.h"
#include "tables/settings.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace facet::cli {

/// What was typed for each row of tables::settings, before it is read.
struct TypedSettings {
    std::array<std::vector<std::string>, tables::settings.size()> texts;
    std::array<bool, tables::settings.size()> switches{};

    /// One flag for each row that `wanted` takes (null: all); they point into this object.
    void declare(std::vector<Flag>& flags,
                 const std::function<bool(const tables::Setting&)>& wanted = {});
    /// The settings, starting from the initial values. Environment variables FACET_THREADS and the
    /// like stand in for rows of the group "Machine" that were not typed. Errors: usage, naming the
    /// flag, the value and what it takes.
    [[nodiscard]] base::Result<tables::Settings> read() const;
};

/// A warning for each variable FACET_* of the environment that nothing reads, with the nearest
/// right name.
[[nodiscard]] base::Warnings unknown_environment(char** environment);

}  // namespace facet::cli
