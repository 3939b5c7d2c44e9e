// The computed environments as functions of direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <vector>

namespace facet::scene {

/// A photo studio: soft boxes in a pale room, about 1 nit on average.
class Studio {
public:
    Studio();
    /// Radiance in nit of the walls, floor and ceiling at the height `y` of a unit direction.
    [[nodiscard]] static math::Vec3 room(float y);
    /// Radiance in nit that the boxes add to it in the unit direction `d`.
    [[nodiscard]] math::Vec3 boxes(const math::Vec3& d) const;

private:
    /// A flat rectangular light far away, facing the origin.
    struct Box {
        math::Vec3 forward, right, up;  ///< right and up over the tangent of the half size
        math::Vec3 radiance_nit;        ///< of its middle
        float falloff;  ///< how much darker its rim is, where the lamp sits behind the cloth
    };
    std::vector<Box> boxes_;
};

/// CIE standard overcast sky (CIE S 011/E:2003, type 16 after Moon & Spencer 1942): L = L_z (1 + 2
/// sin e) / 3 with L_z = 1 nit, over ground of albedo 0.2 that sees it.
[[nodiscard]] math::Vec3 overcast_radiance(float y);

struct SkyParameters {
    float sun_elevation_deg = 30.0F;  ///< [0, 90]
    float sun_azimuth_deg = 60.0F;    ///< 0 is +z, 90 is +x
    float turbidity = 3.0F;           ///< [1.9, 10]: clear mountain air to haze
    float ground_albedo = 0.2F;       ///< [0, 1]
};

/// Clear sky and sun: Preetham, Shirley & Smits 1999, "A Practical Analytic Model for Daylight",
/// appendices A.1 to A.3. Real luminances divided by 10000, so that the sun's disc stays within
/// half floats.
class Sky {
public:
    explicit Sky(const SkyParameters& parameters);
    /// What one height of the sky has in common.
    struct Row {
        float ground = 0.0F;        ///< share of the ground, 0 to 1
        math::Vec3 gradient{0.0F};  ///< of Y, x, y: Perez's factor of the height, times the zenith
    };
    [[nodiscard]] Row row(float y) const;
    /// Radiance in nit from the unit direction `d` of the row, without the sun's disc; below the
    /// horizon the ground.
    [[nodiscard]] math::Vec3 radiance(const Row& row, const math::Vec3& d) const;
    [[nodiscard]] const math::Vec3& to_sun() const { return to_sun_; }
    [[nodiscard]] const math::Vec3& sun_illuminance_lux() const { return sun_illuminance_; }

private:
    [[nodiscard]] math::Vec3 sky_radiance(const Row& row, const math::Vec3& d) const;
    void measure_ground(float albedo);

    /// Perez's five coefficients of Y, x, y.
    struct Perez {
        float a, b, c, d, e;
        [[nodiscard]] float gradient(float cos_theta) const;
        [[nodiscard]] float indicatrix(float gamma, float cos_gamma) const;
    };
    Perez perez_[3]{};
    math::Vec3 zenith_{};  ///< Y (nit, scaled), x, y
    math::Vec3 to_sun_{};
    math::Vec3 sun_illuminance_{};  ///< at normal incidence, scaled as the sky is
    math::Vec3 ground_radiance_{};
};

}  // namespace facet::scene
