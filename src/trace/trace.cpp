// The reference: a picture by path tracing.
// SPDX-License-Identifier: MIT
#include "trace/trace.h"

#include "trace/aov.h"
#include "trace/camera.h"
#include "trace/film.h"
#include "trace/gather.h"
#include "trace/ground.h"
#include "trace/path.h"
#include "trace/visibility.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace facet::trace {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Before this many samples a pixel's variance says little (its standard error is a quarter of it).
constexpr std::uint32_t trusted_samples = 32;
/// A ray stands for no less than this share of a pixel: finer would see texels that a picture
/// cannot show (Pharr, Jakob & Humphreys 2023, Section 10.1.3).
constexpr float cone_share_min = 0.125F;

struct TileCounts {
    std::uint64_t paths = 0;
    std::uint64_t rays = 0;
    std::uint64_t not_finite = 0;
};

/// What the rays of a pass need, the same for every tile.
struct Pass {
    const World& world;
    const CameraRays& camera;
    const TraceSettings& settings;
};

/// What one sample of a pixel sees.
PathLight trace_sample(const Pass& pass, math::Vec2 at_px, Cone cone, Sequence& sequence,
                       LightPaths* apart) {
    const CameraRays& camera = pass.camera;
    RayChoice choice;
    if (camera.has_lens()) choice.lens_m = camera.place_on_lens(sequence.next_pair());
    if (camera.moves()) {
        const math::Vec2 shutter = pass.settings.shutter;
        choice.time = shutter.x + (shutter.y - shutter.x) * sequence.next();
    }
    if (!camera.is_chromatic()) {
        PathLight light = trace_path(pass.world, camera.ray(at_px, choice), cone, sequence, apart);
        if (!camera.vignettes()) return light;
        const math::Vec3 share(camera.vignetting(at_px, choice));
        light.radiance_nit *= share;
        if (apart != nullptr) apart->scale(share);
        return light;
    }
    PathLight out;
    for (choice.channel = 0; choice.channel < 3; ++choice.channel) {
        LightPaths paths;
        Sequence same = sequence;
        const PathLight one = trace_path(pass.world, camera.ray(at_px, choice), cone, same,
                                         apart == nullptr ? nullptr : &paths);
        math::Vec3 color(0.0F);
        color[choice.channel] = camera.vignetting(at_px, choice);
        out.radiance_nit += one.radiance_nit * color;
        out.coverage += one.coverage / 3.0F;
        out.rays += one.rays;
        if (apart == nullptr) continue;
        paths.scale(color);
        apart->add(paths);
    }
    return out;
}

/// Traces samples [first, first + count) of one tile's pixels.
TileCounts trace_tile(const Pass& pass, Film& film, std::size_t tile, std::uint32_t first,
                      std::uint32_t count) {
    const TraceSettings& settings = pass.settings;
    TileCounts counts;
    const std::uint32_t whole = std::max(settings.samples, settings.whole);
    const float share = std::max(cone_share_min, 1.0F / std::sqrt(static_cast<float>(whole)));
    const Cone cone{pass.camera.cone_at_eye_m() * share, pass.camera.cone_spread() * share};
    const Film::TileBox box = film.tile_box(tile);
    for (std::uint32_t y = box.y0; y < box.y1; ++y)
        for (std::uint32_t x = box.x0; x < box.x1; ++x) {
            // By its place in the whole picture: a region is the same as that part of the picture.
            const std::uint32_t pixel = (settings.y + y) * settings.picture.width + settings.x + x;
            for (std::uint32_t i = first; i < first + count; ++i) {
                Sequence sequence(pixel, settings.first + i, settings.seed);
                const math::Vec2 at =
                    sequence.next_pair() + math::Vec2(settings.x + x, settings.y + y);
                LightPaths apart;
                const PathLight light =
                    trace_sample(pass, at, cone, sequence, film.keeps_paths() ? &apart : nullptr);
                counts.rays += light.rays;
                ++counts.paths;
                if (!film.add(std::size_t{y} * settings.size.width + x, light, apart))
                    ++counts.not_finite;
            }
        }
    return counts;
}

