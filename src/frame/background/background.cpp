// What shows where no surface is.
// SPDX-License-Identifier: MIT
#include "frame/background/background.h"

namespace facet::frame {
namespace {

base::Result<gl::Program> make(const gl::Context& gl, const gl::ShaderSources& sources) {
    auto program = gl::build_program(
        gl, sources, {"frame/background/background.vert", "frame/background/background.frag", ""});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_sampler(gl, *program, "radiance_cube", 0);
    return program;
}

}  // namespace

base::Status BackgroundPass::run(const gl::Context& gl, const EnvironmentMaps& environment,
                                 const gl::VertexArray& empty, const DrawTarget& out) {
    if (!program_) {
        auto made = make(gl, *sources_);
        if (!made) return tl::unexpected(made.error());
        program_ = std::move(*made);
    }
    gl::begin_draw(gl, out.framebuffer, out.size, program_, {.depth_func = GL_EQUAL});
    gl::bind_texture(gl, 0, GL_TEXTURE_CUBE_MAP, environment.radiance_cube,
                     &environment.cube_sampler);
    gl::draw_full_screen(gl, empty);
    return {};
}

}  // namespace facet::frame
