// The reflection of a material's dielectric.
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

}  // namespace facet::scene
