// From a lat-long picture to rows of a cube map's faces, every texel an average over its area.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/panorama.h"

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
    [[nodiscard]] float wrapped(float x) const noexcept;

    const Panorama& panorama_;
    std::uint32_t face_px_;
    std::uint32_t taps_;
    float columns_per_radian_;
    float rows_per_radian_;
    float x_of_zero_;                  ///< column of phi = 0 (the direction -z), turned
    std::vector<float> s_;             ///< by tap column, -1..1
    std::vector<float> side_columns_;  ///< atan(s) in columns
    std::vector<float> side_cosine_;   ///< 1 / sqrt(1 + s^2)
};

}  // namespace facet::frame
