// What rays tell a frame of its surfaces.
// SPDX-License-Identifier: MIT
#include "frame/rays/rays.h"

#include "frame/gbuffer/gbuffer.h"
#include "frame/lighting/light_lists.h"

#include <algorithm>
#include <array>

namespace facet::frame {
namespace {

template <class T>
std::vector<T> read(const gl::Context& gl, const GBuffer& gbuffer, int index,
                    const gl::PixelFormat& format, std::size_t components) {
    std::vector<T> out(static_cast<std::size_t>(gbuffer.spec.size.pixels()) * components);
    gl::read_pixels(gl, gbuffer.framebuffer, index, gbuffer.spec.size, format,
                    std::as_writable_bytes(std::span(out)));
    return out;
}

TileLights tile_lights(const PackedLights& lights, const LightLists* lists) {
    TileLights out;
    const auto add_tile = [&](std::span<const std::uint16_t> own) {
        out.first.push_back(static_cast<std::uint32_t>(out.indices.size()));
        for (std::uint32_t i = 0; i < lights.directional_count; ++i)
            out.indices.push_back(static_cast<std::uint16_t>(i));
        out.indices.insert(out.indices.end(), own.begin(), own.end());
    };
    if (lists == nullptr) {
        add_tile({});
    } else {
        out.tiles_across = lists->tiles_across;
        for (std::size_t t = 0; t < lists->tiles.size(); t += 2) add_tile(lists->of_tile(t / 2));
    }
    out.first.push_back(static_cast<std::uint32_t>(out.indices.size()));
    return out;
}

std::size_t longest(const TileLights& lights) {
    std::size_t most = 0;
    for (std::size_t t = 0; t + 1 < lights.first.size(); ++t)
        most = std::max<std::size_t>(most, lights.first[t + 1] - lights.first[t]);
    return most;
}

/// Makes it anew where its size was another.
base::Status update_texture(const gl::Context& gl, math::Extent size,
                            std::span<const math::Vec4> values, math::Extent& old_size,
                            gl::Texture& texture) {
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = size};
    if (old_size != size) {
        auto made = gl::make_texture(gl, spec);
        if (!made) return tl::unexpected(made.error());
        texture = std::move(*made);
        old_size = size;
    }
    gl::upload(gl, texture, spec, 0, 0, {GL_RGBA, GL_FLOAT}, std::as_bytes(values));
    return {};
}

}  // namespace

ReadSurfaces read_surfaces(const gl::Context& gl, const GBuffer& gbuffer, const shared::View& view,
                           math::Extent picture, const Region& region) {
    return {region,
            picture,
            view,
            read<float>(gl, gbuffer, 0, {GL_DEPTH_COMPONENT, GL_FLOAT}, 1),
            read<std::uint32_t>(gl, gbuffer, gbuffer.spec.triangles_place(),
                                {GL_RG_INTEGER, GL_UNSIGNED_INT}, 2),
            read<std::uint16_t>(gl, gbuffer, 0, {GL_RGBA, GL_UNSIGNED_SHORT}, 4),
            read<std::uint16_t>(gl, gbuffer, 1, {GL_RG, GL_UNSIGNED_SHORT}, 2),
            read<std::uint8_t>(gl, gbuffer, 2, {GL_RGBA, GL_UNSIGNED_BYTE}, 4),
            gbuffer.spec.specular ? read<std::uint16_t>(gl, gbuffer, gbuffer.spec.specular_place(),
                                                        {GL_RGBA, GL_UNSIGNED_SHORT}, 4)
                                  : std::vector<std::uint16_t>()};
}

RayTextures make_ray_textures(const gl::Context& gl) {
    RayTextures out;
    const std::array<std::byte, 4> nothing{};
    out.visibility = gl::make_buffer(gl, nothing);
    out.visibility_texture = gl::make_buffer_texture(gl, out.visibility, GL_RGBA8);
    return out;
}

base::Status update_indirect(const gl::Context& gl, const IndirectLight& light, RayTextures& out) {
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = light.size};
    const bool is_new = out.stride == 0 || out.size != light.size;
    for (const auto& [texture, values] :
         {std::pair{&out.sky, light.sky}, std::pair{&out.rest, light.rest},
          std::pair{&out.specular, light.specular}, std::pair{&out.guide, light.guide}}) {
        if (is_new) {
            auto made = gl::make_texture(gl, spec);
            if (!made) return tl::unexpected(made.error());
            *texture = std::move(*made);
        }
        gl::upload(gl, *texture, spec, 0, 0, {GL_RGBA, GL_FLOAT}, std::as_bytes(values));
    }
    out.size = light.size;
    out.stride = light.stride;
    return update_texture(gl, light.ground_size, light.ground, out.ground_size, out.ground);
}

base::Status update_sample_light(const gl::Context& gl, const SampleLight& light, math::Extent size,
                                 RayTextures& out) {
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = size};
    for (const auto& [texture, values] : {std::pair{&out.sample_diffuse, light.diffuse},
                                          std::pair{&out.sample_specular, light.specular}}) {
        if (out.sample_size != size) {
            auto made = gl::make_texture(gl, spec);
            if (!made) return tl::unexpected(made.error());
            *texture = std::move(*made);
        }
        gl::upload(gl, *texture, spec, 0, 0, {GL_RGBA, GL_FLOAT}, std::as_bytes(values));
    }
    out.sample_size = size;
    return light.far.empty() ? base::Status{}
                             : update_texture(gl, size, light.far, out.far_size, out.sample_far);
}

void update_visibility(const gl::Context& gl, const PackedLights& lights, const LightLists* lists,
                       math::Extent size, std::uint32_t frame, Rays& rays, RayTextures& out) {
    const TileLights tiles = tile_lights(lights, lists);
    GLint most_texels = 0;
    gl.api().GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most_texels);
    const auto room = static_cast<std::size_t>(most_texels) / size.pixels();
    const std::size_t slots = std::min(longest(tiles), room);
    const std::vector<std::uint8_t> shares = rays.visibility(tiles, slots, frame);
    out.slots = static_cast<std::uint32_t>(slots);
    if (slots > 0) gl::update_buffer(gl, out.visibility, std::as_bytes(std::span(shares)));
}

}  // namespace facet::frame
