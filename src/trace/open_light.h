// Light that would arrive if nothing stood in its way: known without a ray.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/path.h"

namespace facet::trace {

/// What the specular lobe would send on of the sky if nothing stood in the way, in nit: the mean of
/// `draws` numbered draws of sequence (number, seed), without a ray.
[[nodiscard]] math::Vec3 open_specular(const World& world, const Surface& surface,
                                       const math::Vec3& to_eye, std::uint32_t number,
                                       std::uint32_t seed, std::uint32_t draws);

/// Irradiance / pi of level ground by the sky and the listed lights, in nit.
[[nodiscard]] math::Vec3 open_ground(const World& world, const math::Vec3& position_m);

}  // namespace facet::trace
