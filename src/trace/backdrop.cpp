// What shows behind a scene.
// SPDX-License-Identifier: MIT
#include "trace/backdrop.h"

namespace facet::trace {
namespace {

using math::Vec3;

/// A direction of the lobe that the prefiltered environment has along `axis`: light that a facet
/// reflects to a viewer on the axis, weighted with its cosine (Karis 2013, "Real Shading in Unreal
/// Engine 4", p. 4).
Vec3 blurred(const Vec3& axis, float roughness, Sequence& sequence) {
    const LobeFrame frame(axis);
    constexpr int most_tries = 16;  // a lobe of roughness 1 keeps one draw in two
    for (int i = 0; i < most_tries; ++i) {
        const Vec3 h =
            Lobes{}.sample_ggx({0.0F, 0.0F, 1.0F}, roughness * roughness, sequence.next_pair());
        const Vec3 l(2.0F * h.z * h.x, 2.0F * h.z * h.y, 2.0F * h.z * h.z - 1.0F);
        if (sequence.next() < l.z) return frame.x * l.x + frame.y * l.y + axis * l.z;
    }
    return axis;
}

}  // namespace

EnvironmentLight::Light backdrop(const World& world, const Vec3& direction, Sequence& sequence) {
    return world.environment.at(world.blur > 0.0F ? blurred(direction, world.blur, sequence)
                                                  : direction);
}

}  // namespace facet::trace
