// What the studio is drawn on.
// SPDX-License-Identifier: MIT
#include "studio/screen.h"

#include "frame/output/output.h"

#include <array>
#include <chrono>
#include <thread>

namespace facet::studio {

base::Result<Screen> Screen::open_window(math::Extent points, base::Log& log) {
    Screen screen;
    auto window = Window::open(points, "Facet Studio");
    if (!window) return tl::unexpected(window.error());
    screen.window_ = std::move(*window);
    auto gl = gl::Context::adopt(screen.window_->loader(), log);
    if (!gl) return tl::unexpected(gl.error());
    screen.gl_ = std::move(*gl);
    return screen;
}

base::Result<Screen> Screen::open_offscreen(math::Extent size_px, gl::Backend backend,
                                            base::Log& log) {
    Screen screen;
    auto gl = gl::Context::create(backend, log);
    if (!gl) return tl::unexpected(gl.error());
    screen.gl_ = std::move(*gl);
    screen.size_px_ = size_px;
    return screen;
}

void Screen::poll(Input& input, double wait_s) {
    if (window_) return window_->poll(input, wait_s);
    if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    input.next_frame();
    input.window_px = size_px_;
}

base::Result<GLuint> Screen::begin(math::Extent size_px, float gray) {
    const gl::Context& gl = *gl_;
    if (!window_ && (!color_ || size_px_ != size_px)) {
        auto color = gl::make_texture(gl, {.format = GL_RGBA8, .size = size_px});
        if (!color) return tl::unexpected(color.error());
        const std::array<const gl::Texture*, 1> colors = {&*color};
        auto framebuffer = gl::make_framebuffer(gl, colors, nullptr);
        if (!framebuffer) return tl::unexpected(framebuffer.error());
        color_ = std::move(*color);
        framebuffer_ = std::move(*framebuffer);
    }
    size_px_ = size_px;
    const GLuint target = window_ ? 0 : framebuffer_.name();
    const std::array<float, 4> clear = {gray, gray, gray, 1.0F};
    gl.api().BindFramebuffer(GL_FRAMEBUFFER, target);
    gl.api().ClearBufferfv(GL_COLOR, 0, clear.data());
    return target;
}

void Screen::show() {
    if (window_) window_->swap();
}

image::Image Screen::read() const {
    image::Image out(size_px_, 4, image::Sample::u8);
    if (window_) {
        gl_->api().BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl_->api().ReadBuffer(GL_BACK);
        gl_->api().PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl_->api().ReadPixels(0, 0, static_cast<GLsizei>(size_px_.width),
                              static_cast<GLsizei>(size_px_.height), GL_RGBA, GL_UNSIGNED_BYTE,
                              out.bytes.data());
    } else {
        gl::read_pixels(*gl_, framebuffer_, 0, size_px_, {GL_RGBA, GL_UNSIGNED_BYTE}, out.bytes);
    }
    frame::flip_rows(out);
    return out;
}

}  // namespace facet::studio
