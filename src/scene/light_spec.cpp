// Lights from text.
// SPDX-License-Identifier: MIT
#include "scene/light_spec.h"

#include "base/text.h"
#include "math/blackbody.h"
#include "scene/light_profile.h"
#include "scene/spec.h"
#include "tables/lights.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::scene {
namespace {

using tables::LightKind;

constexpr float default_lux = 3.0F;
constexpr float default_candela = 10.0F;
constexpr float default_nit = 10.0F;
constexpr float default_elevation_deg = 45.0F;
constexpr float least_flux = 1e-9F;  ///< lumen by candela: a cone of a thousandth of a degree

/// A number within the range of its row in tables/light_keys.def.
base::Result<float> number_of(std::string_view key, std::string_view value) {
    return parse_in_range(key, value, tables::light_key(key).range);
}

base::Status set_name(Light& light, std::string_view value) {
    light.name = value;
    return {};
}

base::Status set_color(Light& light, std::string_view value) {
    const auto color = parse_color("color", value, tables::light_key("color").range);
    if (!color) return tl::unexpected(color.error());
    light.color = *color;
    return {};
}

base::Status set_temperature(Light& light, std::string_view value) {
    const auto kelvin = number_of("temperature", value);
    if (!kelvin) return tl::unexpected(kelvin.error());
    light.color = math::blackbody_color(*kelvin);
    return {};
}

/// Lumen of a light of intensity 1.
float flux_per_intensity(const Light& light) {
    if (const float area = area_m2(light); area > 0.0F) return math::pi * area;  // physics: 10.3
    if (light.profile) return light.profile->flux_per_candela;
    if (light.kind != LightKind::spot) return 4.0F * math::pi;
    const float sine = std::sin(0.5F * light.outer_cone_rad);  // 1 - cos cancels for narrow cones
    return 4.0F * math::pi * sine * sine;
}

base::Status set_intensity(Light& light, std::string_view key, std::string_view value) {
    const auto number = number_of(key, value);
    if (!number) return tl::unexpected(number.error());
    light.intensity = *number;
    if (key != "lumen") return {};
    const float flux = flux_per_intensity(light);
    if (!(flux >= least_flux))
        return usage_error("lumen of a light that is too narrow to have any", value,
                           "give its candela");
    light.intensity = *number / flux;
    return {};
}

/// A file brings its own candela along.
base::Status set_file(Light& light, std::string_view value) {
    light.profile.reset();
    if (value.empty() || value == "none") return {};
    auto profile = read_profile(std::string(value));
    if (!profile) return tl::unexpected(profile.error());
    light.intensity = profile->candela;
    light.profile = std::make_shared<const LightProfile>(std::move(*profile));
    return {};
}

base::Status set_position(Light& light, std::string_view value) {
    const auto position = parse_vector("position", value, tables::light_key("position").range);
    if (!position) return tl::unexpected(position.error());
    light.position_m = *position;
    return {};
}

base::Status set_target(Light& light, std::string_view value) {
    const auto target = parse_vector("target", value, tables::light_key("target").range);
    if (!target) return tl::unexpected(target.error());
    const Vec3 way = *target - light.position_m;
    if (!(math::length(way) > 0.0F))
        return usage_error("target is the light's own position", value, "move one of them");
    light.direction = math::normalize(way);
    return {};
}

base::Status set_angle(Light& light, std::string_view key, std::string_view value) {
    const auto degrees = number_of(key, value);
    if (!degrees) return tl::unexpected(degrees.error());
    SkyAngles angles = sky_angles(light);
    (key == "azimuth" ? angles.azimuth_deg : angles.elevation_deg) = *degrees;
    // Straight above, a trace of the horizontal keeps the azimuth; cos(90 degrees) in float would
    // turn it around.
    constexpr float steepest_deg = 89.9999F;
    light.direction = -math::direction_from(
        angles.azimuth_deg, std::clamp(angles.elevation_deg, -steepest_deg, steepest_deg));
    return {};
}

base::Status set_cone(Light& light, std::string_view key, std::string_view value) {
    const auto degrees = number_of(key, value);
    if (!degrees) return tl::unexpected(degrees.error());
    (key == "inner" ? light.inner_cone_rad : light.outer_cone_rad) = glm::radians(*degrees);
    return {};
}

base::Status set_size(float& size_m, std::string_view key, std::string_view value) {
    const auto metres_long = number_of(key, value);
    if (!metres_long) return tl::unexpected(metres_long.error());
    size_m = *metres_long;
    return {};
}

base::Status set_width(Light& light, std::string_view value) {
    const auto degrees = number_of("angle", value);
    if (!degrees) return tl::unexpected(degrees.error());
    light.angle_rad = glm::radians(*degrees);
    return {};
}

base::Status set_range(Light& light, std::string_view value) {
    const auto range = number_of("range", value);
    if (!range) return tl::unexpected(range.error());
    light.range_m = *range;
    return {};
}

const tables::LightKindRow& row_of(LightKind kind) {
    return tables::light_kinds[static_cast<std::size_t>(kind)];
}

std::vector<std::string> keys_of(LightKind kind) {
    std::vector<std::string> out;
    for (const std::string_view key : base::split(row_of(kind).keys, ',')) out.emplace_back(key);
    return out;
}

base::Result<bool> switch_of(std::string_view key, std::string_view value) {
    if (value != "on" && value != "off")
        return usage_error(fmt::format("{} is neither on nor off", key), value, "on or off");
    return value == "on";
}

base::Status set_shadow(Light& light, std::string_view value) {
    const auto on = switch_of("shadow", value);
    if (!on) return tl::unexpected(on.error());
    light.casts_shadow = *on;
    return {};
}

base::Status set_visible(Light& light, std::string_view value) {
    const auto on = switch_of("visible", value);
    if (!on) return tl::unexpected(on.error());
    if (*on && !row_of(light.kind).area)
        return usage_error(
            fmt::format("{} lights have no shape that could be seen", row_of(light.kind).key),
            "visible=on", "one of sphere, rect, disk, tube has; or leave it out");
    light.is_visible = *on;
    return {};
}

base::Status check_cone(const Light& light) {
    if (light.kind != LightKind::spot || light.inner_cone_rad < light.outer_cone_rad) return {};
    return usage_error("inner is not below outer",
                       fmt::format("{:g} and {:g} degrees", glm::degrees(light.inner_cone_rad),
                                   glm::degrees(light.outer_cone_rad)),
                       "outer up to 90, inner from 0 to below outer");
}

base::Status set_unchecked(Light& light, std::string_view key, std::string_view value) {
    if (key == "visible") return set_visible(light, value);
    const auto keys = keys_of(light.kind);
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
        return usage_error(fmt::format("unknown key of a {} light", row_of(light.kind).key), key,
                           suggestion(key, keys));
    if (key == "name") return set_name(light, value);
    if (key == "color") return set_color(light, value);
    if (key == "temperature") return set_temperature(light, value);
    if (key == "file") return set_file(light, value);
    if (key == "position") return set_position(light, value);
    if (key == "target") return set_target(light, value);
    if (key == "azimuth" || key == "elevation") return set_angle(light, key, value);
    if (key == "inner" || key == "outer") return set_cone(light, key, value);
    if (key == "range") return set_range(light, value);
    if (key == "angle") return set_width(light, value);
    if (key == "shadow") return set_shadow(light, value);
    if (key == "radius") return set_size(light.radius_m, key, value);
    if (key == "width") return set_size(light.width_m, key, value);
    if (key == "height") return set_size(light.height_m, key, value);
    return set_intensity(light, key, value);
}

base::Result<LightKind> parse_kind(std::string_view name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < tables::light_kinds.size(); ++i) {
        if (tables::light_kinds[i].key == name) return static_cast<LightKind>(i);
        names.emplace_back(tables::light_kinds[i].key);
    }
    return usage_error("unknown kind of light", name, suggestion(name, names));
}

