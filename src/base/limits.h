// Bounds on what an input may ask for; checked from headers and counts before anything is
// allocated. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace facet::base {

/// Every field is a maximum; the option that raises it stands beside it.
struct Limits {
    std::size_t memory_bytes = std::size_t{8} << 30;      ///< --max-memory
    std::size_t file_bytes = (std::size_t{4} << 30) - 1;  ///< tinygltf's sizes are 32 bits
    std::size_t json_bytes = std::size_t{256} << 20;
    std::size_t json_depth = 64;
    std::size_t json_values = 1'000'000;
    std::size_t json_string_bytes = std::size_t{1}
                                    << 20;  ///< data URIs are exempt, and bounded by file_bytes
    std::size_t vertices = 100'000'000;     ///< --max-vertices
    std::uint32_t image_side_px = 16384;
    std::uint64_t image_pixels = 268'435'456;
    std::size_t node_depth = 10'000;
    std::size_t lights = 1000;
};

}  // namespace facet::base
