// Further outputs: each AOV's expression, evaluated over the G-buffer.
// SPDX-License-Identifier: MIT
#include "frame/aov/aov.h"

#include "frame/output/output.h"

#include <spdlog/fmt/fmt.h>

#include <limits>

namespace facet::frame {
namespace {

enum Unit : GLuint {
    albedo_unit = 0,
    normal_unit,
    metal_unit,
    depth_unit,
    emissive_unit,
    ids_unit,
    table_unit,
    specular_unit
};

void clear(const gl::Context& gl, const AovTarget& target) {
    const std::array<float, 4> zero{};
    gl.api().BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    gl.api().ClearBufferfv(GL_COLOR, 0, zero.data());
}

}  // namespace

base::Result<gl::Program> AovPass::make(const gl::Context& gl, const Key& key) const {
    const tables::AovRow& row = tables::row(key.aov);
    auto program =
        gl::build_program(gl, *sources_,
                          {"frame/full_screen.vert", "frame/aov/aov.frag",
                           fmt::format("#define FACET_AOV {}\n", row.glsl) +
                               define("KEY_LIGHT", row.kind == tables::AovKind::key_light) +
                               define("SPECULAR", key.specular)});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_sampler(gl, *program, "gbuffer_albedo", albedo_unit);
    gl::bind_sampler(gl, *program, "gbuffer_normal", normal_unit);
    gl::bind_sampler(gl, *program, "gbuffer_metal_rough_ao", metal_unit);
    gl::bind_sampler(gl, *program, "gbuffer_depth", depth_unit);
    gl::bind_sampler(gl, *program, "gbuffer_emissive", emissive_unit);
    gl::bind_sampler(gl, *program, "gbuffer_ids", ids_unit);
    gl::bind_sampler(gl, *program, "albedo_table", table_unit);
    gl::bind_sampler(gl, *program, "gbuffer_specular", specular_unit);
    return program;
}

base::Result<AovTarget> AovPass::make_target(const gl::Context& gl, tables::Aov aov,
                                             const GBuffer& gbuffer) {
    AovTarget target;
    target.aov = aov;
    auto sum = gl::make_texture(gl, {.format = GL_RGBA32F, .size = gbuffer.spec.size});
    if (!sum) return tl::unexpected(sum.error());
    target.sum = std::move(*sum);
    const std::array<const gl::Texture*, 1> colors = {&target.sum};
    auto framebuffer = gl::make_framebuffer(gl, colors, &gbuffer.depth);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    target.framebuffer = std::move(*framebuffer);
    clear(gl, target);
    return target;
}

void clear(const gl::Context& gl, tables::Average average, const std::vector<AovTarget>& targets) {
    for (const AovTarget& target : targets)
        if (tables::row(target.aov).average == average) clear(gl, target);
}

base::Status AovPass::run(const gl::Context& gl, const AovInputs& in, tables::Average average,
                          const std::vector<AovTarget>& targets) {
    const GBuffer& gbuffer = in.gbuffer;
    for (const AovTarget& target : targets) {
        const tables::AovRow& row = tables::row(target.aov);
        if (row.average != average || row.kind == tables::AovKind::light_path) continue;
        const auto program = programs_.get(Key{target.aov, gbuffer.spec.specular},
                                           [&](const Key& key) { return make(gl, key); });
        if (!program) return tl::unexpected(program.error());
        gl::begin_draw(gl, target.framebuffer, gbuffer.spec.size, **program,
                       {.depth_func = GL_GREATER, .blend = gl::Blend::add});
        gl::bind_texture(gl, albedo_unit, GL_TEXTURE_2D, gbuffer.albedo, nullptr);
        gl::bind_texture(gl, normal_unit, GL_TEXTURE_2D, gbuffer.normal, nullptr);
        gl::bind_texture(gl, metal_unit, GL_TEXTURE_2D, gbuffer.metal_rough_ao, nullptr);
        gl::bind_texture(gl, depth_unit, GL_TEXTURE_2D, gbuffer.depth, nullptr);
        gl::bind_texture(gl, emissive_unit, GL_TEXTURE_2D, gbuffer.emissive_nit, nullptr);
        gl::bind_texture(gl, ids_unit, GL_TEXTURE_2D, gbuffer.ids, nullptr);
        gl::bind_texture(gl, table_unit, GL_TEXTURE_2D, in.environment.albedo_table,
                         &in.environment.table_sampler);
        gl::bind_texture(gl, specular_unit, GL_TEXTURE_2D, gbuffer.specular, nullptr);
        gl::draw_full_screen(gl, in.empty);
    }
    return {};
}

image::Image read_aov(const gl::Context& gl, const AovTarget& target, math::Extent size,
                      std::uint32_t frame_count) {
    const tables::AovRow& row = tables::row(target.aov);
    const image::Image sums = read_radiance(gl, target.framebuffer, size);
    const auto channels = static_cast<std::uint32_t>(row.channels.size());
    const float share =
        row.average == tables::Average::nearest ? 1.0F : 1.0F / static_cast<float>(frame_count);
    image::Image out(size, channels, image::Sample::f32);
    const auto from = sums.as<float>();
    const auto to = out.as<float>();
    for (std::size_t i = 0; i < to.size() / channels; ++i) {
        const bool is_background = from[i * 4 + 3] == 0.0F;
        for (std::size_t c = 0; c < channels; ++c)
            to[i * channels + c] = is_background && target.aov == tables::Aov::depth
                                       ? std::numeric_limits<float>::infinity()
                                       : from[i * 4 + c] * share;
    }
    return out;
}

}  // namespace facet::frame
