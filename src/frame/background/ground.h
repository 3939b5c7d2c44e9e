// The ground that catches shadows: what shows behind the scene, dimmed.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"
#include "frame/shared.h"

namespace facet::frame {

class GroundPass {
public:
    explicit GroundPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Multiplies what is there with `share` (RGBA32F, over the whole picture) where View::ground
    /// is before all surfaces; shadow covers what is not covered.
    [[nodiscard]] base::Status run(const gl::Context& gl, const gl::Texture& share,
                                   const gl::VertexArray& empty, const DrawTarget& out);

private:
    const gl::ShaderSources* sources_;
    gl::Program program_;
    gl::Sampler sampler_;
};

}  // namespace facet::frame
