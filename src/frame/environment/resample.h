// From a lat-long picture to rows of a cube map's faces, every texel an average over its area.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/panorama.h"

#include <array>
#include <cstdint>
#include <vector>

namespace facet::frame {

/// Averages `taps` x `taps` bilinear samples a texel: enough that their spacing is below one source
/// pixel.
class CubeResampler {
public:
    CubeResampler(const Panorama& panorama, std::uint32_t face_px, float rotation_deg);

    /// Row `row` of the faces +x -x +z -z, in this order: [4, face_px].
    void side_rows(std::uint32_t row, Lanes* out) const;
    /// Row `row` of the faces +y -y: [2, face_px].
    void pole_rows(std::uint32_t row, Lanes* out) const;

private:
    /// Pixel to the left of (above) each tap, and how far the tap is towards the next.
    struct Taps {
        std::vector<std::int32_t> index;
        std::vector<float> fraction;
    };
    [[nodiscard]] Taps columns_of(const std::vector<float>& x) const;
    [[nodiscard]] static Taps rows_of(const std::vector<float>& y);
    void add_row(const Taps& columns, const Taps& rows, Lanes* out) const;

    const Panorama& panorama_;
    std::uint32_t face_px_;
    std::uint32_t taps_;
    float columns_per_radian_;
    float rows_per_radian_;
    float column_of_zero_ = 0.0F;       ///< where phi = 0 (the direction -z) is, turned
    std::vector<float> s_;              ///< by tap, -1..1
    std::vector<float> side_cosine_;    ///< 1 / sqrt(1 + s^2)
    std::array<Taps, 4> side_columns_;  ///< of +x -x +z -z; the same in every row
};

}  // namespace facet::frame
