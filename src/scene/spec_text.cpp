// What --light, --set and --camera share: vectors, colours and bounded numbers as text, and their
// errors. SPDX-License-Identifier: MIT
#include "scene/spec_text.h"

#include "base/text.h"
#include "math/color.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <vector>

namespace facet::scene {
namespace {

using math::Vec3;

constexpr std::size_t longest_list = 260;  // bytes; an error stays one readable line

bool is_within(double number, tables::Range range) {
    return number >= range.low && number <= range.high;
}

/// The colour of `rrggbb`.
std::optional<Vec3> parse_hex(std::string_view digits) {
    if (digits.size() != 6) return std::nullopt;
    Vec3 color;
    for (int i = 0; i < 3; ++i) {
        const char* const first = digits.data() + 2 * i;
        unsigned level = 0;
        const auto [end, error] = std::from_chars(first, first + 2, level, 16);
        if (error != std::errc{} || end != first + 2) return std::nullopt;
        color[i] = math::linear_from_srgb(static_cast<float>(level) / 255.0F);
    }
    return color;
}

}  // namespace

tl::unexpected<base::Error> usage(std::string what, std::string_view found, std::string remedy) {
    return base::fail({.code = base::ErrorCode::usage,
                       .what = std::move(what),
                       .found = std::string(found),
                       .remedy = std::move(remedy)});
}

std::string offer(std::string_view name, std::span<const std::string> names) {
    const std::vector<std::string> close = base::nearest(name, names);
    std::string out = close.empty() ? "" : "did you mean " + base::join(close, " or ") + "; ";
    out += "one of ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string next = base::escaped(names[i], 60);
        if (i > 0 && out.size() + next.size() > longest_list)
            return out + fmt::format(" and {} more", names.size() - i);
        out += (i > 0 ? ", " : "") + next;
    }
    return out;
}

std::optional<Vec3> parse_vector(std::string_view text, tables::Range range) {
    Vec3 v;
    int filled = 0;
    for (const std::string_view part : base::split(text, ' ')) {
        if (part.empty()) continue;
        const auto number = base::parse_number(part);
        if (!number || !is_within(*number, range) || filled == 3) return std::nullopt;
        v[filled++] = static_cast<float>(*number);
    }
    return filled == 3 ? std::optional(v) : std::nullopt;
}

base::Result<float> parse_bounded(std::string_view key, std::string_view text, tables::Range range,
                                  std::string_view unit) {
    const std::string_view in_unit = unit.empty() ? "" : " ";
    const std::string allowed = fmt::format("{} to {}{}{}", range.low, range.high, in_unit, unit);
    const auto number = base::parse_number(base::trimmed(text));
    if (!number) return usage(fmt::format("{} is not a number", key), text, "give " + allowed);
    if (!is_within(*number, range))
        return usage(fmt::format("{} is out of range", key), text, "give " + allowed);
    return static_cast<float>(*number);
}

base::Result<Vec3> parse_color(std::string_view key, std::string_view text, tables::Range range) {
    const std::string_view value = base::trimmed(text);
    const auto color =
        value.starts_with('#') ? parse_hex(value.substr(1)) : parse_vector(value, range);
    if (color) return *color;
    return usage(
        fmt::format("{} is not a colour", key), text,
        fmt::format("give #rrggbb, or linear \"r g b\" of {} to {}", range.low, range.high));
}

}  // namespace facet::scene
