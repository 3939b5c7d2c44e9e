// Which parts of the BRDF a material has.
// SPDX-License-Identifier: MIT
#include "scene/lobes.h"

#include "scene/dielectric.h"

#include <algorithm>

namespace facet::scene {

bool has_lobe(const Material& material, tables::Lobe lobe) {
    const tables::MaterialValues& v = material.values;
    switch (lobe) {
        case tables::Lobe::base:
            return true;
        case tables::Lobe::specular:
            return has_specular(material);
        case tables::Lobe::clearcoat:
            return v.clearcoat > 0.0F;
        case tables::Lobe::sheen:
            return v.sheen_color != Vec3(0.0F);
        case tables::Lobe::transmission:
            return v.transmission > 0.0F;
        case tables::Lobe::diffuse_transmission:
            return v.diffuse_transmission > 0.0F;
        case tables::Lobe::anisotropy:
            return v.anisotropy > 0.0F;
        case tables::Lobe::iridescence:
            return v.iridescence > 0.0F;
        case tables::Lobe::fresnel_ramp:
            return material.texture(tables::TextureSlot::fresnel_ramp_texture).has_value();
    }
    return false;
}

bool has_layers(const Material& material) {
    return std::ranges::any_of(tables::material_lobes, [&](const tables::MaterialLobe& row) {
        return row.is_layer && has_lobe(material, row.lobe);
    });
}

}  // namespace facet::scene
