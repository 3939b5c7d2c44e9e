// The library's front door: one request, one picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/progress.h"
#include "base/result.h"
#include "image/image.h"
#include "image/read.h"
#include "scene/scene.h"
#include "tables/settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facet::render {

/// What a user asks for: a scene by name ("builtin:showcase", a path, "-") and the settings.
struct Request {
    std::string scene;
    tables::Settings settings;
    bool want_linear =
        false;  ///< the output holds radiance (EXR, HDR): 32-bit float beauty is returned too
    std::filesystem::path cache_folder{};  ///< where what can be computed again is kept, or none
};

/// Milliseconds of wall clock.
struct Times {
    double load = 0.0;
    double upload = 0.0;
    double render = 0.0;
    double write = 0.0;
};

/// How a reference came about.
struct ReferenceReport {
    double samples = 0.0;  ///< per pixel, on average
    double noise = 0.0;    ///< estimated root mean square error in display values
    std::uint64_t paths = 0;
    std::uint64_t rays = 0;
    bool stopped_by_time = false;
    double build_s = 0.0;
    double trace_s = 0.0;
};

/// Raster against reference, as they are displayed.
struct Compared {
    double rmse = 0.0;  ///< over pixels that both cover
    double psnr_db = 0.0;
    double max_error = 0.0;
    double flip = 0.0;  ///< mean LDR-FLIP over all pixels
    std::uint64_t pixels = 0;
};

/// A finished picture.
struct Rendered {
    math::Extent size;
    image::Image display;  ///< RGBA u8 or u16 (--depth 16), in codes of --gamut, straight alpha;
                           ///< empty for want_linear
    std::vector<image::Layer>
        layers;             ///< f32: beauty "" first (want_linear only), then the AOVs asked for
    double exposure = 1.0;  ///< the factor used
    std::string backend;    ///< "egl (llvmpipe (LLVM 15.0.6, 256 bits))"
    std::uint64_t triangles = 0;
    std::size_t materials = 0;
    std::optional<ReferenceReport> reference;
    std::optional<Compared>
        compared;  ///< --compare; `display` is then the two and their difference side by side,
                   ///< and `layers` has "reference" and "difference" behind the raster
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;
    Times ms;
};

/// Loads, uploads, renders. `progress` hears of the reference's samples. Errors: those of the
/// loader, of the settings (usage), no_backend, limit_reached.
[[nodiscard]] base::Result<Rendered> render(const Request& request, base::Log& log,
                                            const base::Progress& progress = {});

/// render() and the file, or files: AOVs go into an EXR, or beside other formats as STEM.AOV.png.
/// The format is chosen by `output`'s ending. Everything that can be refused is refused before
/// rendering.
[[nodiscard]] base::Result<Rendered> render_to_file(const Request& request,
                                                    const std::filesystem::path& output,
                                                    base::Log& log,
                                                    const base::Progress& progress = {});

}  // namespace facet::render
