// A session's picture, drawn to the end.
// SPDX-License-Identifier: MIT
#include "render/draw.h"

#include "render/reference.h"
#include "render/session.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

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

/// Radiance as a layer, or encoded for a screen.
base::Status deliver(Session& session, bool want_linear, image::Image radiance, Rendered& out) {
    if (!want_linear) {
        if (auto shown = session.display_picture(radiance, out.exposure); !shown) return shown;
        out.display = session.read_display();
        return {};
    }
    session.lay_over_background(radiance, out.exposure);
    out.layers.push_back(
        {.name = "", .channels = {"R", "G", "B", "A"}, .image = std::move(radiance)});
    return {};
}

/// The rasteriser's picture beside the reference that `out` holds already.
base::Status add_comparison(Session& session, const Request& request, const Plan& plan,
                            Rendered& out) {
    const std::uint32_t count = plan.sample_count;
    if (!request.want_linear) {
        if (auto shown = session.display(out.exposure, count); !shown) return shown;
        auto panels = compare_displayed(session.read_display(), out.display, plan, out);
        if (!panels) return tl::unexpected(panels.error());
        out.display = std::move(*panels);
        out.size = out.display.size;
        return {};
    }
    image::Layer reference = std::move(out.layers.front());
    out.layers.front() = session.read_beauty(out.exposure, count);
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
    const std::uint32_t count = plan.sample_count;
    if (!plan.exposure || request.settings.compare)
        for (std::uint32_t i = 0; i < count; ++i)
            if (auto drawn = session.draw(i, count); !drawn) return drawn;
    if (!plan.exposure) out.exposure = session.measure_exposure(count);
    auto reference =
        trace_reference(session, request, plan, out.exposure, tools.pool, tools.progress, out);
    if (!reference) return tl::unexpected(reference.error());
    session.lay_over_background(reference->aovs, reference->radiance, out.exposure);
    if (auto s = deliver(session, request.want_linear, std::move(reference->radiance), out); !s)
        return s;
    if (request.settings.compare)
        if (auto s = add_comparison(session, request, plan, out); !s) return s;
    for (image::Layer& layer : reference->aovs) out.layers.push_back(std::move(layer));
    return {};
}

base::Status draw_raster(Session& session, const Request& request, const Plan& plan,
                         Rendered& out) {
    const std::uint32_t count = plan.sample_count;
    for (std::uint32_t i = 0; i < count; ++i)
        if (auto drawn = session.draw(i, count); !drawn) return drawn;
    if (!plan.exposure) out.exposure = session.measure_exposure(count);
    if (request.want_linear) {
        out.layers.push_back(session.read_beauty(out.exposure, count));
    } else {
        if (auto shown = session.display(out.exposure, count); !shown) return shown;
        out.display = session.read_display();
    }
    if (auto drawn = session.draw_centered_aovs(); !drawn) return drawn;
    for (image::Layer& layer : session.read_aovs(out.exposure, count))
        out.layers.push_back(std::move(layer));
    return {};
}

}  // namespace

base::Status draw(Session& session, const Request& request, const Plan& plan,
                  const DrawTools& tools, Rendered& out) {
    if (plan.exposure) out.exposure = *plan.exposure;
    session.begin_picture();
    auto drawn = plan.reference ? draw_reference(session, request, plan, tools, out)
                                : draw_raster(session, request, plan, out);
    if (drawn && !request.settings.keep_nan) clean(out.layers, out.warnings);
    return drawn;
}

}  // namespace facet::render
