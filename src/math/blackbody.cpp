// Colour of a black body by temperature.
// SPDX-License-Identifier: MIT
#include "math/blackbody.h"

#include "math/cie_1931.h"
#include "math/color.h"

#include <cmath>

namespace facet::math {
namespace {

using DVec3 = glm::dvec3;

DVec3 xyz_of(double temperature_k) {
    constexpr double c2_m_k = 1.438776877e-2;
    constexpr double m_per_nm = 1e-9;
    DVec3 sum(0.0);
    for (const Cie1931Row& row : cie_1931) {
        const double wavelength_m = row.wavelength_nm * m_per_nm;
        // Planck's law to a factor: the sum is normalised, and 560 nm keeps the fifth power near 1.
        const double shape = std::pow(560.0 / row.wavelength_nm, 5.0) /
                             std::expm1(c2_m_k / (wavelength_m * temperature_k));
        sum += shape * DVec3(row.x, row.y, row.z);
    }
    return sum / sum.y;
}

}  // namespace

Vec3 blackbody_color(float temperature_k) {
    const Vec3 rgb = rec709_from_xyz(Vec3(xyz_of(static_cast<double>(temperature_k))));
    const Vec3 cut = glm::max(rgb, Vec3(0.0F));
    return cut / luminance(cut);
}

}  // namespace facet::math