void report(const TraceSettings& settings, std::uint32_t done, const Film& film,
            const base::Progress& progress) {
    const double by_samples = static_cast<double>(done) / settings.samples;
    if (!settings.noise)
        return progress(by_samples, fmt::format("{} of {} samples", done, settings.samples));
    const double noise = film.error(settings.exposure);
    // Errors fall with the root of the samples.
    const double by_noise =
        noise > 0.0 ? std::min(1.0, *settings.noise * *settings.noise / (noise * noise)) : 1.0;
    progress(std::max(by_samples, by_noise),
             fmt::format("{} samples, noise {:.2g} of {:.2g}", done, noise, *settings.noise));
}

/// Samples of the next pass: few at first, so that something is there early and a time limit is
/// kept, then as many as there are, so that a pass is long beside its overhead, but no more than
/// the time that is left allows for.
std::uint32_t next_pass(const TraceSettings& settings, std::uint32_t done, double elapsed_s) {
    const std::uint32_t count =
        std::min({std::max(1U, done), settings.largest_pass, settings.samples - done});
    if (!settings.time_s || done == 0) return count;
    const double each_s = elapsed_s / done;
    const double room = (*settings.time_s - elapsed_s) / std::max(each_s, 1e-9);
    return room < 1.0 ? 0 : std::min(count, static_cast<std::uint32_t>(std::min(room, 1e6)));
}

}  // namespace

struct Tracer::Impl {
    Impl(const TraceInputs& inputs_, base::ThreadPool& pool)
        : inputs(inputs_),
          textures(Textures::build(inputs.scene, pool)),
          frames(instance_frames(inputs.scene)),
          lights(inputs.scene, textures, inputs.sun ? &*inputs.sun : nullptr),
          environment(*inputs.environment.latlong, inputs.env_rotation_deg, inputs.env_intensity,
                      pool),
          model(inputs.brdf),
          open_ground(inputs.scene.ground ? environment.irradiance_from_above()
                                          : math::Vec3(0.0F)) {}

    TraceInputs inputs;
    Textures textures;
    std::vector<InstanceFrame> frames;
    Lights lights;
    EnvironmentLight environment;
    Model model;
    std::optional<Geometry> geometry;
    math::Vec3 open_ground{0.0F};
    double build_s = 0.0;

    [[nodiscard]] World world(std::uint32_t bounces) const {
        return {.scene = inputs.scene,
                .frames = frames,
                .textures = textures,
                .geometry = *geometry,
                .lights = lights,
                .environment = environment,
                .model = model,
                .shows_environment = inputs.shows_environment,
                .blur = inputs.background_blur,
                .bounce_limit = bounces,
                .key_light = inputs.key_light,
                .sun = inputs.sun ? &*inputs.sun : nullptr,
                .open_ground = open_ground};
    }
};

Tracer::Tracer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;
Tracer::~Tracer() = default;

base::Result<Tracer> Tracer::create(const TraceInputs& inputs, const base::Limits& limits,
                                    base::ThreadPool& pool) {
    const auto start = Clock::now();
    auto impl = std::make_unique<Impl>(inputs, pool);
    auto geometry = Geometry::build(inputs.scene, impl->textures, limits);
    if (!geometry) return tl::unexpected(geometry.error());
    impl->geometry = std::move(*geometry);
    impl->build_s = seconds_since(start);
    return Tracer(std::move(impl));
}

base::Status Tracer::follow_scene(const base::Limits& limits) {
    const auto start = Clock::now();
    const scene::Scene& scene = impl_->inputs.scene;
    impl_->frames = instance_frames(scene);
    impl_->lights =
        Lights(scene, impl_->textures, impl_->inputs.sun ? &*impl_->inputs.sun : nullptr);
    auto geometry = Geometry::build(scene, impl_->textures, limits);
    if (!geometry) return tl::unexpected(geometry.error());
    impl_->geometry = std::move(*geometry);
    impl_->build_s += seconds_since(start);
    return {};
}

