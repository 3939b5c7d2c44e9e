// The images that materials use, as the tracer reads them: the mip levels that the rasteriser
// uploads. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace facet::trace {

/// One image of one colour space with its levels.
struct MipImage {
    std::vector<image::Image> levels;  ///< u8 RGBA
    bool srgb = false;
};

class Textures {
public:
    /// Builds the levels of every image that a material uses, on `pool`.
    [[nodiscard]] static Textures build(const scene::Scene& scene, base::ThreadPool& pool);

    /// Linear RGBA in [0, 1] at `uv` (transformed already), bilinear in the level nearest to `lod`,
    /// which counts halvings of the whole picture. A missing image is white. `space` is the slot's.
    [[nodiscard]] math::Vec4 sample(const scene::Texture& texture, tables::Space space,
                                    math::Vec2 uv, float lod) const;
    /// Width and height of the picture, in texels; 1 x 1 where it is missing.
    [[nodiscard]] math::Extent size(scene::ImageId image) const;

private:
    [[nodiscard]] const MipImage* find(scene::ImageId image, tables::Space space) const;

    std::vector<std::array<MipImage, 2>> images_;  ///< by image, then as it is and as sRGB
};

}  // namespace facet::trace
