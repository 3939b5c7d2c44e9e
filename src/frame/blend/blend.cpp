// Alpha-blended surfaces, after the opaque ones.
// SPDX-License-Identifier: MIT
#include "frame/blend/blend.h"

namespace facet::frame {

base::Result<gl::Program> BlendPass::make(const gl::Context& gl, const Key& key) const {
    auto program =
        gl::build_program(gl, *sources_,
                          {"frame/gbuffer/gbuffer.vert", "frame/blend/blend.frag",
                           defines(key.material) + defines(key.shade) + define("BLEND", true)});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_block(gl, *program, "DrawBlock", draw_binding);
    bind_material_samplers(gl, *program);
    set_shade_samplers(gl, *program);
    return program;
}

base::Status BlendPass::run(const gl::Context& gl, const GpuScene& scene,
                            const std::vector<std::size_t>& order, const ShadeInputs& in,
                            const DrawTarget& out) {
    for (const std::size_t index : order) {
        const Draw& draw = scene.draws[index];
        if (!draw.blended) continue;
        const auto program =
            programs_.get({draw.key, in.key}, [&](const Key& k) { return make(gl, k); });
        if (!program) return tl::unexpected(program.error());
        gl::Pipeline pipeline{.depth_func = GL_LEQUAL,
                              .blend = gl::Blend::over,
                              .cull = draw.double_sided ? gl::Cull::front : gl::Cull::back};
        gl::begin_draw(gl, out.framebuffer, out.size, **program, pipeline);
        bind_shade_textures(gl, in);
        gl.api().BindVertexArray(scene.vertex_array.name());
        draw_instance(gl, scene, draw);
        if (!draw.double_sided) continue;
        pipeline.cull = gl::Cull::back;
        gl::set_pipeline(gl, pipeline);
        draw_instance(gl, scene, draw);
    }
    return {};
}

}  // namespace facet::frame
