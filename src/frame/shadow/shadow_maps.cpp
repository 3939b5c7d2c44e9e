// Shadow maps.
// SPDX-License-Identifier: MIT
#include "frame/shadow/shadow_maps.h"

#include "frame/shared.h"

#include <array>

namespace facet::frame {
namespace {

using math::Vec4;

/// As shadow.glsl reads them.
std::vector<Vec4> texels_of(const ShadowPlan& plan) {
    constexpr std::size_t view_texels = 6;
    std::vector<Vec4> out;
    for (const ShadowCaster& c : plan.casters)
        out.emplace_back(static_cast<float>(plan.casters.size() + c.first * view_texels),
                         static_cast<float>(c.count), c.radius_m, static_cast<float>(c.kind));
    const float share = 1.0F / static_cast<float>(plan.across);
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const ShadowView& view = plan.views[i];
        for (int column = 0; column < 4; ++column) out.push_back(view.clip_from_world[column]);
        out.emplace_back(static_cast<float>(i % plan.across) * share,
                         static_cast<float>(i / plan.across) * share, share,
                         1.0F / (share * static_cast<float>(shadow_atlas_px)));
        out.emplace_back(view.near_m, view.far_m, view.width_per_m, 0.0F);
    }
    return out;
}

}  // namespace

base::Status ShadowPass::make_targets(const gl::Context& gl) {
    if (framebuffer_) return {};
    auto atlas = gl::make_texture(
        gl, {.format = GL_DEPTH_COMPONENT32F, .size = {shadow_atlas_px, shadow_atlas_px}});
    if (!atlas) return tl::unexpected(atlas.error());
    textures_.atlas = std::move(*atlas);
    auto framebuffer = gl::make_framebuffer(gl, {}, &textures_.atlas);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    framebuffer_ = std::move(*framebuffer);
    const std::array<std::byte, sizeof(Vec4)> nothing{};
    textures_.views = gl::make_buffer(gl, nothing);
    textures_.views_texture = gl::make_buffer_texture(gl, textures_.views, GL_RGBA32F);
    view_block_ = gl::make_buffer(gl, {}, GL_STREAM_DRAW);
    return {};
}

base::Status ShadowPass::draw(const gl::Context& gl, const GpuScene& scene, const ShadowView& view,
                              std::size_t light) {
    shared::View block{};
    block.clip_from_world = view.clip_from_world;
    gl::update_buffer(gl, view_block_, std::as_bytes(std::span(&block, 1)));
    gl.api().BindBufferBase(GL_UNIFORM_BUFFER, view_binding, view_block_.name());
    const gl::Program* current = nullptr;
    for (const Draw& draw : scene.draws) {
        if (draw.blended || draw.light == light) continue;
        // Only a mask's holes need the material.
        const MaterialKey key = draw.key.alpha_mask ? draw.key : MaterialKey{};
        const auto program =
            programs_.get(key, [&](const MaterialKey& k) -> base::Result<gl::Program> {
                auto made =
                    gl::build_program(gl, *sources_,
                                      {"frame/gbuffer/gbuffer.vert", "frame/shadow/shadow.frag",
                                       defines(k) + define("FORWARD", false)});
                if (!made) return made;
                gl::bind_block(gl, *made, "ViewBlock", view_binding);
                gl::bind_block(gl, *made, "DrawBlock", draw_binding);
                bind_material_samplers(gl, *made, k);
                return made;
            });
        if (!program) return tl::unexpected(program.error());
        const gl::Pipeline pipeline{.depth_func = GL_LESS, .depth_write = true};
        if (*program != current) {
            gl.api().UseProgram((*program)->name());
            gl::set_pipeline(gl, pipeline);
        }
        current = *program;
        draw_instance(gl, scene, draw);
    }
    return {};
}

base::Status ShadowPass::run(const gl::Context& gl, const GpuScene& scene, const ShadowPlan& plan,
                             std::span<const std::size_t> light_order) {
    if (auto made = make_targets(gl); !made) return made;
    const gl::Api& api = gl.api();
    const std::vector<Vec4> texels = texels_of(plan);
    if (!texels.empty()) gl::update_buffer(gl, textures_.views, std::as_bytes(std::span(texels)));
    api.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    api.Disable(GL_SCISSOR_TEST);
    api.DepthMask(GL_TRUE);
    constexpr float far_depth = 1.0F;
    api.ClearBufferfv(GL_DEPTH, 0, &far_depth);
    api.BindVertexArray(scene.vertex_array.name());
    const auto map_px = static_cast<GLsizei>(shadow_atlas_px / plan.across);
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const auto tile = static_cast<GLint>(i);
        const auto across = static_cast<GLint>(plan.across);
        api.Viewport(tile % across * map_px, tile / across * map_px, map_px, map_px);
        const ShadowView& view = plan.views[i];
        if (auto drawn = draw(gl, scene, view, light_order[view.light]); !drawn) return drawn;
    }
    return {};
}

}  // namespace facet::frame
