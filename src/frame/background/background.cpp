// What shows where no surface is.
// SPDX-License-Identifier: MIT
#include "frame/background/background.h"

namespace facet::frame {
namespace {

enum Unit : GLuint { cube_unit = 0, latlong_unit };

base::Result<gl::Program> make(const gl::Context& gl, const gl::ShaderSources& sources,
                               BackgroundKind kind) {
    auto program = gl::build_program(gl, sources,
                                     {"frame/full_screen.vert", "frame/background/background.frag",
                                      define("BACKGROUND_SHARP", kind == BackgroundKind::sharp)});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_sampler(gl, *program, "radiance_cube", cube_unit);
    gl::bind_sampler(gl, *program, "latlong", latlong_unit);
    return program;
}

}  // namespace

base::Status BackgroundPass::run(const gl::Context& gl, BackgroundKind kind,
                                 const EnvironmentMaps& environment, const gl::VertexArray& empty,
                                 const RadianceTarget& out) {
    if (kind == BackgroundKind::none || kind == BackgroundKind::color) return {};
    const auto program =
        programs_.get(kind, [&](BackgroundKind k) { return make(gl, *sources_, k); });
    if (!program) return tl::unexpected(program.error());
    gl::begin_draw(gl, out.framebuffer, out.size, **program, {.depth_func = GL_EQUAL});
    gl::bind_texture(gl, cube_unit, GL_TEXTURE_CUBE_MAP, environment.radiance_cube,
                     &environment.cube_sampler);
    gl::bind_texture(gl, latlong_unit, GL_TEXTURE_2D, environment.latlong,
                     &environment.latlong_sampler);
    gl::draw_full_screen(gl, empty);
    return {};
}

}  // namespace facet::frame
