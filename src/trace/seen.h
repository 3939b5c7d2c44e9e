// A picture's surfaces as a rasteriser saw them, and the light that rays find there.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "math/vector.h"
#include "trace/surface.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace facet::trace {

/// Pixels [height, width], rows from the bottom.
struct Seen {
    math::Extent size;
    math::Mat4 world_from_clip{1.0F};
    math::Vec3 eye_m{0.0F};
    math::Vec3 forward{0.0F, 0.0F, -1.0F};
    bool is_perspective = true;
    float pixel_m = 0.0F;       ///< width of a pixel at the eye
    float pixel_spread = 0.0F;  ///< its growth per metre
    /// Place of the lower left pixel in the whole picture, from its top left: what random numbers
    /// are drawn by, so that a part of a picture is the same as in the whole.
    std::uint32_t first_x = 0;
    std::uint32_t last_y = 0;
    std::uint32_t picture_width = 0;
    std::vector<SeenPixel> pixels;

    [[nodiscard]] std::uint32_t number_of(std::uint32_t x, std::uint32_t y) const {
        return (last_y - y) * picture_width + first_x + x;
    }
    /// From the eye through the middle of a pixel.
    [[nodiscard]] Ray ray(std::uint32_t x, std::uint32_t y) const;
    [[nodiscard]] float pixel_width_at(const math::Vec3& position_m) const {
        return pixel_m + pixel_spread * math::dot(position_m - eye_m, forward);
    }
};

/// Calls of(x, y, index, pixel) for every pixel that has a surface, row by row on `pool`.
template <class Of>
void for_each_surface(const Seen& seen, base::ThreadPool& pool, const Of& of) {
    pool.parallel_for(seen.size.height, [&](std::size_t row) {
        for (std::uint32_t x = 0; x < seen.size.width; ++x) {
            const std::size_t at = row * seen.size.width + x;
            const SeenPixel& pixel = seen.pixels[at];
            if (pixel.instance != SeenPixel::nothing)
                of(x, static_cast<std::uint32_t>(row), at, pixel);
        }
    });
}

struct GatherSettings {
    std::uint32_t samples = 8;       ///< paths at each place, at least
    std::uint32_t most_samples = 8;  ///< and at most, where those disagree
    float error = 0.05F;             ///< wanted of the light seen, relative, after smoothing
    std::uint32_t stride =
        1;                    ///< one pixel in stride x stride is a place that light is gathered at
    std::uint32_t apart = 1;  ///< one place in apart x apart is drawn for, where surfaces are rough
    std::uint32_t bounces = 64;
    std::uint32_t seed = 0;
    float mirrored_alpha = 0.0F;  ///< specular light below is asked for at every frame, and
    std::uint32_t intricate = 0;  ///< all light by this many where few places around are alike;
    std::uint32_t most_at_sample = 1;  ///< by up to so many where the mean over
    std::uint32_t frames = 1;          ///< these frames would be less certain than `error`
    std::uint32_t far = 1;             ///< paths a sample from a surface's far side
    const std::atomic<bool>* cancelled = nullptr;  ///< once true, what is returned is of no use
    /// Roughly the radiance that a surface of that roughness mirrors from a direction: specular
    /// light is smoothed in its units, so that what the environment makes of a curved surface
    /// stays.
    std::function<math::Vec3(const math::Vec3& direction, float roughness)> expected;
};

/// Indirect light at some of a picture's pixels: [height, width], rows from the bottom, smoothed
/// over each surface. In units in which the material is left out, so that it can be put back at
/// each sample of a pixel:
///   diffuse = weight (irradiance / pi * sky + rest), specular = weight * specular
/// with the environment's weights of brdf_environment().
struct IndirectPixels {
    math::Extent size;
    std::uint32_t stride = 1;
    std::vector<math::Vec4> sky;       ///< rgb: share of the environment's irradiance that arrives
    std::vector<math::Vec4> rest;      ///< rgb: other irradiance / pi, nit
    std::vector<math::Vec4> specular;  ///< rgb: nit, mean over the lobe
    std::vector<math::Vec4> guide;     ///< xyz: position in metres; w: packed_normal(), -1: nothing
    std::vector<std::uint8_t> intricate;  ///< 1 where few places around are alike
    std::vector<std::uint8_t> at_sample;  ///< paths that a sample of a frame needs there, from 1
};

/// By how much a scene changes the light on the ground below it (path.h, ground_share()), at the
/// places of IndirectPixels: [height, width], rgb; 1 where no ground is. Smoothed.
struct GroundPixels {
    math::Extent size;
    std::vector<math::Vec4> share;
};

/// Light of single samples, in the same units: [height, width]; a: 1 where it is there.
struct SampleLight {
    std::vector<math::Vec4> diffuse;   ///< rgb: irradiance / pi, nit; all of it
    std::vector<math::Vec4> specular;  ///< rgb: nit
    /// Light from the surface's far side, as it leaves to the viewer, with nothing left out: rgb in
    /// nit. Empty where no material is translucent.
    std::vector<math::Vec4> far;
};

/// A unit vector as 24 bits of an octahedral map; exact in float.
[[nodiscard]] float packed_normal(const math::Vec3& n);

/// Which numbers are drawn: those of a picture's frame.
struct SampleId {
    std::uint32_t frame = 0;
    std::uint32_t seed = 0;
};

/// Lights that may reach a pixel, as indices of the scene's.
class LightChoice {
public:
    virtual ~LightChoice() = default;
    [[nodiscard]] virtual std::span<const std::uint16_t> at(std::uint32_t x,
                                                            std::uint32_t y) const = 0;
};

}  // namespace facet::trace
