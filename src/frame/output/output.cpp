// The end of a frame: summing jittered frames, display encoding, reading back.
// SPDX-License-Identifier: MIT
#include "frame/output/output.h"

#include "math/color.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

namespace facet::frame {
namespace {

/// As in glsl/frame/output/display.frag.
struct DisplayBlock {
    math::Vec4 scale;
    math::Vec4 background;
    math::Mat4 balance;
    math::Mat4 primaries;
    math::Vec4 screen;
};

math::Mat3 primaries_of(tables::Gamut gamut) {
    switch (gamut) {
        case tables::Gamut::p3:
            return math::p3_from_rec709();
        case tables::Gamut::rec2020_pq:
            return math::rec2020_from_rec709();
        default:
            return math::Mat3(1.0F);
    }
}

/// As DisplayBlock::screen.
math::Vec4 screen_of(const DisplaySettings& settings) {
    if (settings.gamut != tables::Gamut::rec2020_pq) return {1.0F, 0.0F, 0.0F, 0.0F};
    constexpr float white_nit = 203.0F;  // ITU-R BT.2408-7, Table 1
    constexpr float mastered_nit = 1000.0F;
    constexpr float most_nit = 10000.0F;
    // Without a tone curve all that the code can hold is shown.
    const float peak = settings.tonemap == tables::Tonemap::none ? most_nit : mastered_nit;
    return {peak / white_nit, white_nit, 0.0F, 0.0F};
}

base::Result<gl::Program> make_display(const gl::Context& gl, const gl::ShaderSources& sources,
                                       tables::Tonemap tonemap) {
    auto program =
        gl::build_program(gl, sources,
                          {"frame/full_screen.vert", "frame/output/display.frag",
                           fmt::format("#define FACET_TONEMAP {}\n", static_cast<int>(tonemap))});
    if (!program) return program;
    gl::bind_block(gl, *program, "DisplayBlock", display_binding);
    gl::bind_sampler(gl, *program, "radiance", 0);
    return program;
}

}  // namespace

base::Result<Accumulator> Accumulator::create(const gl::Context& gl, math::Extent size) {
    Accumulator out;
    out.size = size;
    auto sum = gl::make_texture(gl, {.format = GL_RGBA32F, .size = size});
    if (!sum) return tl::unexpected(sum.error());
    out.sum = std::move(*sum);
    const std::array<const gl::Texture*, 1> colors = {&out.sum};
    auto framebuffer = gl::make_framebuffer(gl, colors, nullptr);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    out.framebuffer = std::move(*framebuffer);
    return out;
}

void Accumulator::clear(const gl::Context& gl) const {
    const std::array<float, 4> zero{};
    gl.api().BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.api().ClearBufferfv(GL_COLOR, 0, zero.data());
}

base::Result<AccumulatePass> AccumulatePass::create(const gl::Context& gl,
                                                    const gl::ShaderSources& sources) {
    auto program = gl::build_program(
        gl, sources, {"frame/full_screen.vert", "frame/output/accumulate.frag", ""});
    if (!program) return tl::unexpected(program.error());
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_sampler(gl, *program, "radiance", 0);
    AccumulatePass pass;
    pass.program_ = std::move(*program);
    return pass;
}

void AccumulatePass::run(const gl::Context& gl, const gl::Texture& radiance,
                         const gl::VertexArray& empty, const gl::Framebuffer& sum,
                         math::Extent size) const {
    gl::begin_draw(gl, sum, size, program_, {.blend = gl::Blend::add});
    gl::bind_texture(gl, 0, GL_TEXTURE_2D, radiance, nullptr);
    gl::draw_full_screen(gl, empty);
}

base::Status DisplayPass::make_target(const gl::Context& gl, math::Extent size,
                                      image::Sample sample) {
    if (target_.color && target_.size == size && target_.sample == sample) return {};
    const GLenum format = sample == image::Sample::u16 ? GL_RGBA16 : GL_RGBA8;
    auto color = gl::make_texture(gl, {.format = format, .size = size});
    if (!color) return tl::unexpected(color.error());
    target_.color = std::move(*color);
    const std::array<const gl::Texture*, 1> colors = {&target_.color};
    auto framebuffer = gl::make_framebuffer(gl, colors, nullptr);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    target_.framebuffer = std::move(*framebuffer);
    target_.size = size;
    target_.sample = sample;
    return {};
}

base::Status DisplayPass::run(const gl::Context& gl, const gl::Texture& sum, math::Extent size,
                              const DisplaySettings& settings, const gl::VertexArray& empty) {
    const auto program = programs_.get(
        settings.tonemap, [&](tables::Tonemap t) { return make_display(gl, *sources_, t); });
    if (!program) return tl::unexpected(program.error());
    if (auto made = make_target(gl, size, settings.sample); !made)
        return tl::unexpected(made.error());
    const float share = 1.0F / static_cast<float>(settings.frame_count);
    const float codes = settings.sample == image::Sample::u16 ? 65535.0F : 255.0F;
    const DisplayBlock block{{static_cast<float>(settings.exposure) * share, share,
                              settings.dither ? 1.0F : 0.0F, 1.0F / codes},
                             math::Vec4(settings.background.value_or(math::Vec3(0.0F)),
                                        settings.background ? 1.0F : 0.0F),
                             math::Mat4(settings.balance),
                             math::Mat4(primaries_of(settings.gamut)),
                             screen_of(settings)};
    if (!block_) block_ = gl::make_buffer(gl, std::as_bytes(std::span(&block, 1)), GL_STREAM_DRAW);
    gl::update_buffer(gl, block_, std::as_bytes(std::span(&block, 1)));
    gl.api().BindBufferBase(GL_UNIFORM_BUFFER, display_binding, block_.name());
    gl::begin_draw(gl, target_.framebuffer, size, **program, {});
    gl::bind_texture(gl, 0, GL_TEXTURE_2D, sum, nullptr);
    gl::draw_full_screen(gl, empty);
    return {};
}

image::Image DisplayPass::read(const gl::Context& gl) const {
    image::Image out(target_.size, 4, target_.sample);
    const GLenum type = target_.sample == image::Sample::u16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
    gl::read_pixels(gl, target_.framebuffer, 0, target_.size, {GL_RGBA, type}, out.bytes);
    flip_rows(out);
    return out;
}

image::Image read_radiance(const gl::Context& gl, const gl::Framebuffer& framebuffer,
                           math::Extent size) {
    image::Image out(size, 4, image::Sample::f32);
    gl::read_pixels(gl, framebuffer, 0, size, {GL_RGBA, GL_FLOAT}, out.bytes);
    flip_rows(out);
    return out;
}

void flip_rows(image::Image& image) {
    const std::size_t row =
        std::size_t{image.size.width} * image.channels * sample_bytes(image.sample);
    std::byte* low = image.bytes.data();
    std::byte* high = low + image.bytes.size() - row;
    for (; low < high; low += row, high -= row) std::swap_ranges(low, low + row, high);
}

}  // namespace facet::frame
