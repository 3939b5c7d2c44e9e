// The light of one frame apart by the way it took: targets that the lighting and blend passes draw
// into once more. SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"

#include <optional>
#include <vector>

namespace facet::frame {

struct LightPathTarget {
    std::vector<tables::Aov> paths;             ///< a colour of `light` each
    RadianceTarget light;                       ///< a: what surfaces cover
    std::optional<gl::Framebuffer> background;  ///< of its colour alone, where it is wanted

    /// `paths` are rows of that kind, one at least; `depth` outlives the target.
    [[nodiscard]] static base::Result<LightPathTarget> create(const gl::Context& gl,
                                                              std::vector<tables::Aov> paths,
                                                              math::Extent size,
                                                              const gl::Texture& depth);
};

}  // namespace facet::frame
