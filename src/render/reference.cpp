// The reference picture of a session.
// SPDX-License-Identifier: MIT
#include "render/reference.h"

#include "image/compare.h"
#include "image/panels.h"
#include "render/play.h"
#include "render/session.h"
#include "trace/trace.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace facet::render {
namespace {

void warn(const trace::Traced& traced, base::Warnings& warnings) {
    if (traced.not_finite > 0)
        warnings.push_back({.where = "reference",
                            .what = "samples that are not finite were left out",
                            .found = fmt::format("{} of {}", traced.not_finite, traced.paths)});
    if (traced.stopped_by_time)
        warnings.push_back({.where = "reference",
                            .what = "the time limit ended it early",
                            .found = fmt::format("{:.1f} samples per pixel", traced.samples),
                            .remedy = "a larger --time-limit"});
}

image::Picture picture_of(const image::Image& display) {
    return {.layers = {{.name = "", .channels = {"R", "G", "B", "A"}, .image = display}},
            .metadata = {},
            .format = tables::ImageFormat::png};
}

/// Layers in the order of `aovs`, from those that are light paths and those that are not.
std::vector<image::Layer> in_order(const std::vector<tables::Aov>& aovs,
                                   std::vector<image::Layer> paths,
                                   std::vector<image::Layer> others) {
    std::vector<image::Layer> out;
    std::size_t path = 0;
    std::size_t other = 0;
    for (const tables::Aov aov : aovs)
        out.push_back(std::move(tables::row(aov).kind == tables::AovKind::light_path
                                    ? paths[path++]
                                    : others[other++]));
    return out;
}

/// A scene that moves under its tracer.
struct Moving {
    const tables::Settings& settings;
    const Plan& plan;
    Job& job;
    scene::Camera& camera;
    trace::Tracer& tracer;

