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

/// What the heat map shows: FLIP where it is known, or the largest error of a pixel's channels.
enum class Heat { flip, error };

struct CompareOptions {
    Pixels pixels = Pixels::all;
    std::string
        layer;  ///< "" for beauty, compared as shown; other layers by their values as they are
    Heat heat = Heat::error;
};

/// Errors of display values in [0, 1], over R, G and B of the pixels compared.
struct Difference {
    double rmse = 0.0;
    double psnr_db = 0.0;  ///< 20 log10(1 / rmse); infinite for equal pictures
    double max_error = 0.0;
    /// Mean of (a - b)^2 / (a^2 + 0.01) in linear light, a being the reference (Rousselle, Knaus &
    /// Zwicker 2011, Section 6); of scene-linear files it is of their radiance. Values that are not
    /// finite or negative count as 0.
    double relative_mse = 0.0;
    std::optional<double>
        flip;  ///< mean FLIP at 67 pixels per degree, a being the reference; beauty over all pixels
    bool flip_is_hdr = false;       ///< of two scene-linear files
    std::uint64_t pixel_count = 0;  ///< compared
    Image heat;                     ///< u8 RGB: dark where equal, light where not
};

/// What the picture shows: f32 [height, width, 4], sRGB-encoded [0, 1], straight alpha (1 where
/// there is none). Scene-linear formats (EXR, HDR) are clipped to [0, 1] and encoded, with no
/// exposure; NaN is 0.
[[nodiscard]] Image shown(const Picture& picture);

/// Errors: input_invalid for different sizes, a layer that one of them lacks, and no covered pixel.
[[nodiscard]] base::Result<Difference> compare(const Picture& a, const Picture& b,
                                               const CompareOptions& options = {});

}  // namespace facet::image
