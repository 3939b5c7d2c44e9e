// Image-based light, baked on the CPU from a lat-long picture: irradiance and prefiltered radiance.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "base/thread_pool.h"
#include "frame/environment/cube_mip.h"
#include "image/image.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace facet::frame {

/// Level i of `radiance` is prefiltered for roughness i / (levels - 1); 0 is the picture itself.
struct BakedEnvironment {
    std::uint32_t face_px =
        0;  ///< side of a face of level 0; each level has half the side of the one before
    /// Half floats [6, side, side, 4] per level, faces in GL's order +x -x +y -y +z -z, rows as GL
    /// wants them.
    std::vector<std::vector<std::uint16_t>> radiance;
    static constexpr std::uint32_t irradiance_px = 16;
    /// Irradiance / pi, half floats [6, 16, 16, 4] likewise.
    std::vector<std::uint16_t> irradiance;
    /// The levels of roughness above `first_kept`, in floats, for look-ups on the CPU.
    std::vector<CubeMip> kept;
    static constexpr std::size_t first_kept = 2;
    float unit_nit = 1.0F;  ///< what 1 in all of them is: a power of two, 1 but for blinding light
    bool overflowed = false;  ///< level 0 was cut to the largest half float
};

/// Of faces of level 0, a power of two. Fewer than five levels would show between two roughnesses;
/// 1024 are 50 MB of half floats.
inline constexpr std::uint32_t baked_face_min_px = 128;
inline constexpr std::uint32_t baked_face_max_px = 1024;
/// How many levels such a face has.
[[nodiscard]] std::uint32_t baked_level_count(std::uint32_t face_px);

/// Bakes `latlong` ([h, w, 3] f32, nit) turned counter-clockwise (seen from above) by
/// `rotation_deg` and multiplied by `intensity`. Same bytes for any thread count.
[[nodiscard]] BakedEnvironment bake_environment(const image::Image& latlong, float rotation_deg,
                                                float intensity, base::ThreadPool& pool);
/// What the user should know of it.
void warn_of(const BakedEnvironment& baked, base::Warnings& warnings);

}  // namespace facet::frame
