// Colour spaces: Rec.709 and CIE XYZ.
// SPDX-License-Identifier: MIT
#include "math/color.h"

namespace facet::math {
namespace {

struct Matrices {
    Mat3 xyz_from_rgb;
    Mat3 rgb_from_xyz;
};

Matrices derive() {
    using Vector = glm::dvec3;
    const auto xyz = [](double x, double y) { return Vector(x / y, 1.0, (1.0 - x - y) / y); };
    const glm::dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    const Vector scale = glm::inverse(primaries) * xyz(0.3127, 0.3290);
    const glm::dmat3 m(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
    return {Mat3(m), Mat3(glm::inverse(m))};
}

const Matrices& matrices() {
    static const Matrices derived = derive();  // a constant; constexpr GLM has no inverse
    return derived;
}

}  // namespace

Vec3 rec709_from_xyz(const Vec3& xyz) { return matrices().rgb_from_xyz * xyz; }
Vec3 xyz_from_rec709(const Vec3& linear) { return matrices().xyz_from_rgb * linear; }

}  // namespace facet::math
