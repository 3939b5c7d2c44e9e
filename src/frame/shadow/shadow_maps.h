// Shadow maps: the depths that lights see, in one atlas.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/gbuffer/gbuffer.h"
#include "frame/permutations.h"
#include "frame/shadow/shadow_textures.h"
#include "frame/shadow/shadow_views.h"

namespace facet::frame {

class ShadowPass {
public:
    explicit ShadowPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Draws every opaque instance into every map, but for the shape of the map's own light.
    /// `light_order`: which of the scene's lights each of the plan is. Binds a view block of its
    /// own. Errors: limit_reached, internal.
    [[nodiscard]] base::Status run(const gl::Context& gl, const GpuScene& scene,
                                   const ShadowPlan& plan,
                                   std::span<const std::size_t> light_order);
    [[nodiscard]] const ShadowTextures& textures() const { return textures_; }

private:
    [[nodiscard]] base::Status make_targets(const gl::Context& gl);
    [[nodiscard]] base::Status draw(const gl::Context& gl, const GpuScene& scene,
                                    const ShadowView& view, std::size_t light);
    const gl::ShaderSources* sources_;
    Permutations<MaterialKey> programs_;
    ShadowTextures textures_;
    gl::Framebuffer framebuffer_;
    gl::Buffer view_block_;
};

}  // namespace facet::frame