/// Values that others are reckoned from come first, whatever their order in the text.
std::size_t turn_of(const std::string& key) {
    constexpr std::array<std::string_view, 12> first = {
        "file",   "temperature", "color", "position", "azimuth", "elevation",
        "target", "inner",       "outer", "radius",   "width",   "height"};
    return static_cast<std::size_t>(std::find(first.begin(), first.end(), key) - first.begin());
}

Light initial_light(LightKind kind) {
    Light light;
    light.kind = kind;
    light.name = row_of(kind).key;
    light.intensity = kind == LightKind::directional ? default_lux
                      : row_of(kind).area            ? default_nit
                                                     : default_candela;
    light.direction = kind == LightKind::directional
                          ? -math::direction_from(0.0F, default_elevation_deg)
                          : Vec3(0.0F, -1.0F, 0.0F);
    return light;
}

bool has(const std::vector<KeyValue>& pairs, std::string_view key) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const KeyValue& kv) { return kv.key == key; });
}

base::Status check_combination(const std::vector<KeyValue>& pairs) {
    if (has(pairs, "candela") && has(pairs, "lumen"))
        return usage_error("candela and lumen both set the intensity", "candela, lumen",
                           "give one of them");
    if (has(pairs, "nit") && has(pairs, "lumen"))
        return usage_error("nit and lumen both set the radiance", "nit, lumen", "give one of them");
    if (has(pairs, "target") && (has(pairs, "azimuth") || has(pairs, "elevation")))
        return usage_error("target and angles both set the direction", "target, azimuth, elevation",
                           "give one of them");
    return {};
}

}  // namespace

