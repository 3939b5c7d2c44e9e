// Ambient visibility from the G-buffer, where no rays find it.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/gbuffer/gbuffer.h"

namespace facet::frame {

class OcclusionPass {
public:
    explicit OcclusionPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// For a G-buffer, whose depth it shares; again when that is another.
    [[nodiscard]] base::Status make_target(const gl::Context& gl, const GBuffer& gbuffer);
    /// Writes texture() where the G-buffer has a surface. Errors: limit_reached, internal.
    [[nodiscard]] base::Status run(const gl::Context& gl, const GBuffer& gbuffer,
                                   const gl::VertexArray& empty);
    /// RGBA16F: bent normal in world space, visible share of a cosine.
    [[nodiscard]] const gl::Texture& texture() const { return texture_; }

private:
    const gl::ShaderSources* sources_;
    gl::Program program_;
    gl::Texture texture_;
    gl::Framebuffer framebuffer_;
};

}  // namespace facet::frame
