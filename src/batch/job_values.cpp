// What stands for a key in a job file.
// SPDX-License-Identifier: MIT
#include "batch/job_values.h"

#include "base/json.h"
#include "base/text.h"
#include "scene/load.h"
#include "tables/lights.h"
#include "tables/material.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace facet::batch {
namespace {

constexpr double most_values = 1e6;  // of one list that is written out
constexpr double golden_angle_deg = 180.0 * (3.0 - 2.23606797749978969641);

tl::unexpected<base::Error> refuse(std::string where, std::string what, const Json& found,
                                   std::string remedy = {}) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = std::move(where),
                       .what = std::move(what),
                       .found = text_of(found),
                       .remedy = std::move(remedy)});
}

bool all_are(const Json& array, bool (Json::*is)() const) {
    return std::ranges::all_of(array, [&](const Json& value) { return (value.*is)(); });
}
bool is_number(const Json& value) { return value.is_number(); }
bool all_numbers(const Json& array) { return std::ranges::all_of(array, is_number); }

/// Whether a path of `set` takes x y z or a colour.
bool takes_vector(std::string_view path) {
    std::string key(path.substr(path.rfind('.') + 1));
    std::ranges::replace(key, '-', '_');
    for (const tables::LightKeyRow& row : tables::light_keys)
        if (path.starts_with("light") && row.key == key)
            return row.type == tables::LightKeyType::vector ||
                   row.type == tables::LightKeyType::color;
    for (const tables::MaterialParam& row : tables::material_params)
        if (row.key == key)
            return std::holds_alternative<tables::Color tables::MaterialValues::*>(row.field);
    return false;
}

const tables::Setting* setting_named(std::string_view key) {
    for (const tables::Setting& row : tables::settings)
        if (row.key == key) return &row;
    return nullptr;
}

/// Whether an array is one value of this key.
bool is_one_value(const Given& given, const Json& array) {
    if (given.kind == AxisKind::path)
        return takes_vector(given.key) && array.size() == 3 && all_numbers(array);
    const tables::Setting* const row = setting_named(given.key);
    if (given.kind != AxisKind::setting || row == nullptr) return false;
    if (std::holds_alternative<tables::Extent tables::Settings::*>(row->field))
        return array.size() == 2 && all_numbers(array);
    return std::holds_alternative<tables::List tables::Settings::*>(row->field) &&
           all_are(array, &Json::is_string);
}

/// splitmix64 (Steele, Lea and Flood 2014): every index its own number, in any order.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

/// Uniform in [0, 1), by seed, key, index and component.
double uniform(const Draw& draw, std::size_t index, std::size_t component) {
    std::uint64_t state = mixed(draw.seed);
    for (const char c : draw.key) state = mixed(state ^ static_cast<unsigned char>(c));
    state = mixed(state ^ mixed(index) ^ (mixed(component) << 1U));
    return static_cast<double>(state >> 11U) * 0x1.0p-53;
}

bool is_range(const Json& from) {
    return from.is_array() && from.size() == 2 && all_numbers(from) &&
           from[0].get<double>() <= from[1].get<double>();
}

/// Two vectors of three, low and high.
bool is_vector_range(const Json& from) {
    const auto is_vector = [](const Json& v) {
        return v.is_array() && v.size() == 3 && all_numbers(v);
    };
    return from.is_array() && from.size() == 2 && std::ranges::all_of(from, is_vector);
}

bool is_choice(const Json& from) {
    return from.is_array() && !from.empty() && all_are(from, &Json::is_string);
}

/// A member that is a whole number within [low, high]; `otherwise` where it is not there.
base::Result<std::uint64_t> whole(const Json& object, const char* key, std::uint64_t otherwise,
                                  double low, double high, const std::string& pointer) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    if (!found->is_number_integer() || found->get<double>() < low || found->get<double>() > high)
        return refuse(pointer + "/" + key,
                      fmt::format("takes a whole number from {:.0f} to {:.0f}", low, high), *found);
    return found->get<std::uint64_t>();
}

base::Status check_keys(const Json& object, std::initializer_list<const char*> known,
                        const std::string& pointer) {
    const std::vector<std::string> names(known.begin(), known.end());
    for (const auto& [key, value] : object.items())
        if (std::ranges::find(names, key) == names.end())
            return base::fail({.code = base::ErrorCode::input_invalid,
                               .where = pointer + "/" + base::pointer_key(key),
                               .what = "unknown key",
                               .found = key,
                               .remedy = base::suggestion(key, names)});
    return {};
}

base::Result<OneOrMore> random_values(const Given& given) {
    const Json& object = *given.value;
    if (auto known = check_keys(object, {"random", "count", "seed"}, given.pointer); !known)
        return tl::unexpected(known.error());
    Draw draw{.kind = given.kind, .key = given.key, .from = object.at("random")};
    if (!is_range(draw.from) && !is_vector_range(draw.from) && !is_choice(draw.from))
        return refuse(given.pointer + "/random",
                      "is neither [low, high], two vectors, nor a list of texts", draw.from);
    const auto seed = whole(object, "seed", 0, 0, 9007199254740992.0, given.pointer);
    if (!seed) return tl::unexpected(seed.error());
    const auto count = whole(object, "count", 0, 1, most_values, given.pointer);
    if (!count) return tl::unexpected(count.error());
    draw.seed = *seed;
    if (*count == 0) return OneOrMore(std::move(draw));
    Axis axis{.kind = given.kind, .key = given.key, .pointer = given.pointer};
    for (std::size_t i = 0; i < *count; ++i) axis.values.push_back(drawn(draw, i));
    return OneOrMore(std::move(axis));
}

