// A picture's surfaces as a rasteriser saw them.
// SPDX-License-Identifier: MIT
#include "trace/seen.h"

#include <cmath>

namespace facet::trace {

Ray Seen::ray(std::uint32_t x, std::uint32_t y) const {
    const math::Vec2 at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    const math::Vec2 ndc =
        at / math::Vec2(size.width, size.height) * 2.0F - 1.0F;  // y up, as the rows go
    const math::Vec4 near = world_from_clip * math::Vec4(ndc, -1.0F, 1.0F);
    const math::Vec3 place = math::Vec3(near) / near.w;
    Ray ray;
    ray.origin = is_perspective ? eye_m : place;
    ray.direction = is_perspective ? math::normalize(place - eye_m) : forward;
    return ray;
}

float packed_normal(const math::Vec3& n) {
    // As lib/octahedral.glsl.
    const float sum = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
    math::Vec2 p(n.x / sum, n.y / sum);
    if (n.z < 0.0F)
        p = {(1.0F - std::fabs(p.y)) * (p.x >= 0.0F ? 1.0F : -1.0F),
             (1.0F - std::fabs(p.x)) * (p.y >= 0.0F ? 1.0F : -1.0F)};
    constexpr float steps = 4095.0F;
    return std::round((p.x * 0.5F + 0.5F) * steps) * (steps + 1.0F) +
           std::round((p.y * 0.5F + 0.5F) * steps);
}

}  // namespace facet::trace
