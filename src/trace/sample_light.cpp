// Light at single samples of a frame.
// SPDX-License-Identifier: MIT
#include "math/color.h"
#include "scene/lobes.h"
#include "trace/far_light.h"
#include "trace/gather.h"
#include "trace/lobe_weight.h"

#include <algorithm>

namespace facet::trace {
namespace {

using math::Vec3;
using math::Vec4;

/// Luminance that a single sample may have at a place: a few times what is mirrored around it, as
/// the middles of pixels tell. The few paths that find more would show as dots.
float most_mirrored(const IndirectPixels& middles, std::uint32_t x, std::uint32_t y) {
    constexpr float times = 4.0F;
    float most = 0.0F;
    for (std::uint32_t j = y == 0 ? 0 : y - 1; j <= std::min(y + 1, middles.size.height - 1); ++j)
        for (std::uint32_t i = x == 0 ? 0 : x - 1; i <= std::min(x + 1, middles.size.width - 1);
             ++i)
            most = std::max(
                most,
                math::luminance(Vec3(middles.specular[std::size_t{j} * middles.size.width + i])));
    return times * most;
}

}  // namespace

SampleLight sample_light(const World& world, const Seen& seen, const IndirectPixels& middles,
                         const GatherSettings& settings, std::uint32_t frame,
                         base::ThreadPool& pool) {
    SampleLight out{std::vector<Vec4>(seen.pixels.size()), std::vector<Vec4>(seen.pixels.size()),
                    far_light(world, seen, settings, frame, pool)};
    if (settings.mirrored_alpha <= 0.0F && settings.intricate == 0) return out;
    for_each_surface(
        seen, pool, [&](std::uint32_t x, std::uint32_t y, std::size_t at, const SeenPixel& pixel) {
            const std::uint32_t place_x = x / middles.stride;
            const std::uint32_t place_y = y / middles.stride;
            const std::size_t place = std::size_t{place_y} * middles.size.width + place_x;
            const bool is_intricate = settings.intricate > 0 && middles.intricate[place] != 0;
            const bool may_be_smooth =
                pixel.roughness * pixel.roughness < settings.mirrored_alpha ||
                scene::has_lobe(world.scene.material_of(world.scene.instances[pixel.instance]),
                                tables::Lobe::clearcoat);
            if (!may_be_smooth && !is_intricate) return;
            const Ray ray = seen.ray(x, y);
            const Surface surface =
                seen_surface(world.scene, world.frames, world.textures, pixel, ray);
            const bool is_smooth = narrowest_alpha(surface) < settings.mirrored_alpha;
            if (!is_smooth && !is_intricate) return;
            const bool of_coat = !is_intricate && has_coat_apart(surface, settings.mirrored_alpha);
            const Bsdf::Draws draws = is_intricate ? Bsdf::Draws::both
                                      : of_coat    ? Bsdf::Draws::coat
                                                   : Bsdf::Draws::specular;
            const Bsdf bsdf(world.model, surface, -ray.direction, draws);
            const std::uint32_t count = std::max<std::uint32_t>(
                is_intricate ? settings.intricate : 1, middles.at_sample[place]);
            Gathered light;
            for (std::uint32_t i = 0; i < count; ++i) {
                // Another seed than the middles': their sequence begins at 0 too.
                Sequence sequence(seen.number_of(x, y), frame * count + i, settings.seed + 1);
                gather_light(world, surface, -ray.direction,
                             {seen.pixel_width_at(surface.position_m), seen.pixel_spread}, sequence,
                             light, draws);
            }
            const float share = 1.0F / static_cast<float>(count);
            const auto weight = bsdf.environment_weight();
            Vec3 specular =
                over((light.specular_sky + light.specular_rest) * share, filled(weight.specular));
            if (!of_coat) {  // the middles know nothing of a coat that is drawn for here
                const float most = most_mirrored(middles, place_x, place_y);
                if (const float nit = math::luminance(specular); nit > most) specular *= most / nit;
            }
            out.specular[at] = Vec4(specular, of_coat ? 2.0F : 1.0F);
            if (is_intricate)
                out.diffuse[at] = Vec4(
                    over((light.diffuse_sky + light.diffuse_rest) * share, filled(weight.diffuse)),
                    1.0F);
        });
    return out;
}

}  // namespace facet::trace
