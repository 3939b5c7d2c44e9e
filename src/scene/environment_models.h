// The computed environments as functions of direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

namespace facet::scene {

/// Radiance in nit of the photo studio from the unit direction `d`.
[[nodiscard]] math::Vec3 studio_radiance(const math::Vec3& d);

/// CIE standard overcast sky (CIE S 011/E:2003, type 16 after Moon & Spencer 1942): L = L_z (1 + 2 sin e) / 3 with
/// L_z = 1 nit, over ground of albedo 0.2 that sees it.
[[nodiscard]] math::Vec3 overcast_radiance(const math::Vec3& d);

struct SkyParameters {
    float sun_elevation_deg = 30.0F;  ///< [0, 90]
    float sun_azimuth_deg = 60.0F;    ///< 0 is +z, 90 is +x
    float turbidity = 3.0F;           ///< [1.9, 10]: clear mountain air to haze
    float ground_albedo = 0.2F;       ///< [0, 1]
};

/// Clear sky and sun: Preetham, Shirley & Smits 1999, "A Practical Analytic Model for Daylight", appendices A.1 to
/// A.3. Real luminances divided by 10000, so that the sun's disc stays within half floats.
class Sky {
public:
    explicit Sky(const SkyParameters& parameters);
    /// Radiance in nit from the unit direction `d`, without the sun's disc; the ground below the horizon.
    [[nodiscard]] math::Vec3 radiance(const math::Vec3& d) const;
    [[nodiscard]] const math::Vec3& to_sun() const { return to_sun_; }
    [[nodiscard]] const math::Vec3& sun_illuminance_lux() const { return sun_illuminance_; }

private:
    [[nodiscard]] math::Vec3 sky_radiance(const math::Vec3& d) const;
    void measure_ground(float albedo);

    /// Perez's five coefficients of Y, x, y.
    struct Perez {
        float a, b, c, d, e;
        [[nodiscard]] float at(float cos_theta, float gamma) const;
    };
    Perez perez_[3]{};
    math::Vec3 zenith_{};          ///< Y (nit, scaled), x, y
    math::Vec3 normalization_{};   ///< Perez's function at the zenith
    math::Vec3 to_sun_{};
    math::Vec3 sun_illuminance_{};  ///< at normal incidence, scaled as the sky is
    math::Vec3 ground_radiance_{};
};

}  // namespace facet::scene
