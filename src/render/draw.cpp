// A session's picture, drawn to the end.
// SPDX-License-Identifier: MIT
#include "render/draw.h"

#include "render/ocio.h"
#include "render/reference.h"
#include "render/resample.h"
#include "render/session.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <optional>
#include <utility>

namespace facet::render {
namespace {

/// NaN and infinity never reach a file unasked (faults, L7); infinite depth is meant.
void clean(std::vector<image::Layer>& layers, base::Warnings& warnings) {
    for (image::Layer& layer : layers) {
        if (layer.name == "depth") continue;
        std::size_t count = 0;
        for (float& value : layer.image.as<float>())
            if (!std::isfinite(value)) {
                value = 0.0F;
                ++count;
            }
        if (count > 0)
            warnings.push_back({.where = layer.name.empty() ? "beauty" : layer.name,
                                .what = "values that are not finite became 0",
                                .found = fmt::format("{}", count),
                                .remedy = "--keep-nan writes them to EXR as they are"});
    }
}

/// Radiance of a picture of itself as a layer, over the background colour where one is named.
image::Layer beauty_of(const Session& session, image::Image radiance, double exposure) {
    session.lay_over_background(radiance, exposure);
    return {.name = "", .channels = {"R", "G", "B", "A"}, .image = std::move(radiance)};
}

/// Radiance of a picture of itself, encoded for a screen.
base::Result<image::Image> displayed(Session& session, image::Image radiance, double exposure,
                                     const Plan& plan) {
    if (plan.has_ocio) return ocio_picture(std::move(radiance), exposure, plan);
    if (auto shown = session.display_picture(radiance, exposure); !shown)
        return tl::unexpected(shown.error());
    return session.read_display();
}

/// The rasteriser's picture: in the session's frame, or resampled from flat views.
class RasterPicture {
public:
    RasterPicture(Session& session, const Plan& plan) : session_(session), plan_(plan) {}

