// Vectors, matrices and small geometry: the only file that names GLM.
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>

namespace facet::math {

using DVec3 = glm::dvec3;
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;
using Quat = glm::quat;

using glm::cross;
using glm::dot;
using glm::inverse;
using glm::length;
using glm::normalize;
using glm::transpose;

inline constexpr float pi = 3.14159265358979323846F;

/// Width and height in pixels.
struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool operator==(const Extent&) const = default;
    [[nodiscard]] std::uint64_t pixels() const noexcept {
        return std::uint64_t{width} * std::uint64_t{height};
    }
};

/// Axis-aligned box; empty where `low` is above `high`.
struct Bounds {
    Vec3 low{1e30F};
    Vec3 high{-1e30F};
    [[nodiscard]] bool is_empty() const noexcept { return low.x > high.x; }
    void add(const Vec3& point) noexcept {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] Vec3 center() const noexcept {
        return is_empty() ? Vec3(0.0F) : (low + high) * 0.5F;
    }
    [[nodiscard]] float diagonal() const noexcept { return is_empty() ? 0.0F : length(high - low); }
};

/// Turns normals as `m` turns surfaces, by the cofactors: right for any scale, also where the
/// inverse does not exist. Not normalised.
[[nodiscard]] inline Mat3 normal_matrix(const Mat3& m) {
    const float handedness = dot(cross(m[0], m[1]), m[2]) < 0.0F ? -1.0F : 1.0F;
    return {cross(m[1], m[2]) * handedness, cross(m[2], m[0]) * handedness,
            cross(m[0], m[1]) * handedness};
}

/// Unit direction towards (azimuth, elevation): azimuth 0 is +z, 90 is +x; elevation 90 is +y
/// (contract).
[[nodiscard]] inline Vec3 direction_from(float azimuth_deg, float elevation_deg) {
    const float a = glm::radians(azimuth_deg);
    const float e = glm::radians(elevation_deg);
    return {glm::sin(a) * glm::cos(e), glm::sin(e), glm::cos(a) * glm::cos(e)};
}

}  // namespace facet::math
