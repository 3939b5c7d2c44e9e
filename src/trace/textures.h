// The images that materials use, as the tracer reads them: the mip levels that the rasteriser
// uploads. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace facet::trace {

/// One image with its levels: u8 RGBA.
using MipImage = std::vector<image::Image>;

class Textures {
public:
    /// Builds the levels of every image that a material uses, on `pool`.
    [[nodiscard]] static Textures build(const scene::Scene& scene, base::ThreadPool& pool);

    /// Linear RGBA in [0, 1] at `uv` (transformed already), bilinear in the level nearest to `lod`,
    /// which counts halvings of the whole picture. A missing image is white. `texels` is the
    /// slot's.
    [[nodiscard]] math::Vec4 sample(const scene::Texture& texture, tables::Texels texels,
                                    math::Vec2 uv, float lod) const;
    /// Width and height of the picture, in texels; 1 x 1 where it is missing.
    [[nodiscard]] math::Extent size(scene::ImageId image) const;

private:
    [[nodiscard]] const MipImage* find(scene::ImageId image, tables::Texels texels) const;

    /// By image, then by what it is used as.
    std::vector<std::array<MipImage, tables::texels_count>> images_;
};

}  // namespace facet::trace
