// Indirect light at the surfaces of a picture.
// SPDX-License-Identifier: MIT
#include "trace/gather.h"

#include "math/color.h"
#include "trace/lobe_weight.h"
#include "trace/mean.h"
#include "trace/open_light.h"
#include "trace/smooth.h"

#include <algorithm>

namespace facet::trace {
namespace {

using math::Vec3;
using math::Vec4;

/// Places are gathered in squares of this many, which see the same triangles.
constexpr std::uint32_t tile_places = 16;
/// A surface where fewer of 8 neighbours are alike is finer than pixels.
constexpr float few_helpers = 4.0F;
/// Share of the mean light that may be uncertain in the dark.
constexpr float dark = 0.1F;
/// Draws of the open sky at a place: they need no ray.
constexpr std::uint32_t open_draws = 16;

class Gatherer {
public:
    Gatherer(const World& world, const Seen& seen, const GatherSettings& settings)
        : world_(world),
          seen_(seen),
          settings_(settings),
          size_{(seen.size.width + settings.stride - 1) / settings.stride,
                (seen.size.height + settings.stride - 1) / settings.stride},
          places_(size_.pixels()),
          points_(size_.pixels()),
          means_(size_.pixels()),
          expected_(size_.pixels()),
          at_sample_(size_.pixels(), 1) {}

    IndirectPixels run(base::ThreadPool& pool) {
        tiles(pool, [&](std::uint32_t x, std::uint32_t y) { find_place(x, y); });
        const std::vector<Helpers> helpers = helpers_of(size_, points_, pool);
        draw_left_out(helpers, pool);
        draw_more(helpers, pool);
        even_variances(size_, points_, means_, settings_.apart, pool);
        count_at_samples(helpers);
        const float even = scale_specular();
        smooth(size_, points_, means_, smooth_passes, pool);
        compose_specular(even);
        return result(helpers);
    }

private:
    struct Place {
        std::uint32_t x = 0;  ///< pixel
        std::uint32_t y = 0;
        std::uint32_t count = 0;  ///< paths drawn
        float unbaked = 0.0F;     ///< share of its sky that paths tell of
        float diffuse_weight = 0.0F;
        float specular_weight = 0.0F;
        GatheredMeans sum;
        Mean diffuse;
        Mean specular;
    };

    template <class Of>
    void tiles(base::ThreadPool& pool, const Of& of) const {
        const std::uint32_t across = (size_.width + tile_places - 1) / tile_places;
        const std::uint32_t down = (size_.height + tile_places - 1) / tile_places;
        pool.parallel_for(std::size_t{across} * down, [&](std::size_t tile) {
            if (settings_.cancelled != nullptr && settings_.cancelled->load()) return;
            const auto x0 = static_cast<std::uint32_t>(tile % across) * tile_places;
            const auto y0 = static_cast<std::uint32_t>(tile / across) * tile_places;
            for (std::uint32_t y = y0; y < std::min(y0 + tile_places, size_.height); ++y)
                for (std::uint32_t x = x0; x < std::min(x0 + tile_places, size_.width); ++x)
                    of(x, y);
        });
    }

    /// The pixel nearest to the middle of the place's square that has a surface.
    [[nodiscard]] bool pixel_of(std::uint32_t x, std::uint32_t y, std::uint32_t& px,
                                std::uint32_t& py) const {
        const std::uint32_t stride = settings_.stride;
        bool found = false;
        std::int64_t nearest = 0;
        const auto middle = static_cast<std::int64_t>(stride / 2);
        for (std::uint32_t j = 0; j < stride; ++j)
            for (std::uint32_t i = 0; i < stride; ++i) {
                const std::uint32_t at_x = x * stride + i;
                const std::uint32_t at_y = y * stride + j;
                if (at_x >= seen_.size.width || at_y >= seen_.size.height) continue;
                const SeenPixel& pixel = seen_.pixels[std::size_t{at_y} * seen_.size.width + at_x];
                if (pixel.instance == SeenPixel::nothing) continue;
                const std::int64_t dx = std::int64_t{i} - middle;
                const std::int64_t dy = std::int64_t{j} - middle;
                const std::int64_t distance = dx * dx + dy * dy;
                if (found && distance >= nearest) continue;
                found = true;
                nearest = distance;
                px = at_x;
                py = at_y;
            }
        return found;
    }

