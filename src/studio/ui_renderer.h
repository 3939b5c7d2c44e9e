// Draws the user interface's triangles with the project's own GL: Dear ImGui's stock renderer loads
// its entry points itself, which fails under OSMesa. SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"
#include "gl/pipeline.h"
#include "gl/shader.h"
#include "image/image.h"

#include <cstdint>
#include <map>

struct ImDrawData;
struct ImFontAtlas;

namespace facet::studio {

/// Pictures that the user interface shows, by a number of their own: textures come and go between
/// the time a panel is laid out and the time it is drawn.
enum class Slot : std::uintptr_t {
    font = 1,
    viewport,
    original,
    reference,
    difference,
    overlay,
    texture,
    first_thumbnail = 1000  ///< and up, one a preset
};

class UiRenderer {
public:
    /// `sources` outlives the renderer. Errors: internal (shaders).
    [[nodiscard]] static base::Result<UiRenderer> create(const gl::Context& gl,
                                                         const gl::ShaderSources& sources);
    /// Makes the glyphs' texture anew. Errors: limit_reached.
    [[nodiscard]] base::Status upload_font(const gl::Context& gl, ImFontAtlas& atlas);
    /// u8 RGB or RGBA, rows from the top. Errors: limit_reached.
    [[nodiscard]] base::Status upload(const gl::Context& gl, Slot slot, const image::Image& image);
    /// Shows a texture that belongs to somebody else, rows from the bottom.
    void show(Slot slot, const gl::Texture& texture) { shown_[slot] = texture.name(); }
    void hide(Slot slot);
    [[nodiscard]] bool has(Slot slot) const {
        return shown_.contains(slot) || owned_.contains(slot);
    }
    /// Draws into `target`, of `size` pixels; 0 is a window's own.
    void draw(const gl::Context& gl, const ImDrawData& data, GLuint target,
              math::Extent size) const;

private:
    struct Owned {
        gl::Texture texture;
        math::Extent size;
    };
    [[nodiscard]] GLuint texture_of(std::uintptr_t slot) const;

    gl::Program program_;
    GLint transform_ = -1;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::VertexArray vertex_array_;
    gl::Sampler sampler_;
    std::map<Slot, Owned> owned_;
    std::map<Slot, GLuint> shown_;
};

}  // namespace facet::studio
