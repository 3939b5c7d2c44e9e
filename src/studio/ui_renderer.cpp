// Draws the user interface's triangles.
// SPDX-License-Identifier: MIT
#include "studio/ui_renderer.h"

#include <imgui.h>

#include <array>
#include <cstddef>

namespace facet::studio {
namespace {

void describe_vertices(const gl::Api& api) {
    struct Attribute {
        GLint size;
        GLenum type;
        GLboolean normalized;
        std::size_t offset;
    };
    const std::array attributes = {
        Attribute{2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos)},
        Attribute{2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv)},
        Attribute{4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col)},
    };
    for (GLuint i = 0; i < attributes.size(); ++i) {
        const Attribute& a = attributes[i];
        api.EnableVertexAttribArray(i);
        api.VertexAttribPointer(i, a.size, a.type, a.normalized, sizeof(ImDrawVert),
                                reinterpret_cast<const void*>(a.offset));
    }
}

base::Result<gl::Texture> make_filled(const gl::Context& gl, math::Extent size, GLenum format,
                                      GLenum pixels, std::span<const std::byte> bytes) {
    const gl::TextureSpec spec{.format = format, .size = size};
    auto texture = gl::make_texture(gl, spec);
    if (texture) gl::upload(gl, *texture, spec, 0, 0, {pixels, GL_UNSIGNED_BYTE}, bytes);
    return texture;
}

}  // namespace

base::Result<UiRenderer> UiRenderer::create(const gl::Context& gl,
                                            const gl::ShaderSources& sources) {
    UiRenderer out;
    auto program = gl::build_program(gl, sources, {"studio/ui.vert", "studio/ui.frag", ""});
    if (!program) return tl::unexpected(program.error());
    out.program_ = std::move(*program);
    gl::bind_sampler(gl, out.program_, "picture", 0);
    out.transform_ = gl.api().GetUniformLocation(out.program_.name(), "clip_from_px");
    out.vertices_ = gl::make_buffer(gl, {}, GL_STREAM_DRAW);
    out.indices_ = gl::make_buffer(gl, {}, GL_STREAM_DRAW);
    out.vertex_array_ = gl::make_vertex_array(gl);
    gl.api().BindVertexArray(out.vertex_array_.name());
    gl.api().BindBuffer(GL_ARRAY_BUFFER, out.vertices_.name());
    gl.api().BindBuffer(GL_ELEMENT_ARRAY_BUFFER, out.indices_.name());
    describe_vertices(gl.api());
    out.sampler_ = gl::make_sampler(gl, {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE});
    if (auto s = gl.check("user interface"); !s) return tl::unexpected(s.error());
    return out;
}

base::Status UiRenderer::upload_font(const gl::Context& gl, ImFontAtlas& atlas) {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    const math::Extent size{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    auto texture = make_filled(
        gl, size, GL_RGBA8, GL_RGBA,
        {reinterpret_cast<const std::byte*>(pixels), static_cast<std::size_t>(size.pixels()) * 4});
    if (!texture) return tl::unexpected(texture.error());
    owned_.insert_or_assign(Slot::font, Owned{std::move(*texture), size});
    atlas.SetTexID(reinterpret_cast<ImTextureID>(Slot::font));
    return {};
}

base::Status UiRenderer::upload(const gl::Context& gl, Slot slot, const image::Image& image) {
    const bool has_alpha = image.channels == 4;
    const GLenum pixels = has_alpha ? GL_RGBA : GL_RGB;
    const auto found = owned_.find(slot);
    if (found != owned_.end() && found->second.size == image.size) {
        gl::upload(gl, found->second.texture, {.format = GL_RGBA8, .size = image.size}, 0, 0,
                   {pixels, GL_UNSIGNED_BYTE}, image.bytes);
        return {};
    }
    auto texture = make_filled(gl, image.size, GL_RGBA8, pixels, image.bytes);
    if (!texture) return tl::unexpected(texture.error());
    owned_.insert_or_assign(slot, Owned{std::move(*texture), image.size});
    return {};
}

void UiRenderer::hide(Slot slot) {
    owned_.erase(slot);
    shown_.erase(slot);
}

GLuint UiRenderer::texture_of(std::uintptr_t number) const {
    const auto slot = static_cast<Slot>(number);
    if (const auto shown = shown_.find(slot); shown != shown_.end()) return shown->second;
    const auto owned = owned_.find(slot);
    return owned == owned_.end() ? 0 : owned->second.texture.name();
}

void UiRenderer::draw(const gl::Context& gl, const ImDrawData& data, GLuint target,
                      math::Extent size) const {
    const gl::Api& api = gl.api();
    const ImVec2 corner = data.DisplayPos;
    const ImVec2 scale = data.FramebufferScale;
    api.BindFramebuffer(GL_FRAMEBUFFER, target);
    api.Viewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
    api.UseProgram(program_.name());
    gl::set_pipeline(gl, {.blend = gl::Blend::over_straight, .scissor = true});
    const float sx = 2.0F / data.DisplaySize.x;
    const float sy = -2.0F / data.DisplaySize.y;
    api.Uniform4f(transform_, sx, sy, -1.0F - corner.x * sx, 1.0F - corner.y * sy);
    api.BindVertexArray(vertex_array_.name());
    api.ActiveTexture(GL_TEXTURE0);
    api.BindSampler(0, sampler_.name());
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        gl::update_buffer(gl, vertices_,
                          std::as_bytes(std::span(list.VtxBuffer.Data,
                                                  static_cast<std::size_t>(list.VtxBuffer.Size))));
        gl::update_buffer(gl, indices_,
                          std::as_bytes(std::span(list.IdxBuffer.Data,
                                                  static_cast<std::size_t>(list.IdxBuffer.Size))));
        api.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const float left = (command.ClipRect.x - corner.x) * scale.x;
            const float top = (command.ClipRect.y - corner.y) * scale.y;
            const float right = (command.ClipRect.z - corner.x) * scale.x;
            const float bottom = (command.ClipRect.w - corner.y) * scale.y;
            if (right <= left || bottom <= top) continue;
            api.Scissor(static_cast<GLint>(left),
                        static_cast<GLint>(static_cast<float>(size.height) - bottom),
                        static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
            api.BindTexture(GL_TEXTURE_2D,
                            texture_of(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
            static_assert(sizeof(ImDrawIdx) == 2);
            api.DrawElementsBaseVertex(
                GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                reinterpret_cast<const void*>(std::size_t{command.IdxOffset} * sizeof(ImDrawIdx)),
                static_cast<GLint>(command.VtxOffset));
        }
    }
    gl::set_pipeline(gl, {});
}

}  // namespace facet::studio
