// The samples of a picture as they add up, and how certain their mean is.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/read.h"
#include "tables/aovs.h"
#include "trace/path.h"

#include <cstdint>
#include <vector>

namespace facet::trace {

inline constexpr std::uint32_t tile_px = 16;

/// Sums of one pixel, in double: thousands of samples, one of which may be a sun.
struct PixelSums {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double luminance2 = 0.0;  ///< of squares
    double coverage = 0.0;
    std::uint32_t count = 0;  ///< finite samples
};

class Film {
public:
    /// `paths`: rows of the table to keep beside the picture, all light paths.
    explicit Film(math::Extent size, std::vector<tables::Aov> paths = {});

    /// A sample that is not finite is left out; false then.
    bool add(std::size_t pixel, const PathLight& light, const LightPaths& apart = {});
    [[nodiscard]] bool keeps_paths() const { return !paths_.empty(); }

    /// f32 [height, width, 4], radiance in nit with coverage associated. A pixel without a sample
    /// is black.
    [[nodiscard]] image::Image mean() const;

    /// A layer each of the rows kept, f32 in nit.
    [[nodiscard]] std::vector<image::Layer> mean_paths() const;

    /// What the mean of the tile's samples may be off by, in display values: root of the mean
    /// square over its pixels of the standard error of sRGB(exposure * luminance), clipped to [0,
    /// 1] as a screen does.
    [[nodiscard]] double tile_error(std::size_t tile, double exposure) const;
    /// The same of the whole picture.
    [[nodiscard]] double error(double exposure) const;
    [[nodiscard]] std::size_t tile_count() const { return std::size_t{across_} * down_; }
    /// Pixels of a tile: first and one past the last, along both sides.
    struct TileBox {
        std::uint32_t x0, y0, x1, y1;
    };
    [[nodiscard]] TileBox tile_box(std::size_t tile) const;

private:
    /// Sum of the squares over the box.
    [[nodiscard]] double squared_error(const TileBox& box, double exposure) const;

    math::Extent size_;
    std::uint32_t across_;
    std::uint32_t down_;
    std::vector<PixelSums> pixels_;
    std::vector<tables::Aov> paths_;
    std::vector<double> path_sums_;  ///< [pixel, row of paths_, 3]
};

}  // namespace facet::trace