    void find_place(std::uint32_t x, std::uint32_t y) {
        const std::size_t at = std::size_t{y} * size_.width + x;
        Place& place = places_[at];
        if (!pixel_of(x, y, place.x, place.y)) return;
        const Surface surface = surface_of(place);
        if (surface.sheen_color != Vec3(0.0F)) {
            // Twice the fibres' share: the paths' mean is of both lobes.
            const Bsdf bsdf(world_.model, surface, -seen_.ray(place.x, place.y).direction);
            place.unbaked = std::min(2.0F * bsdf.sheen_share(), 1.0F);
        }
        points_[at] = {.position_m = surface.position_m,
                       .normal = surface.normal,
                       .spacing_m = seen_.pixel_width_at(surface.position_m) *
                                    static_cast<float>(settings_.stride),
                       .alpha = narrowest_alpha(surface),
                       .is_surface = true};
        if (settings_.expected)
            expected_[at] = math::luminance(settings_.expected(
                glm::reflect(seen_.ray(place.x, place.y).direction, surface.normal),
                surface.roughness));
        // Smooth surfaces show a picture, others light that a few places tell of.
        constexpr float smooth_alpha = 0.06F;
        const std::uint32_t apart = settings_.apart;
        const bool is_smooth =
            points_[at].alpha < smooth_alpha && points_[at].alpha >= settings_.mirrored_alpha;
        if (is_smooth || (x % apart == 0 && y % apart == 0)) draw(at, settings_.samples);
    }

    /// Draws where the places around are not alike, so that those drawn may tell nothing.
    void draw_left_out(const std::vector<Helpers>& helpers, base::ThreadPool& pool) {
        if (settings_.apart == 1) return;
        tiles(pool, [&](std::uint32_t x, std::uint32_t y) {
            const std::size_t at = std::size_t{y} * size_.width + x;
            constexpr float enough = 3.0F;
            if (points_[at].is_surface && places_[at].count == 0 &&
                (helpers[at].diffuse < enough || helpers[at].specular < enough))
                draw(at, settings_.samples);
        });
    }

    /// Without the coat that sample_light() draws for.
    [[nodiscard]] Surface surface_of(const Place& place) const {
        Surface surface =
            seen_surface(world_.scene, world_.frames, world_.textures,
                         seen_.pixels[std::size_t{place.y} * seen_.size.width + place.x],
                         seen_.ray(place.x, place.y));
        if (has_coat_apart(surface, settings_.mirrored_alpha)) surface.coat = 0.0F;
        return surface;
    }

    /// Draws paths there until there are `count`.
    void draw(std::size_t at, std::uint32_t count) {
        Place& place = places_[at];
        const Surface surface = surface_of(place);
        const Vec3 to_eye = -seen_.ray(place.x, place.y).direction;
        const Bsdf bsdf(world_.model, surface, to_eye);
        const auto weight = bsdf.environment_weight();
        if (place.unbaked > 0.0F) count *= 2;
        const Vec3 diffuse_weight = filled(weight.diffuse);
        const Vec3 specular_weight = filled(weight.specular);
        const Cone cone{seen_.pixel_width_at(surface.position_m), seen_.pixel_spread};
        const std::uint32_t number = seen_.number_of(place.x, place.y);
        GatheredMeans& sum = place.sum;
        const std::uint32_t drawn_before = place.count;
        for (; place.count < count; ++place.count) {
            Sequence sequence(number, place.count, settings_.seed);
            Gathered light;
            gather_light(world_, surface, to_eye, cone, sequence, light);
            const Vec3 sky = over(light.diffuse_sky, diffuse_weight);
            const Vec3 rest = over(light.diffuse_rest, diffuse_weight);
            const Vec3 mirrored_sky = over(light.specular_sky, specular_weight);
            const Vec3 mirrored = mirrored_sky + over(light.specular_rest, specular_weight);
            sum.sky += sky;
            sum.open += over(light.diffuse_open, diffuse_weight);
            sum.rest += rest;
            sum.specular += mirrored;
            sum.specular_sky += mirrored_sky;
            sum.specular_open += over(light.specular_open, specular_weight);
            place.diffuse.add(math::luminance(sky + rest));
            place.specular.add(math::luminance(mirrored));
        }
        const float share = 1.0F / static_cast<float>(count);
        GatheredMeans& mean = means_[at];
        mean.sky = sum.sky * share;
        mean.open = sum.open * share;
        mean.rest = sum.rest * share;
        mean.specular = sum.specular * share;
        mean.specular_sky = sum.specular_sky * share;
        mean.specular_open = sum.specular_open * share;
        if (drawn_before == 0)
            mean.specular_known =
                over(open_specular(world_, surface, to_eye, number, settings_.seed + 3, open_draws),
                     specular_weight);
        mean.diffuse_variance = place.diffuse.variance(count);
        mean.specular_variance = place.specular.variance(count);
        mean.has_specular = 1.0F;
        mean.has_diffuse = math::luminance(weight.diffuse) > weight_min ? 1.0F : 0.0F;
        place.diffuse_weight = math::luminance(weight.diffuse);
        place.specular_weight = math::luminance(weight.specular);
    }

