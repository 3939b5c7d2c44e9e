// The settings of a picture as the texts that a command line, a job file or a script has for them.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace facet::tables {

/// `--env-rotation` for `env_rotation`.
[[nodiscard]] std::string flag_name(std::string_view key);

/// The words that a setting is one of; none where it takes anything else.
[[nodiscard]] std::vector<std::string> choices(const Setting& row);

/// Reads `texts` into the field of one row; nothing where there are none. A flag is "0" or "1".
/// Errors: usage (what), limit_reached (a picture too large).
[[nodiscard]] base::Status assign(Settings& values, const Setting& row,
                                  const std::vector<std::string>& texts);
/// The same by the row's key. Errors: likewise, and usage with the nearest keys.
[[nodiscard]] base::Status assign(Settings& values, std::string_view key,
                                  const std::vector<std::string>& texts);

/// What assign() would read to have a field as it is: none where it is as it was initially.
[[nodiscard]] std::vector<std::string> texts_of(const Settings& values, const Setting& row);

/// The words of `facet COMMAND SCENE` that ask for these settings; `output` empty: without -o.
[[nodiscard]] std::vector<std::string> command_words(std::string_view command,
                                                     const std::string& scene,
                                                     const Settings& values,
                                                     const std::string& output);
/// `facet` and the words, as a shell takes them.
[[nodiscard]] std::string command_line(const std::vector<std::string>& words);

}  // namespace facet::tables
