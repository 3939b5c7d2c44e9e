// The reference: a picture by path tracing, of the same scene, camera, lights and BRDF as the
// rasteriser's. SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "image/read.h"
#include "scene/environment.h"
#include "scene/key_light.h"
#include "scene/scene.h"
#include "tables/aovs.h"
#include "tables/brdf_terms.h"
#include "trace/seen.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace facet::trace {

/// What is traced. Everything outlives the Tracer.
struct TraceInputs {
    const scene::Scene& scene;
    const scene::Environment& environment;
    const scene::Camera& camera;
    float env_rotation_deg = 0.0F;
    float env_intensity = 1.0F;
    bool shows_environment = true;  ///< where no surface is; else nothing, of coverage 0
    float background_blur =
        0.0F;  ///< of the environment shown: roughness of the lobe it is seen through, [0, 1]
    tables::BrdfChoice brdf;
    scene::KeyLight key_light{};                     ///< for AOVs that are terms of the BRDF
    std::optional<scene::Light> sun = std::nullopt;  ///< one more light, behind the scene's
};

struct TraceSettings {
    math::Extent picture;  ///< of which the part at x, y of `size` is traced
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    math::Extent size;
    std::uint32_t samples = 64;      ///< per pixel at most
    std::uint32_t first = 0;         ///< of them among the picture's
    std::uint32_t whole = 0;         ///< the picture's, where these are a part of them
    math::Vec2 shutter{0.0F, 1.0F};  ///< the part of its time in which they are taken
    std::optional<double>
        noise;              ///< stop where the picture's error in display values is below this
    double exposure = 1.0;  ///< for `noise`: what display values are
    std::optional<double> time_s;  ///< stop after this long; what is there is the picture
    std::uint32_t seed = 0;
    std::vector<tables::Aov> light_paths;  ///< rows of that kind to give beside the picture
    std::uint32_t bounces = 64;       ///< after the first surface; paths end by chance long before
    std::uint32_t largest_pass = 16;  ///< samples that each pixel gets at a time
    const std::atomic<bool>* cancelled =
        nullptr;  ///< looked at often; once it is true, what is there is the picture
};
/// Sees the picture after each pass, and its samples per pixel.
using Preview = std::function<void(const image::Image& radiance, double samples)>;

struct Traced {
    image::Image radiance;                  ///< f32 [height, width, 4] in nit, coverage associated
    std::vector<image::Layer> light_paths;  ///< as asked, f32 in nit
    double samples = 0.0;                   ///< per pixel, on average
    double noise = 0.0;                     ///< estimated root mean square error in display values
    std::uint64_t paths = 0;
    std::uint64_t rays = 0;
    std::uint64_t not_finite = 0;  ///< samples left out
    bool stopped_by_time = false;
    double build_s = 0.0;
    double trace_s = 0.0;
};

class Tracer {
public:
    /// Sorts the triangles and prepares lights and textures. Errors: limit_reached (memory).
    [[nodiscard]] static base::Result<Tracer> create(const TraceInputs& inputs,
                                                     const base::Limits& limits,
                                                     base::ThreadPool& pool);
    Tracer(Tracer&&) noexcept;
    Tracer& operator=(Tracer&&) noexcept;
    ~Tracer();

    /// Sorts the triangles and lights again after instances, meshes or lights of the scene have
    /// moved. Errors: as create().
    [[nodiscard]] base::Status follow_scene(const base::Limits& limits);

    /// The same bytes for any number of threads (but for time_s).
    [[nodiscard]] Traced trace(const TraceSettings& settings, base::ThreadPool& pool,
                               const base::Progress& progress = {},
                               const Preview& preview = {}) const;

    /// What the camera meets first, a layer each (tables/aovs.def) but for light paths; means are
    /// of `samples` rays, 16 at most.
    [[nodiscard]] std::vector<image::Layer> aovs(const TraceSettings& settings,
                                                 const std::vector<tables::Aov>& aovs,
                                                 base::ThreadPool& pool) const;

    /// For a rasteriser's picture: see seen.h.
    [[nodiscard]] IndirectPixels gather(const Seen& seen, const GatherSettings& settings,
                                        base::ThreadPool& pool) const;
    /// As though the ground changed nothing where the scene has none.
    [[nodiscard]] GroundPixels ground(const Seen& seen, const GatherSettings& settings,
                                      base::ThreadPool& pool) const;
    [[nodiscard]] SampleLight sample_light(const Seen& seen, const IndirectPixels& middles,
                                           const GatherSettings& settings, std::uint32_t frame,
                                           base::ThreadPool& pool) const;
    [[nodiscard]] std::vector<std::uint8_t> light_visibility(const Seen& seen,
                                                             const LightChoice& lights,
                                                             std::size_t slots,
                                                             const SampleId& sample,
                                                             base::ThreadPool& pool) const;

private:
    struct Impl;
    explicit Tracer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace facet::trace
