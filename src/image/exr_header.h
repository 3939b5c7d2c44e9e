// The headers of an OpenEXR file, read and bounded before the library sees the file.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "image/dispatch.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace facet::image::exr {

struct Channel {
    std::string name;
    std::uint32_t type = 0;  ///< 0 uint, 1 half, 2 float
    std::int32_t x_sampling = 1;
    std::int32_t y_sampling = 1;
};

/// One header. Windows are inclusive: x_min, y_min, x_max, y_max.
struct Part {
    std::string name;
    std::string type;  ///< "" in files of one part
    std::int32_t window[4] = {0, 0, -1, -1};
    math::Extent size;  ///< of the data window
    std::vector<Channel> channels;
    std::uint8_t compression = 0;
    bool is_tiled = false;
    bool is_deep = false;
    std::uint32_t tile[2] = {0, 0};
    std::vector<std::pair<std::string, std::string>> strings;  ///< string attributes
};

/// All headers. Sizes, tiles and channels are checked against `limits` and against what a file of
/// this length can hold. Errors: input_invalid, limit_reached; feature_missing for a deep or
/// luminance-chroma first part.
[[nodiscard]] base::Result<std::vector<Part>> read_parts(FileBytes file,
                                                         const base::Limits& limits);

/// "normal.X" is channel X of layer normal; R G B A Y without a dot are of the unnamed layer, any
/// other name without a dot is a layer of its own.
struct ChannelPlace {
    std::string layer;
    std::string channel;
};
[[nodiscard]] ChannelPlace place_of(const std::string& name);

}  // namespace facet::image::exr
