// How far two pictures are apart: RMSE, PSNR, largest error, and where.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/image.h"
#include "image/read.h"

#include <cstdint>
#include <optional>
#include <string>

namespace facet::image {

enum class Pixels { all, covered };  ///< covered: alpha above 0.5 in both pictures

struct CompareOptions {
    Pixels pixels = Pixels::all;
    std::string
        layer;  ///< "" for beauty, compared as shown; other layers by their values as they are
};

/// Errors of display values in [0, 1], over R, G and B of the pixels compared.
struct Difference {
    double rmse = 0.0;
    double psnr_db = 0.0;  ///< 20 log10(1 / rmse); infinite for equal pictures
    double max_error = 0.0;
    std::optional<double>
        flip;  ///< mean LDR-FLIP at 67 pixels per degree; beauty over all pixels only
    std::uint64_t pixel_count = 0;  ///< compared
    Image heat;  ///< u8 RGB: black (equal) over red and yellow to white (error 1)
};

/// What the picture shows: f32 [height, width, 4], sRGB-encoded [0, 1], straight alpha (1 where
/// there is none). Scene-linear formats (EXR, HDR) are clipped to [0, 1] and encoded, with no
/// exposure; NaN is 0.
[[nodiscard]] Image shown(const Picture& picture);

/// Errors: input_invalid for different sizes, a layer that one of them lacks, and no covered pixel.
[[nodiscard]] base::Result<Difference> compare(const Picture& a, const Picture& b,
                                               const CompareOptions& options = {});

}  // namespace facet::image
