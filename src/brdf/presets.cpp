// Surfaces that are known by name.
// SPDX-License-Identifier: MIT
#include "brdf/presets.h"

#include "base/text.h"
#include "brdf/metal_spectra.h"
#include "brdf/terms.h"
#include "math/cie_1931.h"
#include "math/color.h"
#include "math/d65.h"
#include "tables/dielectrics.h"

#include <algorithm>
#include <string>

namespace facet::brdf {
namespace {

using math::Vec3;

/// A value of a spectrum between its samples.
double at(const std::array<float, spectrum_size>& values, double wavelength_nm) {
    const double place = std::clamp((wavelength_nm - spectrum_first_nm) / spectrum_step_nm, 0.0,
                                    static_cast<double>(spectrum_size - 1));
    const auto below = std::min(static_cast<std::size_t>(place), spectrum_size - 2);
    const double share = place - static_cast<double>(below);
    return static_cast<double>(values[below]) * (1.0 - share) +
           static_cast<double>(values[below + 1]) * share;
}

/// The cosine at which F82's tint is given (Kutz et al. 2021, Section 2.3).
constexpr double tint_cosine = 1.0 / 7.0;

Preset metal_preset(std::size_t metal) {
    Preset out{
        .name = metal_spectra[metal].name, .is_metal = true, .source = metal_spectra[metal].source};
    const Vec3 f0 = metal_reflectance(metal, 1.0);
    const Vec3 f82 = metal_reflectance(metal, tint_cosine);
    Terms<float> terms;
    const Vec3 schlick = terms.f_schlick(f0, static_cast<float>(tint_cosine));
    out.f0 = glm::clamp(f0, 0.0F, 1.0F);
    out.is_clamped = out.f0 != f0;
    out.edge_tint = glm::clamp(f82 / schlick, 0.0F, 1.0F);
    return out;
}

std::vector<Preset> make_presets() {
    std::vector<Preset> all;
    for (std::size_t i = 0; i < metal_spectra.size(); ++i) all.push_back(metal_preset(i));
    for (const tables::Dielectric& row : tables::dielectrics) {
        const float root = (row.ior - 1.0F) / (row.ior + 1.0F);  // Born & Wolf 1999, Section 1.5.2
        all.push_back(
            {.name = row.name, .f0 = Vec3(root * root), .ior = row.ior, .source = row.source});
    }
    return all;
}

}  // namespace

Vec3 metal_reflectance(std::size_t metal, double cosine) {
    const MetalSpectrum& spectrum = metal_spectra[metal];
    Terms<double> terms;
    glm::dvec3 seen(0.0);
    glm::dvec3 white(0.0);
    for (std::size_t i = 0; i < math::d65.size(); ++i) {
        const math::Cie1931Row& row = math::cie_1931[i];
        const glm::dvec3 weight = math::d65[i] * glm::dvec3(row.x, row.y, row.z);
        white += weight;
        seen += weight * terms.f_conductor(cosine, at(spectrum.n, row.wavelength_nm),
                                           at(spectrum.k, row.wavelength_nm));
    }
    // A perfect reflector is white whatever the table's own white point rounds to.
    const Vec3 white_rgb = math::rec709_from_xyz(Vec3(white / white.y));
    return math::rec709_from_xyz(Vec3(seen / white.y)) / white_rgb;
}

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all = make_presets();
    return all;
}

base::Result<Preset> find_preset(std::string_view name) {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset;
        names.emplace_back(preset.name);
    }
    return base::fail({.code = base::ErrorCode::usage,
                       .what = "no such preset",
                       .found = std::string(name),
                       .remedy = base::suggestion(name, names)});
}

}  // namespace facet::brdf
