// Colour spaces: Rec.709 and CIE XYZ.
// SPDX-License-Identifier: MIT
#include "math/color.h"

namespace facet::math {
namespace {

struct Matrices {
    Mat3 xyz_from_rgb;
    Mat3 rgb_from_xyz;
};

/// Columns: what the primaries are in XYZ, each by its chromaticity, scaled to the white of D65.
glm::dmat3 xyz_from_primaries(const glm::dmat3x2& xy) {
    using Vector = glm::dvec3;
    const auto xyz = [](double x, double y) { return Vector(x / y, 1.0, (1.0 - x - y) / y); };
    const glm::dmat3 primaries(xyz(xy[0].x, xy[0].y), xyz(xy[1].x, xy[1].y), xyz(xy[2].x, xy[2].y));
    const Vector scale = glm::inverse(primaries) * xyz(0.3127, 0.3290);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

glm::dmat3 xyz_from_rec709() {
    return xyz_from_primaries({{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}});
}

Matrices derive() {
    const glm::dmat3 m = xyz_from_rec709();
    return {Mat3(m), Mat3(glm::inverse(m))};
}

const Matrices& matrices() {
    static const Matrices derived = derive();  // a constant; constexpr GLM has no inverse
    return derived;
}

}  // namespace

Vec3 rec709_from_xyz(const Vec3& xyz) { return matrices().rgb_from_xyz * xyz; }
Vec3 xyz_from_rec709(const Vec3& linear) { return matrices().xyz_from_rgb * linear; }

Mat3 p3_from_rec709() {
    return Mat3(glm::inverse(xyz_from_primaries({{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}})) *
                xyz_from_rec709());
}
Mat3 rec2020_from_rec709() {
    return Mat3(glm::inverse(xyz_from_primaries({{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}})) *
                xyz_from_rec709());
}

Mat3 adapted_from(const Vec3& white) {
    const glm::dmat3 cone_from_xyz(0.8951, -0.7502, 0.0389,  // columns
                                   0.2664, 1.7135, -0.0685,  //
                                   -0.1614, 0.0367, 1.0296);
    const glm::dmat3 cone_from_rgb = cone_from_xyz * xyz_from_rec709();
    const glm::dvec3 from = cone_from_rgb * glm::dvec3(white);
    const glm::dvec3 to = cone_from_rgb * glm::dvec3(static_cast<double>(luminance(white)));
    glm::dmat3 gain(0.0);
    for (int c = 0; c < 3; ++c) gain[c][c] = to[c] / from[c];
    return Mat3(glm::inverse(cone_from_rgb) * gain * cone_from_rgb);
}

}  // namespace facet::math