Traced Tracer::trace(const TraceSettings& settings, base::ThreadPool& pool,
                     const base::Progress& progress, const Preview& preview) const {
    const auto start = Clock::now();
    const World world = impl_->world(settings.bounces);
    const CameraRays camera(impl_->inputs.camera, settings.picture);
    Film film(settings.size, settings.light_paths);
    Traced out;
    std::vector<std::size_t> tiles(film.tile_count());
    std::iota(tiles.begin(), tiles.end(), std::size_t{0});
    std::uint32_t first = 0;
    const auto is_cancelled = [&] {
        return settings.cancelled != nullptr && settings.cancelled->load(std::memory_order_relaxed);
    };
    while (first < settings.samples && !tiles.empty() && !is_cancelled()) {
        const std::uint32_t count = next_pass(settings, first, seconds_since(start));
        if (count == 0) {
            out.stopped_by_time = true;
            break;
        }
        std::vector<TileCounts> counts(tiles.size());
        pool.parallel_for(tiles.size(), [&](std::size_t i) {
            if (!is_cancelled())
                counts[i] = trace_tile({world, camera, settings}, film, tiles[i], first, count);
        });
        for (const TileCounts& tile : counts) {
            out.paths += tile.paths;
            out.rays += tile.rays;
            out.not_finite += tile.not_finite;
        }
        first += count;
        if (settings.noise && first >= trusted_samples) {
            std::erase_if(tiles, [&](std::size_t tile) {
                return film.tile_error(tile, settings.exposure) <= *settings.noise;
            });
        }
        if (progress) report(settings, first, film, progress);
        if (preview && !is_cancelled())
            preview(film.mean(),
                    static_cast<double>(out.paths) / static_cast<double>(settings.size.pixels()));
    }
    out.radiance = film.mean();
    out.light_paths = film.mean_paths();
    out.noise = film.error(settings.exposure);
    out.samples = static_cast<double>(out.paths) / static_cast<double>(settings.size.pixels());
    out.build_s = impl_->build_s;
    out.trace_s = seconds_since(start);
    return out;
}

IndirectPixels Tracer::gather(const Seen& seen, const GatherSettings& settings,
                              base::ThreadPool& pool) const {
    return trace::gather(impl_->world(settings.bounces), seen, settings, pool);
}

GroundPixels Tracer::ground(const Seen& seen, const GatherSettings& settings,
                            base::ThreadPool& pool) const {
    if (!impl_->inputs.scene.ground) return {{1, 1}, {math::Vec4(1.0F)}};
    return light_ground(impl_->world(settings.bounces), seen, settings, pool);
}

SampleLight Tracer::sample_light(const Seen& seen, const IndirectPixels& middles,
                                 const GatherSettings& settings, std::uint32_t frame,
                                 base::ThreadPool& pool) const {
    return trace::sample_light(impl_->world(settings.bounces), seen, middles, settings, frame,
                               pool);
}

std::vector<std::uint8_t> Tracer::light_visibility(const Seen& seen, const LightChoice& lights,
                                                   std::size_t slots, const SampleId& sample,
                                                   base::ThreadPool& pool) const {
    return trace::light_visibility(impl_->world(0), seen, lights, slots, sample, pool);
}

std::vector<image::Layer> Tracer::aovs(const TraceSettings& settings,
                                       const std::vector<tables::Aov>& aovs,
                                       base::ThreadPool& pool) const {
    const World world = impl_->world(settings.bounces);
    const CameraRays camera(impl_->inputs.camera, settings.picture);
    return trace_aovs(world, camera, settings, aovs, pool);
}

}  // namespace facet::trace