    /// Light that the surface at a place sends to the eye, nit.
    [[nodiscard]] float seen_nit(std::size_t at) const {
        const GatheredMeans& mean = means_[at];
        return places_[at].diffuse_weight * math::luminance(mean.sky + mean.rest) +
               places_[at].specular_weight * math::luminance(mean.specular);
    }
    /// Its variance, of each lobe by a share.
    [[nodiscard]] static float seen_variance(const Place& place, const GatheredMeans& mean,
                                             const Helpers& share) {
        const float diffuse = place.diffuse_weight;
        const float specular = place.specular_weight;
        return diffuse * diffuse * mean.diffuse_variance * share.diffuse +
               specular * specular * mean.specular_variance * share.specular;
    }
    /// Over all places that were drawn for, nit; above 0.
    [[nodiscard]] float mean_seen() const {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < means_.size(); ++i) {
            if (places_[i].count == 0) continue;
            sum += static_cast<double>(seen_nit(i));
            ++count;
        }
        return static_cast<float>(sum / std::max(1.0, static_cast<double>(count))) + 1e-18F;
    }

    /// Paths that a place needs for its light to be as certain as asked once it is smoothed.
    [[nodiscard]] std::uint32_t needed(std::size_t at, const GatheredMeans& even,
                                       const Helpers& helpers, float least_nit) const {
        const Place& place = places_[at];
        // What a filter of several passes makes of a place that is like its neighbours.
        const auto left = [](float helpers_of_lobe) {
            return 1.0F / (1.0F + 0.5F * helpers_of_lobe * helpers_of_lobe);
        };
        const float variance =
            seen_variance(place, even, {left(helpers.diffuse), left(helpers.specular)});
        const float allowed = settings_.error * (seen_nit(at) + least_nit);
        const float times = variance / (allowed * allowed);
        const float wanted = times * static_cast<float>(place.count);
        if (!(wanted < static_cast<float>(settings_.most_samples))) return settings_.most_samples;
        return std::max(place.count, static_cast<std::uint32_t>(wanted));
    }

    /// How many paths each sample of a frame needs for the mean over the frames to be as certain
    /// as asked; nothing smooths those.
    void count_at_samples(const std::vector<Helpers>& helpers) {
        if (settings_.most_at_sample <= 1) return;
        const float least = dark * mean_seen();
        for (std::size_t i = 0; i < means_.size(); ++i) {
            const Place& place = places_[i];
            if (place.count == 0) continue;
            const auto draws = static_cast<float>(place.count);
            const float variance = seen_variance(
                place, means_[i], {helpers[i].diffuse < few_helpers ? 1.0F : 0.0F, 1.0F});
            const float allowed = settings_.error * (seen_nit(i) + least);
            const float needed =
                variance * draws / (allowed * allowed * static_cast<float>(settings_.frames));
            const auto most = static_cast<float>(settings_.most_at_sample);
            at_sample_[i] =  // the most too where the sums have no end
                static_cast<std::uint8_t>(needed < most ? std::max(needed, 1.0F) : most);
        }
    }

