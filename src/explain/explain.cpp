// The rendering equation at pixels of a picture.
// SPDX-License-Identifier: MIT
#include "explain/explain.h"

#include "base/text.h"
#include "base/thread_pool.h"
#include "render/plan.h"
#include "render/session.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace facet::explain {
namespace {

using base::ErrorCode;
using frame::ExplainedPixel;
using frame::ExplainedPoint;

DVec3 rgb(const math::Vec4& v) { return {v.x, v.y, v.z}; }

base::Status check(const render::Request& request, const render::Plan& plan,
                   const std::vector<PixelRequest>& pixels) {
    if (plan.reference)
        return base::fail(
            {.code = ErrorCode::usage,
             .file = "--reference",
             .what = "explain is of the rasteriser's picture",
             .remedy = "facet render --reference --compare shows the truth beside it"});
    if (!plan.aovs.empty())
        return base::fail({.code = ErrorCode::usage,
                           .file = "--aov",
                           .what = "explain writes no pictures",
                           .found = base::join(request.settings.aov, ",")});
    if (plan.has_ocio)
        return base::fail({.code = ErrorCode::feature_missing,
                           .file = "--tonemap",
                           .what = "explain knows the tone curves of Facet alone",
                           .found = request.settings.tonemap,
                           .remedy = "another --tonemap"});
    if (plan.is_resampled)
        return base::fail({.code = ErrorCode::feature_missing,
                           .file = plan.is_panorama ? "--projection" : "--distortion",
                           .what = "explain is of flat views",
                           .found = request.settings.projection,
                           .remedy = "leave it out"});
    const frame::Region& r = plan.region;
    for (const PixelRequest& pixel : pixels)
        if (pixel.x < r.x || pixel.y < r.y || pixel.x - r.x >= r.size.width ||
            pixel.y - r.y >= r.size.height)
            return base::fail(
                {.code = ErrorCode::usage,
                 .file = "--pixel",
                 .what = fmt::format("outside the picture: x is {} to {}, y is {} to {}", r.x,
                                     r.x + r.size.width - 1, r.y, r.y + r.size.height - 1),
                 .found = fmt::format("{},{}", pixel.x, pixel.y)});
    return {};
}

/// Places in the region, each once, and for each pixel which of them it is.
struct Places {
    std::vector<frame::PixelPlace> unique;
    std::vector<std::size_t> of_pixel;
};
Places places_of(const std::vector<PixelRequest>& pixels, const frame::Region& region) {
    Places out;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (const PixelRequest& pixel : pixels) {
        const auto [found, is_new] = known.try_emplace({pixel.x, pixel.y}, out.unique.size());
        if (is_new) out.unique.push_back({pixel.x - region.x, pixel.y - region.y});
        out.of_pixel.push_back(found->second);
    }
    return out;
}

void finish(Pixel& pixel, const render::Plan& plan, double exposure) {
    const auto distance = [&](const ExplainedPixel& s) {
        return s.jitter_px.x * s.jitter_px.x + s.jitter_px.y * s.jitter_px.y;
    };
    for (std::size_t i = 0; i < pixel.samples.size(); ++i) {
        const Composite one = composed(pixel.samples[i]);
        pixel.sum += one.radiance / static_cast<double>(pixel.samples.size());
        pixel.alpha += one.alpha / static_cast<double>(pixel.samples.size());
        if (distance(pixel.samples[i]) < distance(pixel.samples[pixel.shown])) pixel.shown = i;
    }
    if (plan.background.kind != frame::BackgroundKind::color) return;
    pixel.sum += DVec3(plan.background.color) / exposure * (1.0 - pixel.alpha);
    pixel.alpha = 1.0;
}

/// The picture's own codes at a place of the region.
std::array<std::uint32_t, 4> code_at(const image::Image& display, frame::PixelPlace at) {
    std::array<std::uint32_t, 4> out{};
    const std::size_t first = (std::size_t{at.y} * display.size.width + at.x) * 4;
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = display.sample == image::Sample::u16 ? display.as<std::uint16_t>()[first + c]
                                                      : display.as<std::uint8_t>()[first + c];
    return out;
}

}  // namespace

Contribution of_light(const shared::ExplainedLight& light) {
    const DVec3 arriving =
        rgb(light.illuminance_lux) * static_cast<double>(light.cosines.x * light.cosines.w);
    return {rgb(light.diffuse) * arriving, rgb(light.specular) * arriving};
}

