// What is known of the pixel under the mouse: the numbers of the frame's shaders there, the lobes
// of its BRDF, and where the light that falls on it goes. SPDX-License-Identifier: MIT
#pragma once

#include "studio/analysis.h"
#include "studio/stage.h"
#include "tables/brdf_terms.h"

#include <array>
#include <optional>
#include <vector>

namespace facet::studio {

/// The BRDF in the plane of the view and the normal, by the light's angle from the normal: -90
/// degrees on the view's side to 90 on the mirror's.
struct Lobes {
    static constexpr std::size_t count = 181;
    std::array<float, count> specular{};  ///< 1/sr
    std::array<float, count> diffuse{};
    float view_deg = 0.0F;  ///< of the view, on the negative side
};

/// Shares of white light from everywhere.
struct Energy {
    float reflected = 0.0F;  ///< by the surface
    float scattered = 0.0F;  ///< refracted, and out again: diffuse
    float absorbed = 0.0F;
};

struct PixelFacts {
    math::Vec2 at_px{0.0F};
    std::vector<Probed> values;
    bool is_background = true;
    math::Vec3 albedo{0.0F};
    float roughness = 0.0F;
    float metallic = 0.0F;
    float n_dot_v = 0.0F;
    Lobes lobes;
    Energy energy;
};

/// What the inspector shows.
struct Inspection {
    std::optional<PixelFacts> pixel;
    std::optional<Histogram> histogram;
    /// Raster against reference, where that is beside it.
    struct Against {
        double samples = 0.0;
        double rmse = 0.0;
        double flip = 0.0;
        bool is_known = false;
    } against;
};

/// From a probe's values; lobes and energy are of the surface's luminance.
[[nodiscard]] PixelFacts facts_of(math::Vec2 at_px, std::vector<Probed> values,
                                  const math::Vec3& eye_m, const tables::BrdfChoice& brdf);

}  // namespace facet::studio
