// Image-based light as GL textures.
// SPDX-License-Identifier: MIT
#include "frame/environment/environment_maps.h"

#include "frame/environment/baked_file.h"

#include <algorithm>
#include <cmath>

namespace facet::frame {
namespace {

using CubeLevels = std::span<const std::vector<std::uint16_t>>;
base::Status upload_cube(const gl::Context& gl, std::uint32_t side_px, CubeLevels levels,
                         gl::Texture& out) {
    const gl::TextureSpec spec{.format = GL_RGBA16F,
                               .size = {side_px, side_px},
                               .levels = static_cast<GLsizei>(levels.size()),
                               .cube = true};
    auto texture = gl::make_texture(gl, spec);
    if (!texture) return tl::unexpected(texture.error());
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto bytes = std::as_bytes(std::span(levels[level]));
        for (std::size_t face = 0; face < 6; ++face)
            gl::upload(gl, *texture, spec, static_cast<GLint>(level), static_cast<int>(face),
                       {GL_RGBA, GL_HALF_FLOAT},
                       bytes.subspan(face * bytes.size() / 6, bytes.size() / 6));
    }
    out = std::move(*texture);
    return {};
}

base::Status upload_table(const gl::Context& gl, std::span<const float> table, std::uint32_t size,
                          gl::Texture& out) {
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = {size, size}};
    auto texture = gl::make_texture(gl, spec);
    if (!texture) return tl::unexpected(texture.error());
    gl::upload(gl, *texture, spec, 0, 0, {GL_RGBA, GL_FLOAT}, std::as_bytes(table));
    out = std::move(*texture);
    return {};
}

}  // namespace

math::Vec3 prefiltered(const EnvironmentMaps& maps, const math::Vec3& direction, float roughness) {
    const auto level = static_cast<std::ptrdiff_t>(std::lround(roughness * maps.last_level)) -
                       static_cast<std::ptrdiff_t>(BakedEnvironment::first_kept);
    const auto last = static_cast<std::ptrdiff_t>(maps.kept.size()) - 1;
    FourDirections d{};
    d.x = lanes_of(direction.x);
    d.y = lanes_of(direction.y);
    d.z = lanes_of(direction.z);
    const Lanes found =
        maps.kept[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(level, 0, last))].sample(
            d)[0];
    return math::Vec3(found[0], found[1], found[2]) * maps.unit_nit;
}

base::Result<EnvironmentMaps> upload_environment(const gl::Context& gl,
                                                 const scene::Environment& environment,
                                                 const EnvironmentSettings& settings,
                                                 std::span<const float> table,
                                                 std::uint32_t table_size, base::ThreadPool& pool,
                                                 base::Warnings& warnings) {
    EnvironmentMaps out;
    const image::Image& latlong = *environment.latlong;
    const auto pixels = latlong.as<float>();
    out.is_black = settings.intensity == 0.0F ||
                   std::all_of(pixels.begin(), pixels.end(), [](float x) { return x == 0.0F; });
    auto baked = baked_environment(latlong, settings, pool, warnings);
    out.unit_nit = baked.unit_nit;
    out.kept = std::move(baked.kept);
    out.last_level = static_cast<float>(baked.radiance.size() - 1);
    if (auto s = upload_cube(gl, baked.face_px, baked.radiance, out.radiance_cube); !s)
        return tl::unexpected(s.error());
    if (auto s = upload_cube(gl, BakedEnvironment::irradiance_px, {&baked.irradiance, 1},
                             out.irradiance_cube);
        !s)
        return tl::unexpected(s.error());
    if (auto s = upload_table(gl, table, table_size, out.albedo_table); !s)
        return tl::unexpected(s.error());
    out.cube_sampler = gl::make_sampler(
        gl, {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE});
    out.table_sampler =
        gl::make_sampler(gl, {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE});
    return out;
}

}  // namespace facet::frame
