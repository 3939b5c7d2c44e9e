// Ambient visibility from the G-buffer.
// SPDX-License-Identifier: MIT
#include "frame/occlusion/occlusion.h"

#include "frame/shared.h"

#include <array>

namespace facet::frame {

base::Status OcclusionPass::make_target(const gl::Context& gl, const GBuffer& gbuffer) {
    auto texture = gl::make_texture(gl, {.format = GL_RGBA16F, .size = gbuffer.spec.size});
    if (!texture) return tl::unexpected(texture.error());
    texture_ = std::move(*texture);
    const std::array<const gl::Texture*, 1> colors = {&texture_};
    auto framebuffer = gl::make_framebuffer(gl, colors, &gbuffer.depth);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    framebuffer_ = std::move(*framebuffer);
    return {};
}

base::Status OcclusionPass::run(const gl::Context& gl, const GBuffer& gbuffer,
                                const gl::VertexArray& empty) {
    if (!program_) {
        auto made = gl::build_program(
            gl, *sources_, {"frame/full_screen.vert", "frame/occlusion/occlusion.frag", ""});
        if (!made) return tl::unexpected(made.error());
        program_ = std::move(*made);
        gl::bind_block(gl, program_, "ViewBlock", view_binding);
        gl::bind_sampler(gl, program_, "gbuffer_normal", 0);
        gl::bind_sampler(gl, program_, "gbuffer_depth", 1);
    }
    // At the far plane with depth GREATER, as the lighting pass.
    gl.texture_barrier();
    gl::begin_draw(gl, framebuffer_, gbuffer.spec.size, program_, {.depth_func = GL_GREATER});
    gl::bind_texture(gl, 0, GL_TEXTURE_2D, gbuffer.normal, nullptr);
    gl::bind_texture(gl, 1, GL_TEXTURE_2D, gbuffer.depth, nullptr);
    gl::draw_full_screen(gl, empty);
    return {};
}

}  // namespace facet::frame
