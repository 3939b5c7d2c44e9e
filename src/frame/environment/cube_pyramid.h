// The environment as a cube map: level 0 in half floats, and box-filtered mips for the prefilter to
// read. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/cube_mip.h"
#include "frame/environment/panorama.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet::frame {

struct CubePyramid {
    std::vector<std::uint16_t> level0;  ///< halves [6, face, face, 4]
    std::vector<CubeMip> mips;          ///< mips[i] has the side face >> (i + 1); the last has 4
    bool overflowed = false;            ///< level0 holds values that were cut to the largest half
};

/// Writes one row of texels as halves, alpha 1, and returns whether one was too large for a half.
bool store_halves(const Lanes* row, std::size_t count, std::uint16_t* out);

/// `face_px`: a power of two, at least 16. The panorama is turned counter-clockwise by
/// `rotation_deg`.
[[nodiscard]] CubePyramid make_cube_pyramid(const Panorama& panorama, std::uint32_t face_px,
                                            float rotation_deg, base::ThreadPool& pool);

}  // namespace facet::frame
