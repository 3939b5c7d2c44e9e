// Shadows on the ground below a scene.
// SPDX-License-Identifier: MIT
#include "trace/ground.h"

#include "math/color.h"
#include "trace/mean.h"
#include "trace/open_light.h"
#include "trace/smooth.h"

#include <algorithm>

namespace facet::trace {
namespace {

using math::Vec3;
using math::Vec4;

/// A path that finds a light by chance brings more than all it stands for: no share is above this.
constexpr float most_share = 8.0F;

/// Light at one place, from `count` numbered paths.
GatheredMeans light_place(const World& world, const Vec3& position_m, Cone cone,
                          std::uint32_t number, std::uint32_t seed, std::uint32_t count) {
    GatheredMeans out{.has_diffuse = 1.0F, .has_specular = 1.0F};
    Mean lit;
    const GroundPlace place{position_m, open_ground(world, position_m)};
    for (std::uint32_t i = 0; i < count; ++i) {
        Sequence sequence(number, i, seed);
        std::uint32_t rays = 0;
        const Vec3 share =
            glm::min(ground_share(world, place, cone, sequence, rays), Vec3(most_share));
        out.rest += share;
        lit.add(math::luminance(share));
    }
    out.rest /= static_cast<float>(count);
    out.diffuse_variance = lit.variance(count);
    return out;
}

}  // namespace

std::optional<Vec3> meet_ground(const World& world, const Ray& ray) {
    const scene::Ground& ground = *world.scene.ground;
    const float above_m = ray.origin.y - ground.height_m;
    if (!(ray.direction.y < 0.0F) || above_m <= 0.0F) return std::nullopt;
    const float distance_m = above_m / -ray.direction.y;
    if (distance_m <= ray.near_m || distance_m >= ray.far_m) return std::nullopt;
    Vec3 place = ray.origin + ray.direction * distance_m;
    place.y = ground.height_m;
    const math::Vec2 aside = math::Vec2(place.x, place.z) - ground.center_m;
    if (glm::dot(aside, aside) > ground.radius_m * ground.radius_m) return std::nullopt;
    return place;
}

GroundPixels light_ground(const World& world, const Seen& seen, const GatherSettings& settings,
                          base::ThreadPool& pool) {
    const std::uint32_t stride = settings.stride;
    const math::Extent size{(seen.size.width + stride - 1) / stride,
                            (seen.size.height + stride - 1) / stride};
    std::vector<GatherPoint> points(size.pixels());
    std::vector<GatheredMeans> means(size.pixels());
    // In the middle of a place's square.
    const auto pixel = [stride](std::size_t place, std::uint32_t pixels) {
        return std::min(static_cast<std::uint32_t>(place) * stride + stride / 2, pixels - 1);
    };
    const auto rows = [&](std::uint32_t paths, auto wants) {
        pool.parallel_for(size.height, [&](std::size_t row) {
            for (std::uint32_t x = 0; x < size.width; ++x) {
                if (settings.cancelled != nullptr && settings.cancelled->load()) return;
                const std::size_t at = row * size.width + x;
                if (!points[at].is_surface || !wants(at)) continue;
                means[at] = light_place(
                    world, points[at].position_m,
                    {points[at].spacing_m / static_cast<float>(stride), seen.pixel_spread},
                    seen.number_of(pixel(x, seen.size.width), pixel(row, seen.size.height)),
                    settings.seed + 3, paths);
            }
        });
    };
    pool.parallel_for(size.height, [&](std::size_t row) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const auto place = meet_ground(
                world, seen.ray(pixel(x, seen.size.width), pixel(row, seen.size.height)));
            if (!place) continue;
            points[row * size.width + x] = {
                .position_m = *place,
                .normal = {0.0F, 1.0F, 0.0F},
                .spacing_m = seen.pixel_width_at(*place) * static_cast<float>(stride),
                .is_surface = true};
        }
    });
    rows(settings.samples, [](std::size_t) { return true; });
    std::vector<GatheredMeans> even = means;
    even_variances(size, points, even, 1, pool);
    // Open ground is as it was, and certainly so.
    rows(settings.most_samples, [&](std::size_t at) {
        return even[at].diffuse_variance > settings.error * settings.error;
    });
    even_variances(size, points, means, 1, pool);
    smooth(size, points, means, smooth_passes, pool);
    GroundPixels out{size, std::vector<Vec4>(size.pixels(), Vec4(1.0F))};
    for (std::size_t i = 0; i < means.size(); ++i)
        if (points[i].is_surface) out.share[i] = Vec4(glm::max(means[i].rest, Vec3(0.0F)), 1.0F);
    return out;
}

}  // namespace facet::trace
