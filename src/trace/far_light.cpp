// Light through the surfaces of a picture.
// SPDX-License-Identifier: MIT
#include "trace/far_light.h"

#include "math/color.h"
#include "scene/lobes.h"
#include "trace/lobe_weight.h"
#include "trace/mean.h"
#include "trace/smooth.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec3;
using math::Vec4;

/// In and out of two panes, and once more.
constexpr std::uint32_t least_bounces = 16;
/// As many as reach 14 pixels: what is close behind still shows. Each place's variance is its own
/// few paths', by which the filter hardly tells places apart: where it could, it would leave out
/// the bright few that the mean lives on (of a ball lit from behind a tenth).
constexpr std::uint32_t far_passes = 3;
/// At least, of a place's light squared: its few paths may agree by chance, and it would stay a
/// dot.
constexpr float chance_variance = 0.25F;
/// Surfaces that spread light more show no picture of what is behind them.
constexpr float picture_alpha = 0.03F;
constexpr float smoothed_well = 0.5F;
/// Of places around one that tell whether it is a dot.
constexpr std::size_t rings = 2;

/// By how much a surface spreads light that goes through, as the width of a lobe: facets turn it by
/// less the nearer the index is to 1.
float spread_of(const Surface& surface) {
    if (surface.diffuse_transmission > 0.0F) return 1.0F;
    if (!surface.has_volume) return surface.thin_roughness * surface.thin_roughness;
    return surface.roughness * surface.roughness * 3.0F *
           std::fabs(1.0F - 1.0F / std::max(surface.ior, 0.1F));
}

class FarLight {
public:
    FarLight(const World& world, const Seen& seen, const GatherSettings& settings,
             std::uint32_t frame)
        : world_(world), seen_(seen), settings_(settings), frame_(frame) {
        world_.bounce_limit = std::max(world_.bounce_limit, least_bounces);
        for (const scene::Instance& instance : world.scene.instances)
            is_translucent_.push_back(scene::is_translucent(world.scene.material_of(instance)));
    }

    std::vector<Vec4> run(base::ThreadPool& pool) {
        if (std::ranges::find(is_translucent_, true) == is_translucent_.end()) return {};
        out_.resize(seen_.pixels.size());
        points_.resize(out_.size());
        means_.resize(out_.size());
        weights_.resize(out_.size());
        for_each_surface(seen_, pool,
                         [&](std::uint32_t x, std::uint32_t y, std::size_t at,
                             const SeenPixel& pixel) { draw(x, y, at, pixel); });
        if (std::ranges::none_of(points_, &GatherPoint::is_surface)) return std::move(out_);
        clamp_dots();
        smooth(seen_.size, points_, means_, far_passes, pool);
        for (std::size_t i = 0; i < out_.size(); ++i)
            if (points_[i].is_surface) out_[i] = Vec4(means_[i].rest * weights_[i], 1.0F);
        return std::move(out_);
    }

private:
    void draw(std::uint32_t x, std::uint32_t y, std::size_t at, const SeenPixel& pixel) {
        if (!is_translucent_[pixel.instance]) return;
        const Ray ray = seen_.ray(x, y);
        const Surface surface =
            seen_surface(world_.scene, world_.frames, world_.textures, pixel, ray);
        const Bsdf bsdf(world_.model, surface, -ray.direction, Bsdf::Draws::far);
        const Vec3 weight = filled(bsdf.far_weight());
        if (weight == Vec3(0.0F)) return;
        const Cone cone{seen_.pixel_width_at(surface.position_m), seen_.pixel_spread};
        Vec3 sum(0.0F);
        Mean mean;
        // What shows no picture is smoothed, and volumes that scatter take long paths.
        const float spread = spread_of(surface);
        const std::uint32_t count =
            spread < smoothed_well ? settings_.far : (settings_.far + 3) / 4;
        for (std::uint32_t i = 0; i < count; ++i) {
            Sequence sequence(seen_.number_of(x, y), frame_ * count + i, settings_.seed + 4);
            Gathered light;
            gather_light(world_, surface, -ray.direction, cone, sequence, light, Bsdf::Draws::far);
            const Vec3 found =
                light.diffuse_sky + light.diffuse_rest + light.specular_sky + light.specular_rest;
            sum += found;
            mean.add(math::luminance(over(found, weight)));
        }
        sum /= static_cast<float>(count);
        out_[at] = Vec4(sum, 1.0F);
        if (spread < picture_alpha) return;
        weights_[at] = weight;
        points_[at] = {.position_m = surface.position_m,
                       .normal = surface.normal,
                       .spacing_m = cone.width_m,
                       .alpha = spread,
                       .is_surface = true};
        means_[at].rest = over(sum, weight);
        const float nit = math::luminance(means_[at].rest);
        means_[at].diffuse_variance = std::max(mean.variance(count), chance_variance * nit * nit);
        means_[at].has_diffuse = 1.0F;
    }

    /// A path that finds a light by chance brings more than all it stands for, and no filter
    /// spreads what is unlike all around it: no place is brighter than twice the brightest of those
    /// around it. Fewer than two rings of them would take light from what few paths leave uneven:
    /// of skin 15 % (one ring, one path a sample).
    void clamp_dots() {
        std::vector<float> found(out_.size());
        for (std::size_t i = 0; i < found.size(); ++i) found[i] = math::luminance(means_[i].rest);
        for (std::size_t y = 0; y < seen_.size.height; ++y)
            for (std::size_t x = 0; x < seen_.size.width; ++x) {
                const std::size_t i = y * seen_.size.width + x;
                if (!points_[i].is_surface || found[i] <= 0.0F) continue;
                const float most = most_around(found, x, y);
                if (most > 0.0F && found[i] > 2.0F * most) means_[i].rest *= 2.0F * most / found[i];
            }
    }

    /// Of the surfaces in the rings around a place; 0 where there are none.
    [[nodiscard]] float most_around(const std::vector<float>& found, std::size_t x,
                                    std::size_t y) const {
        const std::size_t width = seen_.size.width, height = seen_.size.height;
        const auto first = [](std::size_t at) { return at - std::min(at, rings); };
        const auto end = [](std::size_t at, std::size_t side) {
            return std::min(at + rings + 1, side);
        };
        float most = 0.0F;
        for (std::size_t row = first(y); row < end(y, height); ++row)
            for (std::size_t column = first(x); column < end(x, width); ++column) {
                const std::size_t j = row * width + column;
                if (j != y * width + x && points_[j].is_surface) most = std::max(most, found[j]);
            }
        return most;
    }

    World world_;
    const Seen& seen_;
    const GatherSettings& settings_;
    std::uint32_t frame_;
    std::vector<bool> is_translucent_;
    std::vector<GatherPoint> points_;
    std::vector<GatheredMeans> means_;
    std::vector<Vec3> weights_;
    std::vector<Vec4> out_;
};

}  // namespace

std::vector<Vec4> far_light(const World& world, const Seen& seen, const GatherSettings& settings,
                            std::uint32_t frame, base::ThreadPool& pool) {
    return FarLight(world, seen, settings, frame).run(pool);
}

}  // namespace facet::trace