/// Eyes spread evenly over a sphere, or its belt between two elevations: a Fibonacci lattice
/// (González 2010, "Measurement of areas on a sphere").
base::Result<OneOrMore> sphere_cameras(const Given& given) {
    const Json& object = *given.value;
    if (auto known =
            check_keys(object, {"sphere", "elevation", "distance", "target"}, given.pointer);
        !known)
        return tl::unexpected(known.error());
    const auto count = whole(object, "sphere", 0, 1, most_values, given.pointer);
    if (!count) return tl::unexpected(count.error());
    double low_deg = -90.0;
    double high_deg = 90.0;
    if (const auto belt = object.find("elevation"); belt != object.end()) {
        if (!is_range(*belt) || (*belt)[0] < -90.0 || (*belt)[1] > 90.0)
            return refuse(given.pointer + "/elevation", "takes [low, high] in degrees", *belt);
        low_deg = (*belt)[0].get<double>();
        high_deg = (*belt)[1].get<double>();
    }
    std::string rest = ",fit=sphere";
    if (const auto distance = object.find("distance"); distance != object.end()) {
        if (!distance->is_number() || *distance <= 0.0)
            return refuse(given.pointer + "/distance", "takes metres above 0", *distance);
        rest = fmt::format(",distance={}", distance->get<double>());
    }
    if (const auto target = object.find("target"); target != object.end()) {
        if (!target->is_array() || target->size() != 3 || !all_numbers(*target))
            return refuse(given.pointer + "/target", "takes [x, y, z] in metres", *target);
        rest += fmt::format(",target={} {} {}", (*target)[0].get<double>(),
                            (*target)[1].get<double>(), (*target)[2].get<double>());
    }
    constexpr double degrees = 180.0 / std::numbers::pi;
    const double low = std::sin(low_deg / degrees);
    const double high = std::sin(high_deg / degrees);
    Axis axis{.kind = given.kind, .key = given.key, .pointer = given.pointer};
    const std::size_t digits = fmt::format("{}", *count - 1).size();
    for (std::size_t i = 0; i < *count; ++i) {
        const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(*count);
        const double azimuth = std::fmod(static_cast<double>(i) * golden_angle_deg, 360.0);
        axis.values.emplace_back(fmt::format("orbit:azimuth={:.4f},elevation={:.4f}{}", azimuth,
                                             std::asin(low + (high - low) * place) * degrees,
                                             rest));
        axis.labels.push_back(fmt::format("{:0{}}", i, digits));
    }
    return OneOrMore(std::move(axis));
}

}  // namespace

base::Result<OneOrMore> sort_out(const Given& given) {
    const Json& value = *given.value;
    if (value.is_object()) {
        const bool is_camera = given.kind == AxisKind::setting && given.key == "camera";
        auto values = value.contains("random")                ? random_values(given)
                      : is_camera && value.contains("sphere") ? sphere_cameras(given)
                      : given.key == "set"
                          ? base::Result<OneOrMore>(value)
                          : refuse(given.pointer, "takes no object", value,
                                   "a value, a list, or {\"random\": [low, high]}");
        if (!values) return values;
        if (auto* axis = std::get_if<Axis>(&*values); axis != nullptr && axis->labels.empty())
            for (const Json& one : axis->values)
                axis->labels.push_back(label_of(given.kind, given.key, one));
        return values;
    }
    if (!value.is_array() || is_one_value(given, value)) return OneOrMore(value);
    Axis axis{.kind = given.kind, .key = given.key, .pointer = given.pointer};
    for (const Json& one : value) {
        axis.values.push_back(one);
        axis.labels.push_back(label_of(given.kind, given.key, one));
    }
    return OneOrMore(std::move(axis));
}

std::string label_of(AxisKind kind, std::string_view key, const Json& value) {
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        return kind == AxisKind::scene ? scene::stem_of(text) : text;
    }
    if (value.is_number_float()) return fmt::format("{}", value.get<double>());
    if (!value.is_array()) return text_of(value);
    std::string out;
    for (const Json& part : value) {
        if (!out.empty()) out += key == "size" ? "x" : " ";
        out += label_of(AxisKind::setting, key, part);
    }
    return out;
}

Json drawn(const Draw& draw, std::size_t index) {
    const Json& from = draw.from;
    const auto between = [&](const Json& low, const Json& high, std::size_t component) {
        const double u = uniform(draw, index, component);
        const double a = low.get<double>();
        const double b = high.get<double>();
        return static_cast<double>(static_cast<float>(a + (b - a) * u));
    };
    if (is_choice(from)) {
        const double place = uniform(draw, index, 0) * static_cast<double>(from.size());
        return from[static_cast<std::size_t>(place)];
    }
    if (!is_range(from))
        return {between(from[0][0], from[1][0], 0), between(from[0][1], from[1][1], 1),
                between(from[0][2], from[1][2], 2)};
    const tables::Setting* const row =
        draw.kind == AxisKind::setting ? setting_named(draw.key) : nullptr;
    if (row != nullptr && std::holds_alternative<tables::Count tables::Settings::*>(row->field)) {
        const auto low = from[0].get<std::int64_t>();
        const auto span = static_cast<double>(from[1].get<std::int64_t>() - low + 1);
        return low + static_cast<std::int64_t>(uniform(draw, index, 0) * span);
    }
    return between(from[0], from[1], 0);
}

}  // namespace facet::batch
