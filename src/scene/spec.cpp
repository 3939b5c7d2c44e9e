// The small language of options.
// SPDX-License-Identifier: MIT
#include "scene/spec.h"

#include "base/text.h"
#include "math/color.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::scene {
namespace {

using math::Vec3;

constexpr std::size_t most_names_listed = 20;

std::string text_of(const tables::Range& range) {
    return fmt::format("{:g} to {:g}", range.low, range.high);
}

/// Three numbers with spaces between.
std::optional<std::array<double, 3>> three_numbers(std::string_view text) {
    std::array<double, 3> out{};
    std::size_t filled = 0;
    for (const std::string_view part : base::split(text, ' ')) {
        if (part.empty()) continue;
        const auto number = base::parse_number(part);
        if (!number || filled == out.size()) return std::nullopt;
        out[filled++] = *number;
    }
    return filled == out.size() ? std::optional(out) : std::nullopt;
}

bool contains(const tables::Range& range, double x) { return x >= range.low && x <= range.high; }

/// Linear colour of the six hexadecimal digits of `#rrggbb`.
std::optional<Vec3> hexadecimal_color(std::string_view digits) {
    if (digits.size() != 6) return std::nullopt;
    Vec3 out;
    for (int c = 0; c < 3; ++c) {
        int byte = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const char digit = digits[static_cast<std::size_t>(c) * 2 + i];
            const auto place =
                std::string_view("0123456789abcdef")
                    .find(digit >= 'A' && digit <= 'F' ? static_cast<char>(digit - 'A' + 'a')
                                                       : digit);
            if (place == std::string_view::npos) return std::nullopt;
            byte = byte * 16 + static_cast<int>(place);
        }
        out[c] = math::linear_from_srgb(static_cast<float>(byte) / 255.0F);
    }
    return out;
}

}  // namespace

tl::unexpected<base::Error> usage_error(std::string what, std::string_view found,
                                        std::string remedy) {
    return base::fail({.code = base::ErrorCode::usage,
                       .file = {},
                       .where = {},
                       .what = std::move(what),
                       .found = std::string(found),
                       .remedy = std::move(remedy)});
}

base::Result<std::vector<KeyValue>> parse_key_values(std::string_view text) {
    std::vector<KeyValue> out;
    for (const std::string_view part : base::split(text, ',')) {
        if (base::trimmed(part).empty()) continue;
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos)
            return usage_error("not key=value", base::trimmed(part),
                               "write key=value,key=value, and vectors as \"x y z\"");
        std::string key(base::trimmed(part.substr(0, equals)));
        std::replace(key.begin(), key.end(), '-', '_');
        const bool again =
            std::any_of(out.begin(), out.end(), [&](const KeyValue& kv) { return kv.key == key; });
        if (again) return usage_error("key stands twice", key, "give it once");
        out.push_back({std::move(key), std::string(base::trimmed(part.substr(equals + 1)))});
    }
    return out;
}

base::Result<float> parse_in_range(std::string_view key, std::string_view value,
                                   const tables::Range& range) {
    const auto number = base::parse_number(base::trimmed(value));
    if (!number)
        return usage_error(fmt::format("{} is not a number", key), value,
                           "a number from " + text_of(range));
    if (!contains(range, *number))
        return usage_error(fmt::format("{} is out of range", key), value,
                           "a number from " + text_of(range));
    return static_cast<float>(*number);
}

base::Result<Vec3> parse_vector(std::string_view key, std::string_view value,
                                const tables::Range& range) {
    const auto numbers = three_numbers(value);
    if (!numbers)
        return usage_error(fmt::format("{} is not x y z", key), value,
                           "three numbers with spaces, as 0 1.5 -2");
    if (!std::all_of(numbers->begin(), numbers->end(),
                     [&](double x) { return contains(range, x); }))
        return usage_error(fmt::format("{} is out of range", key), value,
                           "numbers from " + text_of(range));
    return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

base::Result<Vec3> parse_color(std::string_view key, std::string_view value,
                               const tables::Range& range) {
    const std::string_view text = base::trimmed(value);
    if (text.starts_with('#')) {
        const auto color = hexadecimal_color(text.substr(1));
        if (!color)
            return usage_error(fmt::format("{} is not a colour", key), value,
                               "#rrggbb, or linear r g b");
        return *color;
    }
    const auto numbers = three_numbers(text);
    if (!numbers)
        return usage_error(fmt::format("{} is not a colour", key), value,
                           "#rrggbb, or linear r g b");
    if (!std::all_of(numbers->begin(), numbers->end(),
                     [&](double x) { return contains(range, x); }))
        return usage_error(fmt::format("{} is out of range", key), value,
                           "numbers from " + text_of(range));
    return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::string suggestion(std::string_view name, std::span<const std::string> names) {
    std::vector<std::string> shown;
    for (const std::string& each : names.first(std::min(names.size(), most_names_listed)))
        shown.push_back(base::escaped(each));
    std::string list = "there is " + base::join(shown, ", ");
    if (names.size() > shown.size())
        list += fmt::format(" and {} more", names.size() - shown.size());
    std::vector<std::string> near = base::nearest(name, names);
    if (near.empty()) return list;
    for (std::string& each : near) each = base::escaped(each);
    return "did you mean " + base::join(near, ", ") + "? " + list;
}

}  // namespace facet::scene
