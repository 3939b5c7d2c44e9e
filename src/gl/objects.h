// Making textures, buffers and framebuffers, and moving pixels; bound state is left undefined.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "gl/context.h"
#include "gl/handle.h"
#include "math/vector.h"

#include <cstddef>
#include <span>

namespace facet::gl {

/// Immutable storage of a 2D texture or, with `cube`, of six faces.
struct TextureSpec {
    GLenum format = GL_RGBA8;  ///< sized internal format
    math::Extent size;
    GLsizei levels = 1;
    bool cube = false;
};
/// Errors: limit_reached when a side is above what the driver has.
[[nodiscard]] base::Result<Texture> make_texture(const Context& gl, const TextureSpec& spec);

/// What client memory holds.
struct PixelFormat {
    GLenum format = GL_RGBA;
    GLenum type = GL_UNSIGNED_BYTE;
};
/// Fills one level of a 2D texture, or one face of a cube (`face` 0..5). Rows are tightly packed.
void upload(const Context& gl, const Texture& texture, const TextureSpec& spec, GLint level,
            int face, const PixelFormat& pixels, std::span<const std::byte> bytes);

/// A buffer and, for texture buffers, the texture that shows it.
[[nodiscard]] Buffer make_buffer(const Context& gl, std::span<const std::byte> bytes,
                                 GLenum usage = GL_STATIC_DRAW);
void update_buffer(const Context& gl, const Buffer& buffer, std::span<const std::byte> bytes);
/// The first bytes of a buffer, as many as `out` has.
void read_buffer(const Context& gl, const Buffer& buffer, std::span<std::byte> out);
[[nodiscard]] Texture make_buffer_texture(const Context& gl, const Buffer& buffer, GLenum format);

/// Attachments outlive the framebuffer. `depth` may be null. Errors: internal when it is not
/// complete.
[[nodiscard]] base::Result<Framebuffer> make_framebuffer(const Context& gl,
                                                         std::span<const Texture* const> colors,
                                                         const Texture* depth);

/// Reads attachment `index` (or depth with GL_DEPTH_COMPONENT) into `out`, rows from the bottom,
/// packed.
void read_pixels(const Context& gl, const Framebuffer& framebuffer, int index, math::Extent size,
                 const PixelFormat& pixels, std::span<std::byte> out);

/// How a texture is looked up.
struct SamplerSpec {
    GLint min_filter = GL_LINEAR_MIPMAP_LINEAR;
    GLint mag_filter = GL_LINEAR;
    GLint wrap_s = GL_REPEAT;
    GLint wrap_t = GL_REPEAT;
    float level_bias = 0.0F;  ///< below 0: finer mips
    auto operator<=>(const SamplerSpec&) const = default;
};
[[nodiscard]] Sampler make_sampler(const Context& gl, const SamplerSpec& spec);

}  // namespace facet::gl
