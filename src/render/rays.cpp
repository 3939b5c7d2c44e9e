// A frame's questions about rays, answered by the reference's ray tracer.
// SPDX-License-Identifier: MIT
#include "render/rays.h"

#include "frame/environment/environment_maps.h"
#include "frame/lighting/light_lists.h"

#include <cmath>

namespace facet::render {
namespace {

using math::Vec2;
using math::Vec3;

/// lib/octahedral.glsl's unit_from_octahedral, of a stored pair.
Vec3 unit_from(const std::uint16_t* stored) {
    constexpr float codes = 65535.0F;
    const Vec2 p = Vec2(stored[0], stored[1]) / codes * 2.0F - 1.0F;
    Vec3 v(p, 1.0F - std::fabs(p.x) - std::fabs(p.y));
    const float t = std::max(-v.z, 0.0F);
    v.x += v.x >= 0.0F ? -t : t;
    v.y += v.y >= 0.0F ? -t : t;
    return math::normalize(v);
}

trace::SeenPixel pixel_of(const frame::ReadSurfaces& s, const frame::GpuScene& scene,
                          std::size_t at) {
    trace::SeenPixel out;
    constexpr float codes16 = 65535.0F;
    constexpr float codes8 = 255.0F;
    const std::uint16_t* albedo = s.albedo.data() + at * 4;
    const bool is_unlit = albedo[3] != 0;
    if (s.depth[at] >= 1.0F || is_unlit) return out;
    out.instance = scene.draws[s.triangles[at * 2]].instance;
    out.triangle = s.triangles[at * 2 + 1];
    out.normal = unit_from(s.normal.data() + at * 2);
    out.base_color = Vec3(albedo[0], albedo[1], albedo[2]) / codes16;
    out.metallic = static_cast<float>(s.metal_rough_ao[at * 4]) / codes8;
    out.roughness = static_cast<float>(s.metal_rough_ao[at * 4 + 1]) / codes8;
    if (s.specular.empty()) return out;
    const std::uint16_t* specular = s.specular.data() + at * 4;
    out.dielectric_f0 = Vec3(specular[0], specular[1], specular[2]) / codes16;
    out.specular = static_cast<float>(specular[3]) / codes16;
    return out;
}

/// Scene lights by tile.
class Tiles final : public trace::LightChoice {
public:
    Tiles(const frame::TileLights& tiles, const std::vector<std::size_t>& order)
        : tiles_(tiles), indices_(tiles.indices) {
        for (std::uint16_t& index : indices_) index = static_cast<std::uint16_t>(order[index]);
    }
    [[nodiscard]] std::span<const std::uint16_t> at(std::uint32_t x,
                                                    std::uint32_t y) const override {
        const std::size_t tile = std::size_t{y / frame::tile_px} * tiles_.tiles_across +
                                 (tiles_.tiles_across == 0 ? 0 : x / frame::tile_px);
        return std::span(indices_).subspan(tiles_.first[tile],
                                           tiles_.first[tile + 1] - tiles_.first[tile]);
    }

private:
    const frame::TileLights& tiles_;
    std::vector<std::uint16_t> indices_;
};

}  // namespace

void TracedRays::look_at(const frame::ReadSurfaces& surfaces) {
    const frame::shared::View& view = surfaces.view;
    const math::Extent size = surfaces.region.size;
    seen_.size = size;
    seen_.world_from_clip = view.world_from_clip;
    seen_.eye_m = Vec3(view.eye_m);
    seen_.forward = Vec3(view.forward);
    seen_.is_perspective = view.eye_m.w > 0.5F;
    seen_.pixel_m = view.pixel.x;
    seen_.pixel_spread = view.pixel.y;
    seen_.first_x = surfaces.region.x;
    seen_.last_y = surfaces.region.y + size.height - 1;
    seen_.picture_width = surfaces.picture.width;
    seen_.pixels.resize(static_cast<std::size_t>(size.pixels()));
    pool_.parallel_for(size.height, [&](std::size_t y) {
        for (std::size_t at = y * size.width; at < (y + 1) * size.width; ++at)
            seen_.pixels[at] = pixel_of(surfaces, scene_.draws, at);
    });
}

trace::GatherSettings TracedRays::settings() const {
    return {.samples = plan_.samples,
            .most_samples = plan_.most_samples,
            .error = plan_.error,
            .stride = plan_.stride,
            .apart = plan_.apart,
            .bounces = plan_.bounces,
            .seed = seed_,
            .mirrored_alpha = plan_.mirrored_alpha,
            .intricate = plan_.intricate,
            .most_at_sample = plan_.most_at_sample,
            .frames = frames_,
            .far = plan_.far,
            .cancelled = &cancelled_,
            .expected = {}};
}

frame::IndirectLight TracedRays::indirect(const frame::EnvironmentMaps& environment) {
    trace::GatherSettings gather = settings();
    gather.expected = [&](const Vec3& direction, float roughness) {
        return frame::prefiltered(environment, direction, roughness);
    };
    indirect_ = scene_.tracer.gather(seen_, gather, pool_);
    ground_ = scene_.tracer.ground(seen_, gather, pool_);
    return {.size = indirect_.size,
            .stride = indirect_.stride,
            .sky = indirect_.sky,
            .rest = indirect_.rest,
            .specular = indirect_.specular,
            .ground_size = ground_.size,
            .ground = ground_.share,
            .guide = indirect_.guide};
}

frame::SampleLight TracedRays::sample_light(std::uint32_t frame) {
    sample_light_ = scene_.tracer.sample_light(seen_, indirect_, settings(), frame, pool_);
    return {sample_light_.diffuse, sample_light_.specular, sample_light_.far};
}

std::vector<std::uint8_t> TracedRays::visibility(const frame::TileLights& lights, std::size_t slots,
                                                 std::uint32_t frame) {
    return scene_.tracer.light_visibility(seen_, Tiles(lights, scene_.lights.order), slots,
                                          {frame, seed_ + 2}, pool_);
}

}  // namespace facet::render
