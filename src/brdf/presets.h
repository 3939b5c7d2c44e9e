// Surfaces that are known by name: metals from their optical constants, dielectrics from their
// index. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "math/vector.h"

#include <string_view>
#include <vector>

namespace facet::brdf {

struct Preset {
    std::string_view name;
    bool is_metal = false;
    math::Vec3 f0{0.04F};        ///< linear Rec.709 in [0, 1]: a metal's base colour
    math::Vec3 edge_tint{1.0F};  ///< F82's tint (Kutz, Hasan & Edmondson 2021), [0, 1]
    float ior = 0.0F;            ///< of a dielectric; 0 for metals
    std::string_view source;
    bool is_clamped = false;  ///< the metal's colour lies outside Rec.709, as gold's red does
};

/// Every preset, metals first.
[[nodiscard]] const std::vector<Preset>& presets();
/// Errors: usage, with the nearest names.
[[nodiscard]] base::Result<Preset> find_preset(std::string_view name);

/// Reflectance of a metal at one angle as linear Rec.709, a perfect reflector being 1; not clamped.
/// The exact Fresnel term by wavelength, in the light of D65, seen by the CIE 1931 observer.
/// `cosine` in [0, 1]. Precondition: `metal` is an index of metal_spectra.
[[nodiscard]] math::Vec3 metal_reflectance(std::size_t metal, double cosine);

}  // namespace facet::brdf
