// The fixed-function state of a draw, as a value: nothing relies on what was bound before.
// SPDX-License-Identifier: MIT
#pragma once

#include "gl/context.h"
#include "gl/handle.h"
#include "math/vector.h"

#include <span>

namespace facet::gl {

/// over: associated alpha; over_straight: straight alpha; multiply: colours, and alpha as over.
enum class Blend { off, add, over, over_straight, multiply };
enum class Cull { none, back, front };

struct Pipeline {
    GLenum depth_func = GL_ALWAYS;
    bool depth_write = false;
    Blend blend = Blend::off;
    Cull cull = Cull::none;
    bool scissor = false;
    bool clips_depth = true;  ///< else what is beyond the near or far plane is drawn on it
};

/// Binds the framebuffer with a viewport of its size, the program, and sets every state.
void begin_draw(const Context& gl, const Framebuffer& target, math::Extent size,
                const Program& program, const Pipeline& pipeline);
/// Sets the states alone, between two draws of one target and program.
void set_pipeline(const Context& gl, const Pipeline& pipeline);
/// One triangle over the whole target, made in the vertex shader from gl_VertexID at the far plane.
void draw_full_screen(const Context& gl, const VertexArray& empty);
[[nodiscard]] VertexArray make_vertex_array(const Context& gl);

/// Texture and sampler at a unit.
void bind_texture(const Context& gl, GLuint unit, GLenum target, const Texture& texture,
                  const Sampler* sampler);

}  // namespace facet::gl
