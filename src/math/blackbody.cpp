// Colour of a black body by temperature.
// SPDX-License-Identifier: MIT
#include "math/blackbody.h"

#include "math/cie_1931.h"
#include "math/color.h"

#include <cmath>

namespace facet::math {
namespace {

using Xy = glm::dvec2;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;

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

/// XYZ (white at Y = 1) to linear Rec.709, from the primaries and D65 of ITU-R BT.709-6, 1.3
/// and 1.4, so that no rounded copy of the matrix stands anywhere.
DMat3 rec709_from_xyz() {
    const auto xyz = [](const Xy& c) { return DVec3(c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y); };
    const DMat3 primaries(xyz({0.64, 0.33}), xyz({0.30, 0.60}), xyz({0.15, 0.06}));
    const DVec3 white = xyz({0.3127, 0.3290});
    const DVec3 scale = glm::inverse(primaries) * white;
    return glm::inverse(
        DMat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z));
}

}  // namespace

Vec3 blackbody_color(float temperature_k) {
    const DVec3 rgb = rec709_from_xyz() * xyz_of(static_cast<double>(temperature_k));
    const Vec3 cut = glm::max(Vec3(rgb), Vec3(0.0F));
    return cut / luminance(cut);
}

}  // namespace facet::math
