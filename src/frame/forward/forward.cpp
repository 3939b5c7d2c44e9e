// Surfaces that are shaded as they are drawn.
// SPDX-License-Identifier: MIT
#include "frame/forward/forward.h"

namespace facet::frame {

base::Result<gl::Program> ForwardPass::make(const gl::Context& gl, const Key& key) const {
    auto program = gl::build_program(gl, *sources_,
                                     {"frame/gbuffer/gbuffer.vert", "frame/forward/forward.frag",
                                      defines(key.material) + defines(key.shade) +
                                          define("FORWARD", true) + define("BLEND", key.blend)});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_block(gl, *program, "DrawBlock", draw_binding);
    bind_material_samplers(gl, *program, key.material);
    set_shade_samplers(gl, *program);
    return program;
}

base::Status ForwardPass::begin(const gl::Context& gl, const GpuScene& scene, const Key& key,
                                const gl::Pipeline& pipeline, const ShadeInputs& in,
                                const DrawTarget& out) {
    const auto program = programs_.get(key, [&](const Key& k) { return make(gl, k); });
    if (!program) return tl::unexpected(program.error());
    gl::begin_draw(gl, out.framebuffer, out.size, **program, pipeline);
    bind_shade_textures(gl, in);
    gl.api().BindVertexArray(scene.vertex_array.name());
    return {};
}

base::Status ForwardPass::run_blended(const gl::Context& gl, const GpuScene& scene,
                                      const std::vector<std::size_t>& order, const ShadeInputs& in,
                                      const DrawTarget& out) {
    for (const std::size_t index : order) {
        const Draw& draw = scene.draws[index];
        if (!draw.blended) continue;
        gl::Pipeline pipeline{.depth_func = GL_LEQUAL,
                              .blend = gl::Blend::over,
                              .cull = draw.double_sided ? gl::Cull::front : gl::Cull::back};
        if (auto s = begin(gl, scene, {draw.key, in.key, true}, pipeline, in, out); !s) return s;
        draw_instance(gl, scene, draw);
        if (!draw.double_sided) continue;
        pipeline.cull = gl::Cull::back;
        gl::set_pipeline(gl, pipeline);
        draw_instance(gl, scene, draw);
    }
    return {};
}

base::Status ForwardPass::run_layered(const gl::Context& gl, const GpuScene& scene,
                                      const ShadeInputs& in, const DrawTarget& out) {
    for (const Draw& draw : scene.draws) {
        if (!draw.layered) continue;
        const gl::Pipeline pipeline{.depth_func = GL_EQUAL,
                                    .cull = draw.double_sided ? gl::Cull::none : gl::Cull::back};
        if (auto s = begin(gl, scene, {draw.key, in.key, false}, pipeline, in, out); !s) return s;
        draw_instance(gl, scene, draw);
    }
    return {};
}

}  // namespace facet::frame
