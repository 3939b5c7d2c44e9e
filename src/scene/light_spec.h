// Lights from text: what --light and --set light.NAME.KEY say.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <string_view>

namespace facet::scene {

/// The light that `spec` describes: `KIND:key=value,…` with the keys of the kind's row in
/// tables/light_kinds.def. Vectors are `x y z` in metres, angles degrees; `azimuth` and `elevation`
/// say where the light comes from, `target` where it shines to; `inner` and `outer` are half
/// angles. `color` is `#rrggbb` (sRGB) or `r g b` (linear) and multiplies the colour of
/// `temperature` (kelvin). `lux` is that of a facing surface; lumen become candela as flux / (4 pi)
/// for a point, flux / (2 pi (1 - cos outer)) for a spot, by its profile for an IES lamp, whose
/// `file` sets its candela too. Left out: 3 lux from azimuth 0, elevation 45; 10 candela at the
/// origin; a spot shines at the origin, or straight down from there; the light's name is its kind.
/// Errors: usage (unknown kind or key, with the nearest right ones; a value out of its range, with
/// the range), feature_missing (a kind or key that is not there yet), those of read_profile().
[[nodiscard]] base::Result<Light> parse_light(const std::string& spec);

/// Where a light comes from, as its keys `azimuth` and `elevation` say it.
struct SkyAngles {
    float azimuth_deg = 0.0F;
    float elevation_deg = 0.0F;
};
[[nodiscard]] SkyAngles sky_angles(const Light& light);

/// Changes one value of a light; keys and errors as above. `color` and `temperature` replace the
/// colour, `azimuth` keeps the elevation and the other way round. On an error the light is as it
/// was.
[[nodiscard]] base::Status set_light_key(Light& light, std::string_view key,
                                         std::string_view value);

/// `spec` with `change` applied to the value of its `file`, where it has one.
[[nodiscard]] base::Result<std::string> with_light_file(
    const std::string& spec,
    const std::function<base::Result<std::string>(const std::string&)>& change);

/// The value of a key as set_light_key() takes it; empty where the light has none (its temperature:
/// only the colour is kept).
[[nodiscard]] std::string light_key_text(const Light& light, std::string_view key);

}  // namespace facet::scene