    [[nodiscard]] base::Status move_to(float part) const {
        if (auto posed = pose_job(settings, plan, part, job); !posed)
            return tl::unexpected(posed.error());
        camera = camera_at(settings, part, job);
        return tracer.follow_scene(plan.limits);
    }
};

void add(const image::Image& from, image::Image& to) {
    if (to.size.pixels() == 0) to = image::Image(from.size, from.channels, from.sample);
    const auto values = from.as<float>();
    const auto sums = to.as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

void scale(image::Image& image, float factor) {
    for (float& value : image.as<float>()) value *= factor;
}

/// Pictures of one view that know nothing of each other, and their mean.
class MeanPicture {
public:
    void add_picture(const trace::Traced& one) {
        add(one.radiance, sum_.radiance);
        for (std::size_t i = 0; i < one.light_paths.size(); ++i) {
            const image::Layer& layer = one.light_paths[i];
            if (i == sum_.light_paths.size())
                sum_.light_paths.push_back({.name = layer.name, .channels = layer.channels});
            add(layer.image, sum_.light_paths[i].image);
        }
        sum_.samples += one.samples;
        squares_ += one.noise * one.noise;
        sum_.paths += one.paths;
        sum_.rays += one.rays;
        sum_.not_finite += one.not_finite;
        sum_.stopped_by_time = sum_.stopped_by_time || one.stopped_by_time;
        sum_.build_s = one.build_s;
        sum_.trace_s += one.trace_s;
        ++count_;
    }
    /// Errors that know nothing of each other add up as squares.
    [[nodiscard]] double noise() const { return std::sqrt(squares_) / count_; }
    [[nodiscard]] double trace_s() const { return sum_.trace_s; }
    [[nodiscard]] trace::Traced mean() && {
        const float share = 1.0F / static_cast<float>(count_);
        scale(sum_.radiance, share);
        for (image::Layer& layer : sum_.light_paths) scale(layer.image, share);
        sum_.noise = noise();
        return std::move(sum_);
    }

private:
    trace::Traced sum_;
    double squares_ = 0.0;
    std::uint32_t count_ = 0;
};

/// The mean of pictures at times spread over the shutter's, each with its share of the samples; the
/// scene is left in the middle of it. Until the noise is low enough, where that is asked for, all
/// times get a few more in turn.
base::Result<trace::Traced> trace_blurred(const Moving& moving, const trace::TraceSettings& whole,
                                          base::ThreadPool& pool, const base::Progress& progress) {
    constexpr std::uint32_t most_times = 32;
    constexpr std::uint32_t few = 2;  // of one, nobody knows the noise
    const std::uint32_t times = std::min(whole.samples, most_times);
    const std::uint64_t in_turn = whole.noise ? std::uint64_t{times} * few : whole.samples;
    const auto count = static_cast<float>(times);
    MeanPicture picture;
    std::uint64_t done = 0;
    const auto is_over = [&] {
        return done + in_turn > whole.samples || (whole.noise && picture.noise() <= *whole.noise) ||
               (whole.time_s && picture.trace_s() >= *whole.time_s);
    };
    do {
        for (std::uint32_t k = 0; k < times; ++k) {
            const auto place = static_cast<float>(k);
            if (auto s = moving.move_to((place + 0.5F) / count); !s)
                return tl::unexpected(s.error());
            trace::TraceSettings settings = whole;
            settings.noise.reset();
            settings.whole = whole.samples;
            settings.first = static_cast<std::uint32_t>(done + in_turn * k / times);
            settings.samples =
                static_cast<std::uint32_t>(done + in_turn * (k + 1) / times) - settings.first;
            settings.shutter = {place / count, (place + 1.0F) / count};
            if (settings.time_s)
                *settings.time_s = (*settings.time_s - picture.trace_s()) / (times - k);
            picture.add_picture(moving.tracer.trace(settings, pool));
            if (progress)
                progress(static_cast<double>(settings.first + settings.samples) / whole.samples,
                         fmt::format("time {} of {}, noise {:.2g}", k + 1, times, picture.noise()));
        }
        done += in_turn;
    } while (!is_over());
    if (auto s = moving.move_to(shutter_middle); !s) return tl::unexpected(s.error());
    return std::move(picture).mean();
}

}  // namespace

base::Result<image::Image> compare_displayed(const image::Image& raster,
                                             const image::Image& reference, const Plan& plan,
                                             Rendered& out) {
    const image::Picture a = picture_of(raster);
    const image::Picture b = picture_of(reference);
    const auto covered = image::compare(a, b, {.pixels = image::Pixels::covered});
    const auto whole = image::compare(b, a, {.heat = image::Heat::flip});
    if (!whole) return tl::unexpected(whole.error());
    // Where nothing is covered there is nothing but background, and that is compared.
    const image::Difference& d = covered ? *covered : *whole;
    out.compared =
        Compared{d.rmse, d.psnr_db, d.max_error, whole->flip.value_or(0.0), d.pixel_count};
    const image::Panel panels[] = {
        {&raster, {"raster", fmt::format("{} samples", plan.sample_count)}},
        {&reference,
         {"reference", fmt::format("{:.4g} samples, noise {:.2g}", out.reference->samples,
                                   out.reference->noise)}},
        {&whole->heat,
         {"difference", fmt::format("rmse {:.4f}  flip {:.4f}", d.rmse, out.compared->flip)}}};
    return image::side_by_side(panels);
}

base::Result<Reference> trace_reference(const Session& session, const Request& request,
                                        const Plan& plan, double exposure, base::ThreadPool& pool,
                                        const base::Progress& progress, Rendered& out) {
    const bool blurs = blurs_animation(request.settings, session.job());
    std::optional<Job> moving;
    if (blurs) moving = session.job();
    const Job& job = moving ? *moving : session.job();
    scene::Camera camera = job.camera;
    auto tracer = trace::Tracer::create(
        {.scene = job.scene,
         .environment = job.environment,
         .camera = camera,
         .env_rotation_deg = request.settings.env_rotation,
         .env_intensity = request.settings.env_intensity,
         .shows_environment = plan.background.kind == frame::BackgroundKind::environment,
         .background_blur = plan.background.blur,
         .brdf = plan.brdf,
         .key_light = key_light(job, plan.aovs)},
        plan.limits, pool);
    if (!tracer) return tl::unexpected(tracer.error());
    const trace::TraceSettings settings{
        .picture = plan.picture,
        .x = plan.region.x,
        .y = plan.region.y,
        .size = plan.region.size,
        .samples = plan.reference->samples,
        .noise = plan.reference->noise,
        .exposure = exposure,
        .time_s = plan.reference->time_s,
        .seed = request.settings.seed,
        .light_paths = tables::of_kind(plan.aovs, tables::AovKind::light_path)};
    trace::Traced traced;
    if (moving) {
        auto blurred = trace_blurred({request.settings, plan, *moving, camera, *tracer}, settings,
                                     pool, progress);
        if (!blurred) return tl::unexpected(blurred.error());
        traced = std::move(*blurred);
    } else {
        traced = tracer->trace(settings, pool, progress);
    }
    Reference reference{.radiance = std::move(traced.radiance),
                        .aovs = in_order(plan.aovs, std::move(traced.light_paths),
                                         tracer->aovs(settings, plan.aovs, pool))};
    warn(traced, out.warnings);
    out.reference = ReferenceReport{.samples = traced.samples,
                                    .noise = traced.noise,
                                    .paths = traced.paths,
                                    .rays = traced.rays,
                                    .stopped_by_time = traced.stopped_by_time,
                                    .build_s = traced.build_s,
                                    .trace_s = traced.trace_s};
    return reference;
}

}  // namespace facet::render
