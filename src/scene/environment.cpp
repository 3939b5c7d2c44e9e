// Environments: read from a lat-long picture, or computed.
// SPDX-License-Identifier: MIT
#include "scene/environment.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "base/file.h"
#include "base/text.h"
#include "image/read.h"
#include "scene/environment_models.h"
#include "tables/environments.h"

namespace facet::scene {
namespace {

using base::ErrorCode;
using image::Image;
using math::Vec3;

constexpr math::Extent detailed{1024, 512};
constexpr math::Extent uniform{16, 8};
constexpr float sun_radius_rad = 0.5F * math::pi / 180.0F;  // of the disc drawn; the real one is half a texel

/// Centre of a pixel as a direction (contract, "Conventions").
Vec3 direction_of(std::uint32_t x, std::uint32_t y, math::Extent size) {
    const float phi = (static_cast<float>(x) + 0.5F) / static_cast<float>(size.width) * 2.0F * math::pi - math::pi;
    const float theta = (static_cast<float>(y) + 0.5F) / static_cast<float>(size.height) * math::pi;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

Image paint(math::Extent size, base::ThreadPool& pool, const std::function<Vec3(const Vec3&)>& radiance) {
    Image picture(size, 3, image::Sample::f32);
    const auto values = picture.as<float>();
    pool.parallel_for(size.height, [&](std::size_t y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const Vec3 c = radiance(direction_of(x, static_cast<std::uint32_t>(y), size));
            float* pixel = &values[(y * size.width + x) * 3];
            for (int i = 0; i < 3; ++i) pixel[i] = c[i];
        }
    });
    return picture;
}

/// Adds the sun's disc to the pixels whose centres it covers, or the nearest one, so that it gives exactly
/// `illuminance` at normal incidence.
void add_sun(Image& picture, const Vec3& to_sun, const Vec3& illuminance) {
    const auto values = picture.as<float>();
    const math::Extent size = picture.size;
    std::vector<std::pair<std::size_t, float>> covered;  // pixel, solid angle
    float nearest = -2.0F;
    std::pair<std::size_t, float> fallback;
    float total = 0.0F;
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const Vec3 d = direction_of(x, y, size);
            const float cosine = math::dot(d, to_sun);
            const float height = math::pi / static_cast<float>(size.height);
            const float solid_angle = std::sqrt(std::max(0.0F, 1.0F - d.y * d.y)) * height * height;
            const std::pair<std::size_t, float> pixel{std::size_t{y} * size.width + x, solid_angle};
            if (cosine > nearest) {
                nearest = cosine;
                fallback = pixel;
            }
            if (cosine < std::cos(sun_radius_rad)) continue;
            covered.push_back(pixel);
            total += solid_angle;
        }
    if (covered.empty()) {
        covered.push_back(fallback);
        total = fallback.second;
    }
    for (const auto& [pixel, solid_angle] : covered)
        for (std::size_t c = 0; c < 3; ++c) values[pixel * 3 + c] += illuminance[static_cast<int>(c)] / total;
}

tl::unexpected<base::Error> unknown(std::string what, const std::string& found, std::span<const std::string> names) {
    const auto near = base::nearest(found, names);
    return base::fail({.code = ErrorCode::usage,
                       .what = std::move(what),
                       .found = found,
                       .remedy = near.empty() ? "one of " + base::join(names, ", ")
                                              : "did you mean " + base::join(near, ", ")});
}

base::Result<SkyParameters> parse_sky(std::string_view text) {
    SkyParameters sky;
    struct Key {
        std::string name;
        float* value;
        double low, high;
    };
    const std::vector<Key> keys = {{"sun_elevation", &sky.sun_elevation_deg, 0.0, 90.0},
                                   {"sun_azimuth", &sky.sun_azimuth_deg, -3600.0, 3600.0},
                                   {"turbidity", &sky.turbidity, 1.9, 10.0},
                                   {"ground_albedo", &sky.ground_albedo, 0.0, 1.0}};
    std::vector<std::string> names;
    for (const Key& key : keys) names.push_back(key.name);
    for (const std::string_view part : base::split(text, ',')) {
        if (base::trimmed(part).empty()) continue;
        const std::size_t equals = part.find('=');
        std::string name(base::trimmed(part.substr(0, equals)));
        std::replace(name.begin(), name.end(), '-', '_');
        const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
        if (key == keys.end()) return unknown("unknown key of sky", name, names);
        const auto number = base::parse_number(
            base::trimmed(equals == std::string_view::npos ? "" : part.substr(equals + 1)));
        if (!number || *number < key->low || *number > key->high)
            return base::fail({.code = ErrorCode::usage,
                               .what = fmt::format("{} of sky is {} to {}", name, key->low, key->high),
                               .found = std::string(part)});
        *key->value = static_cast<float>(*number);
    }
    return sky;
}

base::Result<Image> compute(tables::EnvironmentKind kind, std::string_view parameters, base::ThreadPool& pool) {
    switch (kind) {
        case tables::EnvironmentKind::studio: return paint(detailed, pool, studio_radiance);
        case tables::EnvironmentKind::overcast: return paint({256, 128}, pool, overcast_radiance);
        case tables::EnvironmentKind::furnace: return paint(uniform, pool, [](const Vec3&) { return Vec3(1.0F); });
        case tables::EnvironmentKind::black: return Image(uniform, 3, image::Sample::f32);
        case tables::EnvironmentKind::sky: break;
    }
    const auto parsed = parse_sky(parameters);
    if (!parsed) return tl::unexpected(parsed.error());
    const Sky sky(*parsed);
    Image picture = paint(detailed, pool, [&](const Vec3& d) { return sky.radiance(d); });
    add_sun(picture, sky.to_sun(), sky.sun_illuminance_lux());
    return picture;
}

/// A picture file as RGB radiance.
base::Result<Image> read(const std::string& path, const base::Limits& limits, base::Warnings& warnings) {
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
        warnings.push_back({.file = path,
                            .what = "an environment is twice as wide as high; this one is stretched",
                            .found = fmt::format("{}x{}", decoded->size.width, decoded->size.height)});
    if (decoded->channels == 3) return decoded;
    Image rgb(decoded->size, 3, image::Sample::f32);
    const auto from = std::as_const(*decoded).as<float>();
    const auto to = rgb.as<float>();
    const std::size_t channels = decoded->channels;
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = from[i / 3 * channels + (channels >= 3 ? i % 3 : 0)];
    return rgb;
}

/// Whether `spec` looks like a file and not like a misspelt name.
bool is_path(const std::string& spec) {
    return spec.find('/') != std::string::npos || spec.find('.') != std::string::npos;
}

}  // namespace

base::Result<Environment> load_environment(const std::string& spec, const base::Limits& limits,
                                           base::ThreadPool& pool, base::Warnings& warnings) {
    const std::size_t colon = spec.find(':');
    const std::string name = spec.substr(0, colon);
    const std::string_view parameters =
        colon == std::string::npos ? std::string_view() : std::string_view(spec).substr(colon + 1);
    std::vector<std::string> names;
    std::optional<base::Result<Image>> picture;
    for (std::size_t i = 0; i < tables::environments.size(); ++i) {
        const tables::EnvironmentRow& row = tables::environments[i];
        names.emplace_back(row.key);
        if (row.key != name) continue;
        if (!parameters.empty() && row.keys.empty())
            return base::fail({.code = ErrorCode::usage,
                               .what = fmt::format("{} takes no parameters", name),
                               .found = std::string(parameters)});
        picture = compute(static_cast<tables::EnvironmentKind>(i), parameters, pool);
    }
    if (!picture && !is_path(spec)) return unknown("no such environment", name, names);
    if (!picture) picture = read(spec, limits, warnings);
    if (!*picture) return tl::unexpected(picture->error());
    return Environment{spec, std::make_shared<Image>(std::move(**picture))};
}

}  // namespace facet::scene