    /// Sets the exposure of `out` where it is automatic.
    [[nodiscard]] base::Status draw(base::ThreadPool& pool, Rendered& out) {
        if (plan_.is_resampled) {
            auto drawn = draw_resampled(session_, pool);
            if (!drawn) return tl::unexpected(drawn.error());
            out.exposure = drawn->exposure;
            resampled_ = std::move(drawn->radiance);
            return {};
        }
        for (std::uint32_t i = 0; i < plan_.sample_count; ++i)
            if (auto drawn = session_.draw(i, plan_.sample_count); !drawn) return drawn;
        if (!plan_.exposure) out.exposure = session_.measure_exposure(plan_.sample_count);
        return {};
    }
    [[nodiscard]] base::Result<image::Image> display(double exposure) const {
        if (resampled_) return displayed(session_, *resampled_, exposure, plan_);
        if (plan_.has_ocio)
            return displayed(session_, session_.read_mean(plan_.sample_count), exposure, plan_);
        if (auto shown = session_.display(exposure, plan_.sample_count); !shown)
            return tl::unexpected(shown.error());
        return session_.read_display();
    }
    [[nodiscard]] image::Layer beauty(double exposure) const {
        return resampled_ ? beauty_of(session_, *resampled_, exposure)
                          : beauty_of(session_, session_.read_mean(plan_.sample_count), exposure);
    }

private:
    Session& session_;
    const Plan& plan_;
    std::optional<image::Image> resampled_;
};

/// The rasteriser's picture beside the reference that `out` holds already.
base::Status add_comparison(const RasterPicture& raster, const Request& request, const Plan& plan,
                            Rendered& out) {
    if (!request.want_linear) {
        const auto shown = raster.display(out.exposure);
        if (!shown) return tl::unexpected(shown.error());
        auto panels = compare_displayed(*shown, out.display, plan, out);
        if (!panels) return tl::unexpected(panels.error());
        out.display = std::move(*panels);
        out.size = out.display.size;
        return {};
    }
    image::Layer reference = std::move(out.layers.front());
    out.layers.front() = raster.beauty(out.exposure);
    image::Layer difference = out.layers.front();
    difference.name = "difference";
    reference.name = "reference";
    const auto values = difference.image.as<float>();
    const auto truth = reference.image.as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= truth[i];
    out.layers.push_back(std::move(reference));
    out.layers.push_back(std::move(difference));
    return {};
}

base::Status draw_reference(Session& session, const Request& request, const Plan& plan,
                            const DrawTools& tools, Rendered& out) {
    // The rasteriser measures the exposure of both, so that they can be laid side by side.
    RasterPicture raster(session, plan);
    if (!plan.exposure || request.settings.compare)
        if (auto drawn = raster.draw(tools.pool, out); !drawn) return drawn;
    auto reference =
        trace_reference(session, request, plan, out.exposure, tools.pool, tools.progress, out);
    if (!reference) return tl::unexpected(reference.error());
    session.lay_over_background(reference->aovs, reference->radiance, out.exposure);
    if (request.want_linear) {
        out.layers.push_back(beauty_of(session, std::move(reference->radiance), out.exposure));
    } else {
        auto shown = displayed(session, std::move(reference->radiance), out.exposure, plan);
        if (!shown) return tl::unexpected(shown.error());
        out.display = std::move(*shown);
    }
    if (request.settings.compare)
        if (auto s = add_comparison(raster, request, plan, out); !s) return s;
    for (image::Layer& layer : reference->aovs) out.layers.push_back(std::move(layer));
    return {};
}

base::Status draw_raster(Session& session, const Request& request, const Plan& plan,
                         const DrawTools& tools, Rendered& out) {
    RasterPicture raster(session, plan);
    if (auto drawn = raster.draw(tools.pool, out); !drawn) return drawn;
    if (request.want_linear) {
        out.layers.push_back(raster.beauty(out.exposure));
    } else {
        auto shown = raster.display(out.exposure);
        if (!shown) return tl::unexpected(shown.error());
        out.display = std::move(*shown);
    }
    if (plan.aovs.empty()) return {};
    if (auto drawn = session.draw_centered_aovs(); !drawn) return drawn;
    for (image::Layer& layer : session.read_aovs(out.exposure, plan.sample_count))
        out.layers.push_back(std::move(layer));
    return {};
}

/// An exposure that the user set may leave nothing to be seen.
void warn_of_black(const Plan& plan, const image::Image& shown, base::Warnings& warnings) {
    if (!plan.exposure || shown.sample != image::Sample::u8) return;
    constexpr std::uint8_t dark = 2;
    const auto codes = shown.as<std::uint8_t>();
    bool is_covered = false;
    for (std::size_t i = 0; i + 3 < codes.size(); i += 4) {
        is_covered = is_covered || codes[i + 3] > 0;
        if (codes[i] > dark || codes[i + 1] > dark || codes[i + 2] > dark) return;
    }
    if (is_covered)
        warnings.push_back(
            {.where = "exposure",
             .what = "the picture is black",
             .found = fmt::format("{:.3g}", *plan.exposure),
             .remedy = "--exposure auto, or more light: --env-intensity 10000 is daylight"});
}

}  // namespace

base::Status draw(Session& session, const Request& request, const Plan& plan,
                  const DrawTools& tools, Rendered& out) {
    if (plan.exposure) out.exposure = *plan.exposure;
    // A view that is not there is told of before the work.
    if (plan.has_ocio && !request.want_linear)
        if (auto shown = ocio_picture(image::Image({1, 1}, 4, image::Sample::f32), 1.0, plan);
            !shown)
            return tl::unexpected(shown.error());
    session.begin_picture();
    auto drawn = plan.reference ? draw_reference(session, request, plan, tools, out)
                                : draw_raster(session, request, plan, tools, out);
    if (!drawn) return drawn;
    if (!request.settings.keep_nan) clean(out.layers, out.warnings);
    if (!request.want_linear) warn_of_black(plan, out.display, out.warnings);
    return {};
}

}  // namespace facet::render