Contribution of_environment(const shared::ExplainedSurface& s) {
    const auto ao = static_cast<double>(s.numbers.z);
    return {rgb(s.environment_diffuse) * rgb(s.irradiance) * ao,
            rgb(s.environment_specular) * rgb(s.prefiltered) * ao};
}

Balance balance_of(const shared::ExplainedSurface& s) {
    Balance out{.reflected = rgb(s.environment_specular),
                .transmitted = rgb(s.environment_diffuse),
                .gone_through = rgb(s.far_weight)};
    out.absorbed = DVec3(1.0) - out.reflected - out.transmitted - out.gone_through;
    constexpr double rounding = 1e-6;  // of floats that add up to 1
    for (int c = 0; c < 3; ++c)
        if (std::fabs(out.absorbed[c]) < rounding) out.absorbed[c] = 0.0;
    return out;
}

DVec3 shown_by(const ExplainedPoint& point) {
    const shared::ExplainedSurface& s = point.surface;
    if (s.ids.z != 0) return rgb(s.base_color) + rgb(s.emissive_nit);
    DVec3 sum = of_environment(s).sum() + rgb(s.emissive_nit) + rgb(s.far_nit);
    for (const shared::ExplainedLight& light : point.lights) sum += of_light(light).sum();
    return sum;
}

Composite composed(const ExplainedPixel& sample) {
    Composite out;
    if (sample.opaque) out = {shown_by(*sample.opaque), 1.0};
    if (sample.background_nit) out = {DVec3(*sample.background_nit), 1.0};
    for (const ExplainedPoint& layer : sample.blended) {
        const auto opacity = static_cast<double>(layer.surface.base_color.w);
        out.radiance = shown_by(layer) * opacity + out.radiance * (1.0 - opacity);
        out.alpha = opacity + out.alpha * (1.0 - opacity);
    }
    out.radiance *= static_cast<double>(sample.vignetting);
    return out;
}

base::Result<Explained> explain(const render::Request& request,
                                const std::vector<PixelRequest>& pixels, base::Log& log,
                                const base::Progress& progress) {
    const auto plan = render::make_plan(request.settings);
    if (!plan) return tl::unexpected(plan.error());
    if (auto s = check(request, *plan, pixels); !s) return tl::unexpected(s.error());
    base::ThreadPool pool(request.settings.threads);
    render::Rendered rendered;
    auto opened = render::open(request, *plan, pool, log, rendered);
    if (!opened) return tl::unexpected(opened.error());
    if (opened->job.scene.ground) {
        opened->job.scene.ground.reset();
        rendered.warnings.push_back(
            {.where = "--ground", .what = "shadows on the ground are not told of: left out"});
    }
    auto session = render::Session::create(opened->gl, std::move(opened->job), request.settings,
                                           *plan, pool, rendered.warnings);
    if (!session) return tl::unexpected(session.error());
    const Places places = places_of(pixels, plan->region);
    std::vector<std::vector<ExplainedPixel>> samples(places.unique.size());
    const std::uint32_t count = plan->sample_count;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (auto drawn = session->draw(i, count); !drawn) return tl::unexpected(drawn.error());
        auto told = session->explain(places.unique, i, count);
        if (!told) return tl::unexpected(told.error());
        for (std::size_t k = 0; k < told->size(); ++k) samples[k].push_back(std::move((*told)[k]));
        if (progress)
            progress(static_cast<double>(i + 1) / count,
                     fmt::format("{} of {} samples", i + 1, count));
    }
    Explained out{.picture = plan->picture,
                  .is_exposure_automatic = !plan->exposure,
                  .tonemap = request.settings.tonemap,
                  .gamut = request.settings.gamut,
                  .white_balance_k = request.settings.white_balance,
                  .bits = plan->display_sample == image::Sample::u16 ? 16U : 8U,
                  .brdf = plan->brdf,
                  .scene = session->scene(),
                  .warnings = rendered.warnings,
                  .reads = rendered.reads};
    if (session->sun()) out.scene.lights.push_back(*session->sun());
    out.exposure = plan->exposure ? *plan->exposure : session->measure_exposure(count);
    if (auto shown = session->display(out.exposure, count); !shown)
        return tl::unexpected(shown.error());
    const image::Image display = session->read_display();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Pixel pixel{.x = pixels[i].x, .y = pixels[i].y, .samples = samples[places.of_pixel[i]]};
        finish(pixel, *plan, out.exposure);
        pixel.code = code_at(display, places.unique[places.of_pixel[i]]);
        out.pixels.push_back(std::move(pixel));
    }
    return out;
}

}  // namespace facet::explain
