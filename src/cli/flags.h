// What a command declares: its options and arguments as plain values, and the job they are for.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io.h"
#include "tables/describe.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace facet::cli {

/// A number that an option takes, with its allowed range.
struct BoundedNumber {
    std::optional<double>* number = nullptr;
    tables::Range range;
};

/// One option or argument of a command. What it points to must live as long as the command.
struct Flag {
    std::string names;  ///< "-o,--output"; an argument has no dash: "SCENE"
    std::variant<bool*, std::string*, std::vector<std::string>*, BoundedNumber> target;
    std::string value;  ///< what stands for the value in help; empty for a switch
    std::string group;  ///< heading in help
    std::string help;
    bool rare = false;  ///< left out of --help

    [[nodiscard]] bool is_argument() const { return !names.starts_with('-'); }
    /// The long name, dashes included; the name itself for an argument.
    [[nodiscard]] std::string_view long_name() const {
        const std::size_t comma = names.find(',');
        return std::string_view(names).substr(comma == std::string::npos ? 0 : comma + 1);
    }
};

/// A command as it declares itself. Options that are not given leave their targets alone.
struct Declaration {
    std::vector<Flag> flags;
    Job job;
};

}  // namespace facet::cli
