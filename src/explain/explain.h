// The rendering equation at pixels of a picture: every number of it, from the frame's own shaders.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "frame/explain/explained.h"
#include "render/render.h"
#include "tables/brdf_terms.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace facet::explain {

namespace shared = frame::shared;
using math::DVec3;

/// Radiance in nit that one light, or the environment, sends to the eye by either lobe.
struct Contribution {
    DVec3 diffuse{0.0};
    DVec3 specular{0.0};
    [[nodiscard]] DVec3 sum() const { return diffuse + specular; }
};
[[nodiscard]] Contribution of_light(const shared::ExplainedLight& light);
/// With occlusion.
[[nodiscard]] Contribution of_environment(const shared::ExplainedSurface& surface);
/// Where white light from everywhere goes; all four add up to 1.
struct Balance {
    DVec3 reflected{0.0};
    DVec3 transmitted{0.0};   ///< refracted, and back again
    DVec3 gone_through{0.0};  ///< to the far side
    DVec3 absorbed{0.0};
};
[[nodiscard]] Balance balance_of(const shared::ExplainedSurface& surface);
/// What a surface shows in nit, before its opacity: emission, and light where it is not unlit.
[[nodiscard]] DVec3 shown_by(const frame::ExplainedPoint& point);

/// One jittered sample: what is opaque or behind all, and what lies over it.
struct Composite {
    DVec3 radiance{0.0};  ///< nit, associated
    double alpha = 0.0;
};
[[nodiscard]] Composite composed(const frame::ExplainedPixel& sample);

struct Pixel {
    std::uint32_t x = 0;  ///< of the picture; 0, 0 is top left
    std::uint32_t y = 0;
    std::vector<frame::ExplainedPixel> samples;
    std::size_t shown = 0;  ///< the sample nearest to the pixel's centre
    DVec3 sum{0.0};  ///< mean of the samples' radiance, nit, over the named background colour
    double alpha = 0.0;
    std::array<std::uint32_t, 4> code{};  ///< of the picture's file: 8 or 16 bits, straight alpha
};

struct Explained {
    std::vector<Pixel> pixels;
    math::Extent picture;
    double exposure = 1.0;
    bool is_exposure_automatic = false;
    std::string tonemap;
    std::string gamut;
    std::optional<float> white_balance_k;
    std::uint32_t bits = 8;
    tables::BrdfChoice brdf;
    scene::Scene scene;  ///< materials, lights and textures by name
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;
};

struct PixelRequest {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

/// Renders as render() does and explains. Errors: those of render(); usage (a pixel outside the
/// picture, a reference or AOVs asked for).
[[nodiscard]] base::Result<Explained> explain(const render::Request& request,
                                              const std::vector<PixelRequest>& pixels,
                                              base::Log& log, const base::Progress& progress);

}  // namespace facet::explain
