// Line charts and polar charts as SVG.
// SPDX-License-Identifier: MIT
#include "image/svg_figure.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::image {
namespace {

constexpr double cell_width = 380.0;
constexpr double cell_height = 300.0;
constexpr double margin_left = 58.0;
constexpr double margin_right = 18.0;
constexpr double margin_top = 38.0;
constexpr double margin_bottom = 48.0;
constexpr double head_height = 64.0;
constexpr double legend_line = 22.0;

/// Colours that stay apart for the colour-blind on white and on black (Okabe & Ito 2008, black
/// replaced by the text's).
constexpr std::string_view style = R"(
  svg { font-family: system-ui, "Segoe UI", "DejaVu Sans", Helvetica, sans-serif; font-size: 13px; }
  .page { fill: #ffffff; } text { fill: #1c1f24; } .faint { fill: #5b626d; } .title { font-size: 19px; font-weight: 600; }
  .head { font-size: 14px; font-weight: 600; } .axis { stroke: #6b7280; fill: none; } .grid { stroke: #d9dde3; fill: none; }
  .c0 { stroke: #0072b2; } .c1 { stroke: #d55e00; } .c2 { stroke: #009e73; } .c3 { stroke: #cc79a7; }
  .c4 { stroke: #b8860b; } .c5 { stroke: #56b4e9; } .c6 { stroke: #e69f00; } .c7 { stroke: #5b626d; }
  .curve { fill: none; stroke-width: 2; stroke-linejoin: round; } .d1 { stroke-dasharray: 7 4; } .d2 { stroke-dasharray: 2 4; }
  @media (prefers-color-scheme: dark) {
    .page { fill: #14171c; } text { fill: #e8eaee; } .faint { fill: #a0a8b4; } .axis { stroke: #8a93a0; } .grid { stroke: #2c323b; }
    .c0 { stroke: #4ba3e3; } .c1 { stroke: #ff8b4d; } .c2 { stroke: #2ecf9c; } .c3 { stroke: #e69fc5; } .c4 { stroke: #e0b84a; }
  }
)";

std::string text_at(double x, double y, const char* anchor, const char* css,
                    const std::string& text) {
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n", x, y, anchor,
        css, base::markup_escaped(text));
}

std::string number(double value) {
    if (value != 0.0 && (std::fabs(value) >= 1e4 || std::fabs(value) < 1e-3))
        return fmt::format("{:.0e}", value);
    return value == 0.0 ? "0" : fmt::format("{:.4g}", value);  // no -0
}

/// Where a value lies on an axis, 0 to 1.
double share_of(const Axis& axis, double value) {
    if (axis.scale == Scale::logarithmic)
        return std::log(std::max(value, axis.low) / axis.low) / std::log(axis.high / axis.low);
    if (axis.scale == Scale::root) return std::sqrt(std::max(value, 0.0) / axis.high);
    return (value - axis.low) / (axis.high - axis.low);
}

std::vector<double> ticks_of(const Axis& axis) {
    if (axis.scale != Scale::logarithmic) return round_steps(axis.low, axis.high);
    std::vector<double> out;
    const int first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
    const int step = std::max(1, (last - first + 5) / 6);
    for (int e = first; e <= last; e += step) out.push_back(std::pow(10.0, e));
    return out;
}

std::string path_of(const Curve& curve, const std::string& points) {
    return fmt::format("<path class=\"curve c{} d{}\" d=\"{}\"/>\n", curve.color % 8,
                       curve.dash % 3, points);
}

class LineChart {
public:
    LineChart(const Figure& figure, double x, double y)
        : figure_(figure),
          left_(x + margin_left),
          top_(y + margin_top),
          width_(cell_width - margin_left - margin_right),
          height_(cell_height - margin_top - margin_bottom) {}

    [[nodiscard]] std::string draw() const {
        std::string out = text_at(left_ + width_ / 2, top_ - 14, "middle", "head", figure_.title);
        for (const double tick : ticks_of(figure_.x)) {
            const double x = px(tick);
            out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x, top_,
                               top_ + height_);
            out += text_at(x, top_ + height_ + 17, "middle", "faint", number(tick));
        }
        for (const double tick : ticks_of(figure_.y)) {
            const double y = py(tick);
            out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left_, y,
                               left_ + width_);
            out += text_at(left_ - 7, y + 4.5, "end", "faint", number(tick));
        }
        out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>\n", left_,
                           top_, top_ + height_, left_ + width_);
        out += text_at(left_ + width_ / 2, top_ + height_ + 38, "middle", "", figure_.x.label);
        out += fmt::format(
            "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
            "text-anchor=\"middle\">{}</text>\n",
            left_ - 44, top_ + height_ / 2, base::markup_escaped(figure_.y.label));
        for (const Curve& curve : figure_.curves) out += path_of(curve, points_of(curve));
        return out;
    }

private:
    [[nodiscard]] double px(double x) const {
        return left_ + width_ * std::clamp(share_of(figure_.x, x), 0.0, 1.0);
    }
    [[nodiscard]] double py(double y) const {
        return top_ + height_ * (1.0 - std::clamp(share_of(figure_.y, y), 0.0, 1.0));
    }
    [[nodiscard]] std::string points_of(const Curve& curve) const {
        std::string out;
        for (const Curve::Point& p : curve.points)
            out += fmt::format("{}{:.1f} {:.1f}", out.empty() ? "M" : "L", px(p.x), py(p.y));
        return out;
    }

    const Figure& figure_;
    double left_, top_, width_, height_;
};

class PolarChart {
public:
    PolarChart(const Figure& figure, double x, double y)
        : figure_(figure),
          center_x_(x + cell_width / 2),
          base_(y + cell_height - margin_bottom - 18),
          top_(y) {}

    [[nodiscard]] std::string draw() const {
        std::string out =
            text_at(center_x_, top_ + margin_top - 14, "middle", "head", figure_.title);
        double labelled = 26.0;  // what lies inside would meet the middle's text
        for (const double ring : round_steps(0.0, figure_.y.high)) {
            if (ring <= 0.0) continue;
            const double r = radius * share_of(figure_.y, ring);
            if (r > radius + 0.5) continue;
            out += fmt::format(
                "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}A{2:.1f} {2:.1f} 0 0 1 {3:.1f} "
                "{1:.1f}\"/>\n",
                center_x_ - r, base_, r, center_x_ + r);
            if (r < labelled) continue;
            labelled = r + 30.0;
            out += text_at(center_x_ + r, base_ + 16, "middle", "faint", number(ring));
        }
        for (const int degrees : {-60, -30, 0, 30, 60}) {
            const auto [x, y] = at(degrees, radius);
            out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n",
                               center_x_, base_, x, y);
            const auto [tx, ty] = at(degrees, radius + 13);
            out += text_at(tx, ty + 4, "middle", "faint", fmt::format("{}°", std::abs(degrees)));
        }
        out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n",
                           center_x_ - radius, base_, center_x_ + radius);
        out += text_at(center_x_, base_ + 38, "middle", "", figure_.y.label);
        if (figure_.curves.empty())
            out += text_at(center_x_, base_ - 60.0, "middle", "faint", "none");
        for (const Curve& curve : figure_.curves) out += path_of(curve, points_of(curve));
        return out;
    }

private:
    static constexpr double radius = 168.0;

