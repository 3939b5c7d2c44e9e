// Which lights reach the surfaces of a picture.
// SPDX-License-Identifier: MIT
#include "trace/visibility.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec3;

/// From the surface to a light without a size, by channel; 0 where the surface turns away.
Vec3 visible(const World& world, const Surface& surface, const scene::Light& light,
             Sequence& sequence) {
    Ray ray{.origin = surface.outside_m, .direction = -light.direction};
    if (light.angle_rad > 0.0F) ray.direction = directional_way(light, sequence.next_pair());
    if (light.kind != tables::LightKind::directional) {
        const Vec3 way = light.position_m - surface.outside_m;
        const float distance = math::length(way);
        if (!(distance > 0.0F)) return Vec3(1.0F);
        if (light.range_m > 0.0F && distance >= light.range_m) return Vec3(0.0F);
        ray.direction = way / distance;
        ray.far_m = distance;
    }
    if (math::dot(surface.normal, ray.direction) <= 0.0F ||
        math::dot(surface.face_normal, ray.direction) <= 0.0F)
        return Vec3(0.0F);
    return light.casts_shadow ? world.geometry.transmittance(ray) : Vec3(1.0F);
}

}  // namespace

std::vector<std::uint8_t> light_visibility(const World& world, const Seen& seen,
                                           const LightChoice& lights, std::size_t slots,
                                           const SampleId& sample, base::ThreadPool& pool) {
    const std::size_t pixels = seen.pixels.size();
    std::vector<std::uint8_t> out(slots * pixels * 4, 255);
    for_each_surface(
        seen, pool, [&](std::uint32_t x, std::uint32_t y, std::size_t at, const SeenPixel& pixel) {
            const Surface surface =
                seen_surface(world.scene, world.frames, world.textures, pixel, seen.ray(x, y));
            const auto choice = lights.at(x, y);
            Sequence sequence(seen.number_of(x, y), sample.frame, sample.seed);
            for (std::size_t i = 0; i < std::min(choice.size(), slots); ++i) {
                const Vec3 share = visible(world, surface, world.light(choice[i]), sequence);
                for (int c = 0; c < 3; ++c)
                    out[(i * pixels + at) * 4 + static_cast<std::size_t>(c)] =
                        static_cast<std::uint8_t>(std::lround(255.0F * share[c]));
            }
        });
    return out;
}

}  // namespace facet::trace
