// The settings of a request, understood: every text parsed and checked before any work starts.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "frame/background/background.h"
#include "frame/view.h"
#include "gl/context.h"
#include "image/image.h"
#include "tables/aovs.h"
#include "tables/brdf_terms.h"
#include "tables/gamuts.h"
#include "tables/qualities.h"
#include "tables/settings.h"
#include "tables/tonemaps.h"

#include <optional>
#include <string>
#include <vector>

namespace facet::render {

/// What --reference asks for.
struct ReferencePlan {
    std::uint32_t samples = 0;    ///< per pixel; at most, where `noise` is given
    std::optional<double> noise;  ///< root mean square error in display values
    std::optional<double> time_s;
};

struct Plan {
    math::Extent picture;
    frame::Region region;
    image::Sample display_sample = image::Sample::u8;
    std::uint32_t sample_count = 1;
    bool is_draft = false;
    frame::Background background;
    std::optional<double> exposure;  ///< none: automatic
    tables::Tonemap tonemap = tables::Tonemap::pbr_neutral;
    bool has_ocio = false;  ///< the display is OpenColorIO's, and no tone curve of ours
    std::string ocio_display, ocio_view;  ///< empty: the configuration's defaults
    tables::Gamut gamut = tables::Gamut::srgb;
    math::Mat3 balance{1.0F};  ///< white balance: of linear Rec.709, before the tone curve
    bool has_ground = false;
    std::optional<float> ground_m;  ///< none: as low as the scene
    bool has_probe = false;
    std::optional<math::Vec3> probe_m;  ///< none: the middle of the scene
    bool is_panorama = false;
    bool is_resampled = false;  ///< the rasteriser's flat views are not the picture
    tables::BrdfChoice brdf;
    std::vector<tables::Aov> aovs;
    tables::RayBudget rays;
    bool has_maps = false;  ///< shadow maps and horizon occlusion, in the rays' place
    std::optional<ReferencePlan> reference;
    gl::Backend backend = gl::Backend::automatic;
    base::Limits limits;
};

/// Whether the settings play an animation of the scene's file, should it have one.
[[nodiscard]] inline bool plays_animation(const tables::Settings& settings) {
    return settings.time.has_value() || !settings.animation.empty();
}

/// Errors: usage, naming the option and what it takes.
[[nodiscard]] base::Result<Plan> make_plan(const tables::Settings& settings);

}  // namespace facet::render
