// The fixed-function state of a draw.
// SPDX-License-Identifier: MIT
#include "gl/pipeline.h"

namespace facet::gl {
namespace {

void enable(const Api& api, GLenum capability, bool on) {
    on ? api.Enable(capability) : api.Disable(capability);
}

}  // namespace

void set_pipeline(const Context& gl, const Pipeline& pipeline) {
    const Api& api = gl.api();
    const bool depth = pipeline.depth_func != GL_ALWAYS || pipeline.depth_write;
    enable(api, GL_DEPTH_TEST, depth);
    api.DepthFunc(pipeline.depth_func);
    api.DepthMask(pipeline.depth_write ? GL_TRUE : GL_FALSE);
    enable(api, GL_BLEND, pipeline.blend != Blend::off);
    api.BlendEquation(GL_FUNC_ADD);
    const bool over = pipeline.blend == Blend::over || pipeline.blend == Blend::over_straight;
    const GLenum to = over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
    const GLenum from = pipeline.blend == Blend::over_straight ? GL_SRC_ALPHA : GL_ONE;
    if (pipeline.blend == Blend::multiply)
        api.BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    else
        api.BlendFuncSeparate(from, to, GL_ONE, to);
    enable(api, GL_SCISSOR_TEST, pipeline.scissor);
    enable(api, GL_DEPTH_CLAMP, !pipeline.clips_depth);
    enable(api, GL_CULL_FACE, pipeline.cull != Cull::none);
    api.CullFace(pipeline.cull == Cull::front ? GL_FRONT : GL_BACK);
    api.FrontFace(GL_CCW);
    api.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void begin_draw(const Context& gl, const Framebuffer& target, math::Extent size,
                const Program& program, const Pipeline& pipeline) {
    const Api& api = gl.api();
    api.BindFramebuffer(GL_FRAMEBUFFER, target.name());
    api.Viewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
    api.UseProgram(program.name());
    set_pipeline(gl, pipeline);
}

void draw_full_screen(const Context& gl, const VertexArray& empty) {
    gl.api().BindVertexArray(empty.name());
    gl.api().DrawArrays(GL_TRIANGLES, 0, 3);
}

VertexArray make_vertex_array(const Context& gl) {
    GLuint name = 0;
    gl.api().GenVertexArrays(1, &name);
    return VertexArray(gl.api(), name);
}

void bind_texture(const Context& gl, GLuint unit, GLenum target, const Texture& texture,
                  const Sampler* sampler) {
    const Api& api = gl.api();
    api.ActiveTexture(GL_TEXTURE0 + unit);
    api.BindTexture(target, texture.name());
    api.BindSampler(unit, sampler == nullptr ? 0 : sampler->name());
}

}  // namespace facet::gl