    [[nodiscard]] std::pair<double, double> at(double degrees, double r) const {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        return {center_x_ + r * std::sin(angle), base_ - r * std::cos(angle)};
    }
    [[nodiscard]] std::string points_of(const Curve& curve) const {
        std::string out;
        for (const Curve::Point& p : curve.points) {
            const auto [x, y] = at(p.x, radius * std::clamp(share_of(figure_.y, p.y), 0.0, 1.0));
            out += fmt::format("{}{:.1f} {:.1f}", out.empty() ? "M" : "L", x, y);
        }
        return out;
    }

    const Figure& figure_;
    double center_x_, base_, top_;
};

/// Names of the first figure that has any, with its curves' strokes.
std::string legend(const std::vector<Figure>& figures, double width, double y, double& height) {
    std::string out;
    height = 0.0;
    for (const Figure& figure : figures) {
        double x = 24.0;
        for (const Curve& curve : figure.curves) {
            if (curve.name.empty()) continue;
            const double needed = 48.0 + 7.4 * static_cast<double>(curve.name.size());
            if (x > 24.0 && x + needed > width) {
                x = 24.0;
                height += legend_line;
            }
            const double at = y + height + 14.0;
            out += path_of(curve, fmt::format("M{:.1f} {:.1f}h28", x, at - 4.0));
            out += text_at(x + 34.0, at, "start", "", curve.name);
            x += needed;
        }
        if (!out.empty()) {
            height += legend_line + 8.0;
            return out;
        }
    }
    return out;
}

}  // namespace

std::vector<double> round_steps(double low, double high) {
    const double rough = (high - low) / 5.0;
    if (!(rough > 0.0) || !std::isfinite(rough)) return {low};
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * 0.999) {
            step = factor * power;
            break;
        }
    std::vector<double> out;
    const double first = std::ceil(low / step - 1e-9);
    for (double i = first; i * step <= high + step * 1e-9; i += 1.0) out.push_back(i * step);
    return out;
}

std::string svg_page(const std::string& title, const std::string& subtitle,
                     const std::vector<Figure>& figures, std::size_t across) {
    const std::size_t columns = std::min(across, std::max<std::size_t>(figures.size(), 1));
    const std::size_t rows = (figures.size() + columns - 1) / columns;
    const double width = cell_width * static_cast<double>(columns);
    const double head = title.empty() ? 0.0 : head_height;
    double legend_height = 0.0;
    const double legend_y = head + cell_height * static_cast<double>(rows);
    const std::string names = legend(figures, width, legend_y, legend_height);
    const double height = legend_y + legend_height + 8.0;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "role=\"img\">\n<title>{2}</title>\n<style>{3}</style>\n"
        "<rect class=\"page\" width=\"{0:.0f}\" height=\"{1:.0f}\"/>\n",
        width, height,
        base::markup_escaped(title.empty() && !figures.empty() ? figures.front().title : title),
        style);
    if (!title.empty())
        out +=
            text_at(24, 32, "start", "title", title) + text_at(24, 53, "start", "faint", subtitle);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const double x = cell_width * static_cast<double>(i % columns);
        const double y = head + cell_height * static_cast<double>(i / columns);
        out += figures[i].kind == FigureKind::polar ? PolarChart(figures[i], x, y).draw()
                                                    : LineChart(figures[i], x, y).draw();
    }
    return out + names + "</svg>\n";
}

}  // namespace facet::image
