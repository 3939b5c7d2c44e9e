// A lesson's plot as SVG.
// SPDX-License-Identifier: MIT
#include "teach/plot.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::teach {
namespace {

/// Where a curve is computed: evenly along its axis.
std::vector<double> places(const Plot& plot, double low, double high) {
    std::vector<double> out;
    if (plot.variable == "samples") {  // whole numbers, doubling
        for (double n = low; n <= high; n *= 2.0) out.push_back(n);
        return out;
    }
    constexpr int steps = 240;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        out.push_back(plot.x.logarithmic ? low * std::pow(high / low, t) : low + (high - low) * t);
    }
    return out;
}

bool is_angle(const std::string& variable) { return variable.starts_with("theta"); }

}  // namespace

image::Figure figure_of(const Plot& plot, std::string_view language, Answers& answers) {
    image::Figure figure{.kind = plot.polar ? image::FigureKind::polar : image::FigureKind::lines,
                         .title = plot.title.in(language)};
    const double low = plot.x.low.value_or(plot.polar ? -90.0 : 0.0);
    const double high = plot.x.high.value_or(is_angle(plot.variable) ? 90.0 : 1.0);
    double peak = 0.0;
    double least = 1e300;
    for (const PlotCurve& from : plot.curves) {
        image::Curve curve{
            .name = from.label.in(language), .points = {}, .color = from.color, .dash = from.dash};
        for (const double x : places(plot, low, high)) {
            Ask ask = from.ask;
            (void)set_variable(ask, plot.variable, x);
            const double y = answers(ask);
            if (!std::isfinite(y)) continue;
            curve.points.push_back({x, y});
            peak = std::max(peak, y);
            if (y > 0.0) least = std::min(least, y);
        }
        figure.curves.push_back(std::move(curve));
    }
    using image::Scale;
    figure.x = {plot.x.label.in(language), low, high,
                plot.x.logarithmic ? Scale::logarithmic : Scale::linear};
    const double top = std::max(peak * 1.04, 1e-9);
    if (plot.polar)
        figure.y = {plot.y.label.in(language), 0.0, plot.y.high.value_or(top), Scale::root};
    else if (plot.y.logarithmic)
        figure.y = {plot.y.label.in(language),
                    plot.y.low.value_or(std::max(least * 0.8, peak * 1e-6)),
                    plot.y.high.value_or(peak * 1.5), Scale::logarithmic};
    else
        figure.y = {plot.y.label.in(language), plot.y.low.value_or(0.0), plot.y.high.value_or(top),
                    Scale::linear};
    return figure;
}

std::string svg_of(const Plot& plot, std::string_view language, Answers& answers) {
    return image::svg_page("", "", {figure_of(plot, language, answers)}, 1);
}

std::string written(const Number& number, double value) {
    if (number.percent) return fmt::format("{:.{}f} %", value * 100.0, number.digits);
    const std::string text = fmt::format("{:.{}f}", value, number.digits);
    // No -0.0000.
    return text.find_first_of("123456789") == std::string::npos && text.starts_with('-')
               ? text.substr(1)
               : text;
}

}  // namespace facet::teach
