// Projections that a flat view has not.
// SPDX-License-Identifier: MIT
#include "scene/projection.h"

#include <algorithm>
#include <cmath>

namespace facet::scene {

Vec3 panorama_direction(Vec2 place) {
    const float longitude = (place.x - 0.5F) * 2.0F * math::pi;
    const float latitude = (0.5F - place.y) * math::pi;
    const float ring = std::cos(latitude);
    return {std::sin(longitude) * ring, std::sin(latitude), -std::cos(longitude) * ring};
}

Vec2 source_of(const Camera& camera, math::Extent size, Vec2 at_px, int channel) {
    const Vec2 middle = Vec2(size.width, size.height) * 0.5F;
    const Vec2 off = at_px - middle;
    const float r2 = (off.x * off.x + off.y * off.y) / (middle.x * middle.x + middle.y * middle.y);
    // What shows larger comes from nearer to the middle.
    const float larger = 1.0F + 0.5F * camera.aberration * static_cast<float>(1 - channel);
    return middle + off * ((1.0F + camera.distortion * r2) / larger);
}

float overscan(const Camera& camera) {
    return std::max(1.0F, (1.0F + std::max(camera.distortion, 0.0F)) /
                              (1.0F - 0.5F * std::fabs(camera.aberration)));
}

bool bends(const Camera& camera) { return camera.distortion != 0.0F || camera.aberration != 0.0F; }

}  // namespace facet::scene
