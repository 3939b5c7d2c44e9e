// The ground that catches shadows.
// SPDX-License-Identifier: MIT
#include "frame/background/ground.h"

namespace facet::frame {

base::Status GroundPass::run(const gl::Context& gl, const gl::Texture& share,
                             const gl::VertexArray& empty, const DrawTarget& out) {
    if (!program_) {
        auto made = gl::build_program(
            gl, *sources_, {"frame/background/ground.vert", "frame/background/ground.frag", ""});
        if (!made) return tl::unexpected(made.error());
        program_ = std::move(*made);
        gl::bind_block(gl, program_, "ViewBlock", view_binding);
        gl::bind_sampler(gl, program_, "ground_share", 0);
        sampler_ = gl::make_sampler(gl, {.min_filter = GL_LINEAR, .mag_filter = GL_LINEAR});
    }
    // The far plane is behind the scene, and the ground goes on.
    gl::begin_draw(gl, out.framebuffer, out.size, program_,
                   {.depth_func = GL_LEQUAL,
                    .blend = gl::Blend::multiply,
                    .cull = gl::Cull::back,
                    .clips_depth = false});
    gl::bind_texture(gl, 0, GL_TEXTURE_2D, share, &sampler_);
    gl.api().BindVertexArray(empty.name());
    constexpr GLsizei corners = 6;
    gl.api().DrawArrays(GL_TRIANGLES, 0, corners);
    return {};
}

}  // namespace facet::frame
