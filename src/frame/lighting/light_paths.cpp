// The light of one frame apart by the way it took.
// SPDX-License-Identifier: MIT
#include "frame/lighting/light_paths.h"

#include <array>

namespace facet::frame {

base::Result<LightPathTarget> LightPathTarget::create(const gl::Context& gl,
                                                      std::vector<tables::Aov> paths,
                                                      math::Extent size, const gl::Texture& depth) {
    LightPathTarget out;
    out.paths = std::move(paths);
    auto light = RadianceTarget::create(gl, size, depth, out.paths.size());
    if (!light) return tl::unexpected(light.error());
    out.light = std::move(*light);
    for (std::size_t i = 0; i < out.paths.size(); ++i) {
        if (out.paths[i] != tables::Aov::background) continue;
        const std::array<const gl::Texture*, 1> color = {&out.light.colors[i]};
        auto background = gl::make_framebuffer(gl, color, &depth);
        if (!background) return tl::unexpected(background.error());
        out.background = std::move(*background);
    }
    return out;
}

}  // namespace facet::frame
