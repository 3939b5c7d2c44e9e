// Typed owners of GL objects.
// SPDX-License-Identifier: MIT
#pragma once

#include "gl/api.h"

#include <utility>

namespace facet::gl {

/// Sole owner of one GL object. Kind says how to delete it, so a Buffer cannot pass for a Texture.
/// Empty after a move. Must die before the Context whose entry points it keeps.
template <class Kind>
class Handle {
public:
    Handle() = default;
    Handle(const Api& api, GLuint name) noexcept : api_(&api), name_(name) {}
    Handle(Handle&& other) noexcept : api_(other.api_), name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(api_, other.api_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) Kind::destroy(*api_, name_);
    }
    [[nodiscard]] GLuint name() const noexcept { return name_; }
    [[nodiscard]] explicit operator bool() const noexcept { return name_ != 0; }

private:
    const Api* api_ = nullptr;
    GLuint name_ = 0;
};

struct BufferKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteBuffers(1, &name); }
};
struct FramebufferKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteFramebuffers(1, &name); }
};
struct ProgramKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteProgram(name); }
};
struct SamplerKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteSamplers(1, &name); }
};
struct ShaderKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteShader(name); }
};
struct TextureKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteTextures(1, &name); }
};
struct VertexArrayKind {
    static void destroy(const Api& api, GLuint name) noexcept { api.DeleteVertexArrays(1, &name); }
};
using Buffer = Handle<BufferKind>;
using Framebuffer = Handle<FramebufferKind>;
using Program = Handle<ProgramKind>;
using Sampler = Handle<SamplerKind>;
using Shader = Handle<ShaderKind>;
using Texture = Handle<TextureKind>;
using VertexArray = Handle<VertexArrayKind>;

}  // namespace facet::gl
