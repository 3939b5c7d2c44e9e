// Light that would arrive if nothing stood in its way.
// SPDX-License-Identifier: MIT
#include "trace/open_light.h"

namespace facet::trace {

using math::Vec3;

Vec3 open_specular(const World& world, const Surface& surface, const Vec3& to_eye,
                   std::uint32_t number, std::uint32_t seed, std::uint32_t draws) {
    Vec3 sum(0.0F);
    if (world.environment.is_black()) return sum;
    const Bsdf bsdf(world.model, surface, to_eye, Bsdf::Draws::specular);
    for (std::uint32_t i = 0; i < draws; ++i) {
        Sequence sequence(number, i, seed);
        const EnvironmentLight::Sample sky = world.environment.sample(sequence.next_pair());
        if (sky.light.pdf > 0.0F) {
            const Scattered f = bsdf.evaluate_specular(sky.direction);
            if (f.pdf > 0.0F)
                sum += f.of_environment * sky.light.radiance_nit *
                       (power_share(sky.light.pdf, f.pdf) / sky.light.pdf);
        }
        const math::Vec2 u = sequence.next_pair();
        const Bsdf::Sample sample = bsdf.sample(u, sequence.next_pair().x);
        if (!sample.is_valid) continue;
        const EnvironmentLight::Light light = world.environment.at(sample.direction);
        if (sample.is_mirror) {
            sum += sample.scattered.of_environment * light.radiance_nit;
            continue;
        }
        const Scattered f = bsdf.evaluate_specular(sample.direction);
        sum += f.of_environment * light.radiance_nit * (power_share(f.pdf, light.pdf) / f.pdf);
    }
    return sum / static_cast<float>(draws);
}

Vec3 open_ground(const World& world, const Vec3& position_m) {
    return world.open_ground + world.lights.irradiance(position_m, {0.0F, 1.0F, 0.0F}) / math::pi;
}

}  // namespace facet::trace
