// Colour: transfer functions and luminance. Linear is Rec.709 primaries, D65 white, unless a name
// says so. SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cmath>

namespace facet::math {

/// sRGB transfer, IEC 61966-2-1:1999, clause 4.2; linear [0, 1] -> encoded [0, 1]. Odd outside, not
/// clamped.
[[nodiscard]] inline float srgb_from_linear(float linear) {
    const float x = std::fabs(linear);
    const float y = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
    return std::copysign(y, linear);
}
/// Inverse of srgb_from_linear.
[[nodiscard]] inline float linear_from_srgb(float encoded) {
    const float x = std::fabs(encoded);
    const float y = x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
    return std::copysign(y, encoded);
}
/// Relative luminance Y of linear Rec.709 (ITU-R BT.709-6, 3.2).
[[nodiscard]] inline float luminance(const Vec3& linear) {
    return 0.2126F * linear.x + 0.7152F * linear.y + 0.0722F * linear.z;
}

/// CIE XYZ (white at Y = 1) to linear Rec.709 and back, by the matrix of the primaries and D65 of
/// ITU-R BT.709-6, 1.3 and 1.4; computed, so that no rounded copy of it stands anywhere. Not
/// clamped.
[[nodiscard]] Vec3 rec709_from_xyz(const Vec3& xyz);
[[nodiscard]] Vec3 xyz_from_rec709(const Vec3& linear);

/// Linear Rec.709 to other primaries with the same white: Display P3 (SMPTE EG 432-1 with D65),
/// Rec.2020 (ITU-R BT.2020-2, Table 2).
[[nodiscard]] Mat3 p3_from_rec709();
[[nodiscard]] Mat3 rec2020_from_rec709();
/// Linear Rec.709 as seen by eyes used to light of colour `white`, linear Rec.709 itself: it
/// becomes grey of the same luminance. Von Kries in Bradford's space (Lam 1985; CIE 159:2004).
[[nodiscard]] Mat3 adapted_from(const Vec3& white);

}  // namespace facet::math