    /// More paths where the first ones disagree.
    void draw_more(const std::vector<Helpers>& helpers, base::ThreadPool& pool) {
        if (settings_.most_samples <= settings_.samples) return;
        std::vector<GatheredMeans> even = means_;
        even_variances(size_, points_, even, settings_.apart, pool);
        const float least = dark * mean_seen();
        std::vector<std::uint32_t> wanted(means_.size());
        for (std::size_t i = 0; i < means_.size(); ++i)
            if (places_[i].count > 0) wanted[i] = needed(i, even[i], helpers[i], least);
        tiles(pool, [&](std::uint32_t x, std::uint32_t y) {
            const std::size_t at = std::size_t{y} * size_.width + x;
            if (wanted[at] > places_[at].count) draw(at, wanted[at]);
        });
    }

    /// Puts specular light in units of what is expected there, and returns what was added to all
    /// expectations: other surfaces' light is in the mirror too, and evenly, for all that is known.
    float scale_specular() {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < means_.size(); ++i) {
            if (places_[i].count == 0) continue;
            sum += static_cast<double>(math::luminance(means_[i].specular));
            ++count;
        }
        const auto even =
            static_cast<float>(0.5 * sum / std::max(1.0, static_cast<double>(count))) + 1e-20F;
        for (std::size_t i = 0; i < means_.size(); ++i) {
            const float scale = 1.0F / (expected_[i] + even);
            means_[i].specular *= scale;
            means_[i].specular_sky *= scale;
            means_[i].specular_open *= scale;
            means_[i].specular_known *= scale;
            means_[i].specular_variance *= scale * scale;
        }
        return even;
    }

    /// Out of those units again. What the lobe would mirror of the open sky is known from many
    /// draws without rays; the few paths tell which share of it arrives (a ratio estimator: Heitz,
    /// Hill and McGuire 2018, "Combining Analytic Direct Illumination and Stochastic Shadows").
    void compose_specular(float even) {
        for (std::size_t i = 0; i < means_.size(); ++i) {
            GatheredMeans& mean = means_[i];
            const Vec3 rest = mean.specular - mean.specular_sky;
            mean.specular =
                (visible_share(mean.specular_sky, mean.specular_open) * mean.specular_known +
                 rest) *
                (expected_[i] + even);
        }
    }

    /// Part of `open` that `seen` is; all where nothing is known.
    [[nodiscard]] static Vec3 visible_share(const Vec3& seen, const Vec3& open) {
        Vec3 visible(1.0F);
        for (int c = 0; c < 3; ++c)
            if (open[c] > 0.0F) visible[c] = std::clamp(seen[c] / open[c], 0.0F, 1.0F);
        return visible;
    }

    [[nodiscard]] IndirectPixels result(const std::vector<Helpers>& helpers) const {
        const std::size_t count = points_.size();
        IndirectPixels out{size_,
                           settings_.stride,
                           std::vector<Vec4>(count),
                           std::vector<Vec4>(count),
                           std::vector<Vec4>(count),
                           std::vector<Vec4>(count, Vec4(0.0F, 0.0F, 0.0F, -1.0F)),
                           std::vector<std::uint8_t>(count),
                           at_sample_};
        for (std::size_t i = 0; i < count; ++i) {
            out.intricate[i] = helpers[i].diffuse < few_helpers ? 1 : 0;
            if (!points_[i].is_surface) continue;
            const GatheredMeans& mean = means_[i];
            // The baked irradiance is of a cosine: fibres see another mean, which the paths know.
            const float unbaked = places_[i].unbaked;
            out.sky[i] =
                Vec4(visible_share(mean.sky, mean.open) * (1.0F - unbaked), mean.has_diffuse);
            out.rest[i] = Vec4(mean.rest + mean.sky * unbaked, 0.0F);
            out.specular[i] = Vec4(mean.specular, 0.0F);
            out.guide[i] = Vec4(points_[i].position_m, packed_normal(points_[i].normal));
        }
        return out;
    }

    const World& world_;
    const Seen& seen_;
    GatherSettings settings_;
    math::Extent size_;
    std::vector<Place> places_;
    std::vector<GatherPoint> points_;
    std::vector<GatheredMeans> means_;
    std::vector<float> expected_;  ///< luminance in the mirrored direction
    std::vector<std::uint8_t> at_sample_;
};

}  // namespace

IndirectPixels gather(const World& world, const Seen& seen, const GatherSettings& settings,
                      base::ThreadPool& pool) {
    return Gatherer(world, seen, settings).run(pool);
}

}  // namespace facet::trace
