// Making textures, buffers and framebuffers. Binds to edit: the one form that GL 4.3 and 4.5 share.
// SPDX-License-Identifier: MIT
#include "gl/objects.h"

#include <spdlog/fmt/fmt.h>

#include <vector>

namespace facet::gl {

base::Result<Texture> make_texture(const Context& gl, const TextureSpec& spec) {
    const Api& api = gl.api();
    GLint side = 0;
    api.GetIntegerv(spec.cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &side);
    if (spec.size.width > static_cast<GLuint>(side) || spec.size.height > static_cast<GLuint>(side))
        return base::fail(
            {.code = base::ErrorCode::limit_reached,
             .what = "larger than the driver's textures may be",
             .found = fmt::format("{}x{}, limit {}", spec.size.width, spec.size.height, side)});
    GLuint name = 0;
    api.GenTextures(1, &name);
    Texture texture(api, name);
    const GLenum target = spec.cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    api.BindTexture(target, name);
    api.TexStorage2D(target, spec.levels, spec.format, static_cast<GLsizei>(spec.size.width),
                     static_cast<GLsizei>(spec.size.height));
    // GL's own default is linear, with which an integer texture reads as 0.
    api.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    api.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void upload(const Context& gl, const Texture& texture, const TextureSpec& spec, GLint level,
            int face, const PixelFormat& pixels, std::span<const std::byte> bytes) {
    const Api& api = gl.api();
    const auto side = [&](GLuint size) {
        return static_cast<GLsizei>(std::max(1U, size >> static_cast<unsigned>(level)));
    };
    api.BindTexture(spec.cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, texture.name());
    api.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const GLenum target =
        spec.cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
    api.TexSubImage2D(target, level, 0, 0, side(spec.size.width), side(spec.size.height),
                      pixels.format, pixels.type, bytes.data());
}

Buffer make_buffer(const Context& gl, std::span<const std::byte> bytes, GLenum usage) {
    const Api& api = gl.api();
    GLuint name = 0;
    api.GenBuffers(1, &name);
    api.BindBuffer(GL_COPY_WRITE_BUFFER, name);
    api.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                   usage);
    return Buffer(api, name);
}

void update_buffer(const Context& gl, const Buffer& buffer, std::span<const std::byte> bytes) {
    gl.api().BindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
    gl.api().BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                        GL_STREAM_DRAW);
}

void read_buffer(const Context& gl, const Buffer& buffer, std::span<std::byte> out) {
    gl.api().BindBuffer(GL_COPY_READ_BUFFER, buffer.name());
    gl.api().GetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(out.size()),
                              out.data());
}

Texture make_buffer_texture(const Context& gl, const Buffer& buffer, GLenum format) {
    const Api& api = gl.api();
    GLuint name = 0;
    api.GenTextures(1, &name);
    api.BindTexture(GL_TEXTURE_BUFFER, name);
    api.TexBuffer(GL_TEXTURE_BUFFER, format, buffer.name());
    return Texture(api, name);
}

base::Result<Framebuffer> make_framebuffer(const Context& gl,
                                           std::span<const Texture* const> colors,
                                           const Texture* depth) {
    const Api& api = gl.api();
    GLuint name = 0;
    api.GenFramebuffers(1, &name);
    Framebuffer framebuffer(api, name);
    api.BindFramebuffer(GL_FRAMEBUFFER, name);
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        const auto attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
        api.FramebufferTexture(GL_FRAMEBUFFER, attachment, color->name(), 0);
        buffers.push_back(attachment);
    }
    api.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (depth != nullptr)
        api.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth->name(), 0);
    const GLenum status = api.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "the driver refuses a framebuffer",
                           .found = fmt::format("0x{:x}", status)});
    return framebuffer;
}

void read_pixels(const Context& gl, const Framebuffer& framebuffer, int index, math::Extent size,
                 const PixelFormat& pixels, std::span<std::byte> out) {
    const Api& api = gl.api();
    api.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    if (pixels.format != GL_DEPTH_COMPONENT)
        api.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
    api.PixelStorei(GL_PACK_ALIGNMENT, 1);
    api.ReadPixels(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height),
                   pixels.format, pixels.type, out.data());
}

Sampler make_sampler(const Context& gl, const SamplerSpec& spec) {
    const Api& api = gl.api();
    GLuint name = 0;
    api.GenSamplers(1, &name);
    api.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, spec.min_filter);
    api.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, spec.mag_filter);
    api.SamplerParameteri(name, GL_TEXTURE_WRAP_S, spec.wrap_s);
    api.SamplerParameteri(name, GL_TEXTURE_WRAP_T, spec.wrap_t);
    api.SamplerParameterf(name, GL_TEXTURE_LOD_BIAS, spec.level_bias);
    return Sampler(api, name);
}

}  // namespace facet::gl