SkyAngles sky_angles(const Light& light) {
    const Vec3 from = -light.direction;
    return {glm::degrees(std::atan2(from.x, from.z)),
            glm::degrees(std::asin(std::clamp(from.y, -1.0F, 1.0F)))};
}

base::Status set_light_key(Light& light, std::string_view key, std::string_view value) {
    Light changed = light;
    if (auto set = set_unchecked(changed, key, value); !set) return set;
    if (auto cone = check_cone(changed); !cone) return cone;
    light = std::move(changed);
    return {};
}

base::Result<Light> parse_light(const std::string& spec) {
    const std::size_t colon = spec.find(':');
    const auto kind = parse_kind(base::trimmed(std::string_view(spec).substr(0, colon)));
    if (!kind) return tl::unexpected(kind.error());
    auto pairs = parse_key_values(
        colon == std::string::npos ? "" : std::string_view(spec).substr(colon + 1));
    if (!pairs) return tl::unexpected(pairs.error());
    if (auto combination = check_combination(*pairs); !combination)
        return tl::unexpected(combination.error());
    std::stable_sort(pairs->begin(), pairs->end(), [](const KeyValue& a, const KeyValue& b) {
        return turn_of(a.key) < turn_of(b.key);
    });
    Light light = initial_light(*kind);
    Vec3 of_temperature(1.0F);
    for (const KeyValue& pair : *pairs) {
        if (auto set = set_unchecked(light, pair.key, pair.value); !set)
            return tl::unexpected(set.error());
        if (pair.key == "temperature") of_temperature = light.color;
        if (pair.key == "color") light.color *= of_temperature;
    }
    const bool aimed = has(*pairs, "target") || has(*pairs, "azimuth") || has(*pairs, "elevation");
    if (!aimed && math::length(light.position_m) > 0.0F)
        light.direction = -math::normalize(light.position_m);
    if (auto cone = check_cone(light); !cone) return tl::unexpected(cone.error());
    return light;
}

base::Result<std::string> with_light_file(
    const std::string& spec,
    const std::function<base::Result<std::string>(const std::string&)>& change) {
    const std::size_t colon = spec.find(':');
    if (colon == std::string::npos) return spec;
    std::string out = spec.substr(0, colon);
    char mark = ':';
    for (const std::string_view pair : base::split(std::string_view(spec).substr(colon + 1), ',')) {
        const std::size_t equals = pair.find('=');
        out += mark;
        mark = ',';
        if (equals == std::string_view::npos || base::trimmed(pair.substr(0, equals)) != "file") {
            out += pair;
            continue;
        }
        const auto changed = change(std::string(base::trimmed(pair.substr(equals + 1))));
        if (!changed) return changed;
        out += "file=" + *changed;
    }
    return out;
}

std::string light_key_text(const Light& light, std::string_view key) {
    const auto number = [](float x) { return fmt::format("{}", x); };
    const auto vector = [](const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    if (key == "name") return light.name;
    if (key == "color") return vector(light.color);
    if (key == "file") return light.profile ? light.profile->file : std::string();
    if (key == "position") return vector(light.position_m);
    if (key == "target") return vector(light.position_m + light.direction);
    if (key == "azimuth") return number(sky_angles(light).azimuth_deg);
    if (key == "elevation") return number(sky_angles(light).elevation_deg);
    if (key == "inner") return number(glm::degrees(light.inner_cone_rad));
    if (key == "outer") return number(glm::degrees(light.outer_cone_rad));
    if (key == "range") return number(light.range_m);
    if (key == "angle") return number(glm::degrees(light.angle_rad));
    if (key == "radius") return number(light.radius_m);
    if (key == "width") return number(light.width_m);
    if (key == "height") return number(light.height_m);
    if (key == "shadow") return light.casts_shadow ? "on" : "off";
    if (key == "visible") return light.is_visible ? "on" : "off";
    if (key == "lumen") return number(light.intensity * flux_per_intensity(light));
    return key == row_of(light.kind).unit ? number(light.intensity) : std::string();
}

}  // namespace facet::scene
