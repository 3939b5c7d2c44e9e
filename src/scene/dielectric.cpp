// What a material's dielectric reflects and absorbs.
// SPDX-License-Identifier: MIT
#include "scene/dielectric.h"

#include "brdf/terms.h"

namespace facet::scene {
namespace {

constexpr float plain_ior = 1.5F;
// As the shaders write it: the ratio in float is an ulp off.
constexpr float plain_f0 = brdf::Terms<float>::DIELECTRIC_F0;

}  // namespace

bool has_specular(const Material& material) {
    const tables::MaterialValues& v = material.values;
    return v.ior != plain_ior || v.specular != 1.0F || v.specular_color != Vec3(1.0F) ||
           material.texture(tables::TextureSlot::specular_texture) ||
           material.texture(tables::TextureSlot::specular_color_texture);
}

Vec3 dielectric_f0(const tables::MaterialValues& values) {
    if (values.ior == plain_ior) return plain_f0 * values.specular_color;
    const float ratio = (values.ior - 1.0F) / (values.ior + 1.0F);  // -1 for 0: without end
    return ratio * ratio * values.specular_color;
}

Vec3 extinction_per_m(const tables::MaterialValues& values) {
    if (!(values.attenuation_distance_m > 0.0F)) return Vec3(0.0F);
    constexpr float black = 1e-6F;  // its logarithm has an end
    return -glm::log(glm::max(values.attenuation_color, Vec3(black))) /
           values.attenuation_distance_m;
}

Vec3 scattered_share(const tables::MaterialValues& values) {
    const Vec3 c = values.scatter_color;
    const Vec3 s = 4.09712F + 4.20863F * c - glm::sqrt(9.59217F + c * (41.6808F + 17.7126F * c));
    const Vec3 share = (1.0F - s * s) / (1.0F - values.scatter_anisotropy * s * s);
    return glm::clamp(share, 0.0F, 0.99999F) * glm::step(Vec3(1e-6F), c);
}

}  // namespace facet::scene
