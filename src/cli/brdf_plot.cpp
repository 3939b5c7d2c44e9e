// facet brdf plot: lobes and terms as curves.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "base/text.h"
#include "brdf/choice.h"
#include "cli/brdf_options.h"
#include "image/svg_figure.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::Result;
using brdf::QueryTerm;
using image::Curve;
using image::Figure;

constexpr double degree = 3.14159265358979323846 / 180.0;

struct Model {
    std::string name;
    brdf::Queries queries;
};

/// What is plotted: models, one surface, and views.
struct Plot {
    std::vector<Model> models;
    brdf::QuerySurface surface;
    std::vector<double> views;  ///< n.v
};

/// `-o` of another ending would be a picture, which a plot is not.
base::Status check(const BrdfOptions& options, const std::string& output) {
    if (output.ends_with(".svg")) return base::check_writable(output);
    return base::fail({.code = ErrorCode::usage,
                       .file = output,
                       .what = "a plot is an .svg",
                       .remedy = options.output.empty() ? "" : "give it the ending .svg"});
}

Result<Plot> plot_of(const BrdfOptions& options) {
    Plot plot;
    std::vector<std::string> texts = options.brdf;
    if (texts.empty()) texts.emplace_back();
    for (const std::string& text : texts) {
        const auto choice = brdf::parse_choice(text, brdf::Use::lesson);
        if (!choice) return tl::unexpected(base::in_file(choice.error(), "--brdf"));
        plot.models.push_back({text.empty() ? "default" : text, brdf::Queries(*choice)});
    }
    const auto roughness = numbers("--roughness", options.roughness, {0.4}, 0.0, 1.0);
    const auto metallic = numbers("--metallic", options.metallic, {0.0}, 0.0, 1.0);
    const auto views = numbers("--n-dot-v", options.n_dot_v, {0.94, 0.71, 0.34}, 0.0, 1.0);
    for (const auto* list : {&roughness, &metallic, &views})
        if (!*list) return tl::unexpected(list->error());
    if (roughness->size() != 1 || metallic->size() != 1)
        return base::fail(
            {.code = ErrorCode::usage,
             .file = "--roughness",
             .what = "plot takes one roughness and one metallic",
             .remedy = "several models are laid over each other by repeating --brdf"});
    plot.surface = {std::max(roughness->front(), 1e-3), metallic->front(),
                    options.f0.value_or(0.04), options.base_color.value_or(1.0), 1.0};
    plot.views = *views;
    for (double& view : plot.views) view = std::max(view, 1e-3);
    return plot;
}

/// A lobe in the plane of incidence, the light's angle from the normal; the viewer is on the left.
Curve lobe_curve(Model& model, const Plot& plot, QueryTerm term, double n_dot_v) {
    Curve curve;
    brdf::QuerySurface surface = plot.surface;
    surface.n_dot_v = n_dot_v;
    for (double angle = -89.75; angle < 90.0; angle += 0.25) {
        const double n_dot_l = std::cos(angle * degree);
        const double phi_deg = angle < 0.0 ? 0.0 : 180.0;
        curve.points.push_back({angle, model.queries.value(term, surface, n_dot_l, phi_deg)});
    }
    return curve;
}

Figure lobe_figure(Plot& plot, QueryTerm term, const char* title) {
    Figure figure{.kind = image::FigureKind::polar, .title = title, .x = {}, .y = {}, .curves = {}};
    double peak = 0.0;
    for (std::size_t m = 0; m < plot.models.size(); ++m)
        for (std::size_t v = 0; v < plot.views.size(); ++v) {
            Curve curve = lobe_curve(plot.models[m], plot, term, plot.views[v]);
            for (const Curve::Point& p : curve.points) peak = std::max(peak, p.y);
            // Colours tell the models apart where there are several, else the views.
            const bool by_model = plot.models.size() > 1;
            curve.color = by_model ? m : v;
            curve.dash = by_model ? v : 0;
            const double degrees = std::acos(std::min(1.0, plot.views[v])) / degree;
            curve.name = by_model ? fmt::format("{}, view {:.0f}°", plot.models[m].name, degrees)
                                  : fmt::format("view at {:.0f}°", degrees);
            figure.curves.push_back(std::move(curve));
        }
    constexpr double nothing = 1e-9;
    figure.y = {"f, 1/sr (rings go by the root)", 0.0, std::max(peak * 1.02, nothing),
                image::Scale::root};
    if (peak < nothing)
        figure = {.kind = figure.kind, .title = title, .y = {"", 0.0, 1.0, image::Scale::root}};
    return figure;
}

