// Light profiles: how bright a measured lamp is by direction, from IES LM-63 files.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene {

/// Steps of a profile's table: half a degree from straight ahead to straight back, five degrees
/// around. lighting/profile.glsl has the same numbers.
inline constexpr std::size_t profile_rows = 361;
inline constexpr std::size_t profile_columns = 73;  ///< the last is the first again

struct LightProfile {
    std::string file;
    float candela = 0.0F;           ///< in the brightest direction
    float flux_per_candela = 0.0F;  ///< lumen of all directions, by `candela`
    std::vector<float> shares;      ///< [profile_rows, profile_columns], of `candela`
};

/// What an IES file says: LM-63 of 1986, 1991, 1995 or 2002, type C photometry, with or without
/// tilt. Candela are as in the file, times its multiplier and factors. What it leaves out by
/// symmetry is completed; beyond the angles that it gives it is dark. Errors: input_invalid (names
/// the line), feature_missing (types A and B).
[[nodiscard]] base::Result<LightProfile> parse_profile(std::string_view text);

/// The same from a file of at most 4 MiB, or "builtin:NAME" (a file of resources/lamps); `file` is
/// that name. Errors: usage too, where there is no such lamp.
[[nodiscard]] base::Result<LightProfile> read_profile(const std::string& name);

/// The lamp's axes, as glsl/light/profile.glsl has them: azimuth 0 is level, and to the right of a
/// lamp that shines down as one looks along -z.
[[nodiscard]] LightAxes profile_axes(const Light& light);

/// Share of the brightest direction that a light with a profile sends along `direction` (unit):
/// linear between the table's steps.
[[nodiscard]] float profile_share(const Light& light, const Vec3& direction);

}  // namespace facet::scene
