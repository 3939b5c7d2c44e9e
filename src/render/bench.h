// The benchmark: how long a frame takes, synchronised, after warm-up.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/result.h"
#include "tables/lights.h"
#include "tables/settings.h"

#include <string>
#include <vector>

namespace facet::render {

struct BenchRequest {
    std::string scene = "builtin:showcase";
    tables::Settings settings;
    std::uint32_t lights = 0;  ///< local lights, besides the one directional light
    std::vector<tables::LightKind> kinds = {tables::LightKind::point};
    std::uint32_t frames = 30;
    bool passes = false;  ///< time each pass too, each waited for
};

struct BenchResult {
    math::Extent size;
    std::string backend;
    unsigned threads = 0;
    double median_ms = 0.0;
    double p5_ms = 0.0;
    double p95_ms = 0.0;
    double gbuffer_ms = 0.0;  ///< medians of the passes; 0 where not asked for
    double lighting_ms = 0.0;
    double post_ms = 0.0;
    double first_frame_ms = 0.0;
    double peak_rss_mb = 0.0;
    double reach = 0.0;  ///< local lights that reach a surface point, on average
};

/// The reference's speed: medians over `request.frames` runs of the same picture.
struct ReferenceBenchResult {
    math::Extent size;
    unsigned threads = 0;
    std::uint32_t samples = 0;
    double median_s = 0.0;
    double build_s = 0.0;
    double paths_per_s = 0.0;
    double rays_per_path = 0.0;
    double covered = 0.0;  ///< share of the picture that the scene covers: the rest are short paths
    double peak_rss_mb = 0.0;
};
/// Traces with the request's `settings.reference` samples; `lights` as bench(). No GL.
[[nodiscard]] base::Result<ReferenceBenchResult> bench_reference(const BenchRequest& request);

/// A frame is G-buffer, lighting, background, blended surfaces and display encoding of one sample a
/// pixel; reading back and writing files are not in it. Errors: as render().
[[nodiscard]] base::Result<BenchResult> bench(const BenchRequest& request, base::Log& log);

}  // namespace facet::render
