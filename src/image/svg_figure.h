// Line charts and polar charts as SVG that reads well on light and on dark pages.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace facet::image {

/// One curve. For a polar figure x is the angle from the upright in degrees, -90 to 90, right
/// positive, and y the radius.
struct Curve {
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    std::string name;  ///< for the legend; empty: in no legend
    std::vector<Point> points;
    std::size_t color = 0;  ///< of a palette of eight, again from the start after them
    std::size_t dash = 0;   ///< 0 solid, 1 dashed, 2 dotted
};

enum class FigureKind { lines, polar };
enum class Scale { linear, logarithmic, root };

struct Axis {
    std::string label;  ///< with its unit
    double low = 0.0;
    double high = 1.0;
    Scale scale = Scale::linear;
};

/// `y` of a polar figure is its radius, from 0.
struct Figure {
    FigureKind kind = FigureKind::lines;
    std::string title;
    Axis x;
    Axis y;
    std::vector<Curve> curves;
};

/// Figures in rows of `across`, under a title and a line of text (neither where the title is
/// empty), above one legend for all (the names of the first figure that has any). The text is UTF-8
/// and escaped here; widths suit printing and screens from 720 px on.
[[nodiscard]] std::string svg_page(const std::string& title, const std::string& subtitle,
                                   const std::vector<Figure>& figures, std::size_t across);

/// Round steps that divide [low, high] into five or so: 1, 2 or 5 times a power of ten.
[[nodiscard]] std::vector<double> round_steps(double low, double high);

}  // namespace facet::image