/// A term over an angle in degrees.
template <class Value>
Figure term_figure(Plot& plot, const char* title, const char* x_label, const char* y_label,
                   const Value& value) {
    Figure figure{
        .title = title, .x = {x_label, 0.0, 90.0}, .y = {y_label, 0.0, 1.0}, .curves = {}};
    for (std::size_t m = 0; m < plot.models.size(); ++m) {
        Curve curve{.name = "", .points = {}, .color = plot.models.size() > 1 ? m : 7};
        for (double angle = 0.0; angle <= 89.9; angle += 0.5)
            curve.points.push_back({angle, value(plot.models[m], std::cos(angle * degree))});
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

std::vector<Figure> term_figures(Plot& plot) {
    const brdf::QuerySurface surface = plot.surface;
    std::vector<Figure> out;
    out.push_back(
        term_figure(plot, "D, normal distribution", "angle of the half vector, degrees", "D, 1/sr",
                    [&](Model& model, double cosine) {
                        return model.queries.value(QueryTerm::d, surface, {1.0, cosine, 1.0, 0.0});
                    }));
    double peak = 0.0;
    for (const Curve& curve : out[0].curves)
        for (const Curve::Point& p : curve.points) peak = std::max(peak, p.y);
    const bool steep = peak > 10.0;
    out[0].y = {"D, 1/sr", steep ? peak * 1e-6 : 0.0, peak * (steep ? 2.0 : 1.05),
                steep ? image::Scale::logarithmic : image::Scale::linear};
    out.push_back(
        term_figure(plot, "F, Fresnel", "angle between view and half vector, degrees", "F",
                    [&](Model& model, double cosine) {
                        return model.queries.value(QueryTerm::f, surface, {1.0, 1.0, cosine, 0.0});
                    }));
    out.push_back(term_figure(
        plot, "G, masking and shadowing", "angle of view and of light, degrees", "G",
        [&](Model& model, double cosine) {
            brdf::QuerySurface seen = surface;
            seen.n_dot_v = std::max(cosine, 1e-6);
            return model.queries.value(QueryTerm::g, seen, {seen.n_dot_v, 1.0, seen.n_dot_v, 0.0});
        }));
    return out;
}

}  // namespace

Result<Exit> brdf_plot(const BrdfOptions& options, Io& io) {
    const std::string output = options.output.empty() ? "lobe.svg" : options.output;
    if (auto fine = check(options, output); !fine) return tl::unexpected(fine.error());
    auto plot = plot_of(options);
    if (!plot) return tl::unexpected(plot.error());
    std::vector<Figure> figures;
    figures.push_back(lobe_figure(*plot, QueryTerm::model_specular, "specular lobe"));
    figures.push_back(lobe_figure(*plot, QueryTerm::model_diffuse, "diffuse lobe"));
    figures.push_back(lobe_figure(*plot, QueryTerm::full, "both"));
    for (Figure& figure : term_figures(*plot)) figures.push_back(std::move(figure));
    const brdf::QuerySurface& s = plot->surface;
    std::string title = "BRDF";
    for (const Model& model : plot->models)
        title += (&model == plot->models.data() ? ": " : " and ") + model.name;
    const std::string text =
        image::svg_page(title,
                        fmt::format("roughness {:g}, metallic {:g}, F0 {:g}, base colour {:g}; "
                                    "lobes in the plane of incidence, the "
                                    "viewer on the left",
                                    s.roughness, s.metallic, s.f0, s.base),
                        figures, 3);
    if (auto written = base::write_file_atomically(output, std::as_bytes(std::span(text)));
        !written)
        return tl::unexpected(written.error());
    io.print(base::escaped(output, 4096));
    return Exit::done;
}

}  // namespace facet::cli
