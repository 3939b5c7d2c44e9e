// Environments: read from a lat-long picture, or computed.
// SPDX-License-Identifier: MIT
#include "scene/environment.h"

#include "base/file.h"
#include "base/text.h"
#include "image/read.h"
#include "scene/environment_models.h"
#include "scene/environment_paint.h"
#include "scene/spec.h"
#include "tables/environments.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace facet::scene {
namespace {

using base::ErrorCode;
using image::Image;
using math::Vec3;

constexpr math::Extent detailed{1024, 512};
constexpr math::Extent uniform{16, 8};
constexpr float sun_radius_rad =
    0.5F * math::pi / 180.0F;  // of the disc drawn; the real one is less than a pixel

base::Result<SkyParameters> parse_sky(std::string_view text) {
    SkyParameters sky;
    struct Key {
        std::string_view name;
        float* number;
        tables::Range range;
    };
    const std::array<Key, 4> keys = {{{"sun_elevation", &sky.sun_elevation_deg, {0.0, 90.0}},
                                      {"sun_azimuth", &sky.sun_azimuth_deg, {-3600.0, 3600.0}},
                                      {"turbidity", &sky.turbidity, {1.9, 10.0}},
                                      {"ground_albedo", &sky.ground_albedo, {0.0, 1.0}}}};
    const auto pairs = parse_key_values(text);
    if (!pairs) return tl::unexpected(pairs.error());
    for (const KeyValue& pair : *pairs) {
        const auto key = std::find_if(keys.begin(), keys.end(),
                                      [&](const Key& k) { return k.name == pair.key; });
        if (key == keys.end()) {
            std::vector<std::string> names;
            for (const Key& each : keys) names.emplace_back(each.name);
            return usage_error("unknown key of sky", pair.key, suggestion(pair.key, names));
        }
        const auto number = parse_in_range(pair.key, pair.value, key->range);
        if (!number) return tl::unexpected(number.error());
        *key->number = *number;
    }
    return sky;
}

base::Result<Image> compute(tables::EnvironmentKind kind, std::string_view parameters,
                            base::ThreadPool& pool) {
    switch (kind) {
        case tables::EnvironmentKind::studio: {
            const Studio studio;
            return paint(LatLong(detailed), pool, [&](float y) {
                return
                    [&, room = Studio::room(y)](const Vec3& d) { return room + studio.boxes(d); };
            });
        }
        case tables::EnvironmentKind::overcast:
            return paint(LatLong({256, 128}), pool, [](float y) {
                return [nit = overcast_radiance(y)](const Vec3&) { return nit; };
            });
        case tables::EnvironmentKind::furnace:
            return paint(LatLong(uniform), pool,
                         [](float) { return [](const Vec3&) { return Vec3(1.0F); }; });
        case tables::EnvironmentKind::black:
            return Image(uniform, 3, image::Sample::f32);
        case tables::EnvironmentKind::sky:
            break;
    }
    const auto parsed = parse_sky(parameters);
    if (!parsed) return tl::unexpected(parsed.error());
    const Sky sky(*parsed);
    const LatLong map(detailed);
    Image picture = paint(map, pool, [&](float y) {
        return [&, row = sky.row(y)](const Vec3& d) { return sky.radiance(row, d); };
    });
    add_disc(picture, map, sky.to_sun(), sun_radius_rad, sky.sun_illuminance_lux());
    return picture;
}

/// A picture file as RGB radiance.
base::Result<Image> read(const std::string& path, const base::Limits& limits,
                         base::Warnings& warnings) {
    const auto bytes = base::read_file(path, limits.file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto decoded = image::decode(*bytes, limits, warnings);
    if (!decoded) return tl::unexpected(base::in_file(decoded.error(), path));
    if (decoded->sample != image::Sample::f32)
        return base::fail({.code = ErrorCode::input_invalid,
                           .file = path,
                           .what = "not a high dynamic range picture",
                           .remedy = "an environment is a lat-long .hdr or .exr"});
    if (decoded->size.width != 2 * decoded->size.height)
        warnings.push_back(
            {.file = path,
             .what = "an environment is twice as wide as high; this one is stretched",
             .found = fmt::format("{}x{}", decoded->size.width, decoded->size.height)});
    const auto values = std::as_const(*decoded).as<float>();
    if (std::all_of(values.begin(), values.end(), [](float x) { return x == 0.0F; }))
        warnings.push_back({.file = path, .what = "the environment is black and lights nothing"});
    if (decoded->channels == 3) return decoded;
    Image rgb(decoded->size, 3, image::Sample::f32);
    const auto to = rgb.as<float>();
    const std::size_t channels = decoded->channels;
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = values[i / 3 * channels + (channels >= 3 ? i % 3 : 0)];
    return rgb;
}

/// The kind whose name stands before a colon.
std::optional<tables::EnvironmentKind> kind_named(std::string_view name) {
    for (std::size_t i = 0; i < tables::environments.size(); ++i)
        if (tables::environments[i].key == name) return static_cast<tables::EnvironmentKind>(i);
    return std::nullopt;
}

/// A computed environment; `spec` begins with the name of one.
base::Result<Image> compute(const std::string& spec, base::ThreadPool& pool) {
    const std::size_t colon = spec.find(':');
    const auto kind = *kind_named(spec.substr(0, colon));
    const std::string_view parameters =
        colon == std::string::npos ? std::string_view() : std::string_view(spec).substr(colon + 1);
    const tables::EnvironmentRow& row = tables::environments[static_cast<std::size_t>(kind)];
    if (!parameters.empty() && row.keys.empty())
        return usage_error(fmt::format("{} takes no parameters", row.key), parameters,
                           "leave them out");
    return compute(kind, parameters, pool);
}

/// Whether `spec` is a file and not a misspelt name.
bool is_path(const std::string& spec) {
    std::error_code none;
    return spec.find('/') != std::string::npos || spec.find('.') != std::string::npos ||
           std::filesystem::exists(spec, none);
}

}  // namespace

base::Result<std::optional<std::filesystem::path>> environment_file(const std::string& spec) {
    const std::string name = spec.substr(0, spec.find(':'));
    if (kind_named(name)) return std::nullopt;
    if (is_path(spec)) return spec;
    std::vector<std::string> names;
    for (const tables::EnvironmentRow& row : tables::environments) names.emplace_back(row.key);
    return usage_error("no such environment", name, suggestion(name, names));
}

base::Result<Environment> load_environment(const std::string& spec, const base::Limits& limits,
                                           base::ThreadPool& pool, base::Warnings& warnings) {
    const auto file = environment_file(spec);
    if (!file) return tl::unexpected(file.error());
    auto picture = *file ? read(spec, limits, warnings) : compute(spec, pool);
    if (!picture) return tl::unexpected(picture.error());
    return Environment{spec, std::make_shared<Image>(std::move(*picture))};
}

}  // namespace facet::scene
