// The G-buffer: its targets, and the pass that fills it.
// SPDX-License-Identifier: MIT
#include "frame/gbuffer/gbuffer.h"

#include "frame/shared.h"
#include "frame/texture_units.h"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace facet::frame {

namespace {

/// Calls of(slot, texture unit) for what a material looks up: the units before shading's, and
/// after.
template <class Of>
void for_each_texture(const MaterialKey& key, const Of& of) {
    GLuint unit = 0;
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot) {
        if (!key.has(static_cast<tables::TextureSlot>(slot))) continue;
        of(slot, unit);
        unit = unit + 1 == first_shade_unit ? end_of_shade_units : unit + 1;
    }
}

}  // namespace

base::Result<GBuffer> GBuffer::create(const gl::Context& gl, const GBufferSpec& spec) {
    GBuffer out;
    out.spec = spec;
    struct Target {
        gl::Texture* texture;
        GLenum format;
        bool full;
    };
    for (const Target& target :
         {Target{&out.albedo, GL_RGBA16, true}, Target{&out.normal, GL_RG16, true},
          Target{&out.metal_rough_ao, GL_RGBA8, true},
          Target{&out.emissive_nit, GL_RGBA32F, spec.emissive},
          Target{&out.specular, GL_RGBA16, spec.specular}, Target{&out.ids, GL_RG32UI, spec.ids},
          Target{&out.triangles, GL_RG32UI, spec.triangles},
          Target{&out.depth, GL_DEPTH_COMPONENT32F, true}}) {
        auto made = gl::make_texture(
            gl, {.format = target.format, .size = target.full ? spec.size : math::Extent{1, 1}});
        if (!made) return tl::unexpected(made.error());
        *target.texture = std::move(*made);
    }
    std::vector<const gl::Texture*> colors = {&out.albedo, &out.normal, &out.metal_rough_ao};
    if (spec.emissive) colors.push_back(&out.emissive_nit);
    if (spec.specular) colors.push_back(&out.specular);
    if (spec.ids) colors.push_back(&out.ids);
    if (spec.triangles) colors.push_back(&out.triangles);
    auto framebuffer = gl::make_framebuffer(gl, colors, &out.depth);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    out.framebuffer = std::move(*framebuffer);
    return out;
}

void clear(const gl::Context& gl, const GBuffer& gbuffer) {
    const gl::Api& api = gl.api();
    api.BindFramebuffer(GL_FRAMEBUFFER, gbuffer.framebuffer.name());
    constexpr std::array<GLfloat, 4> black{};
    constexpr std::array<GLuint, 4> nobody{};
    for (GLint i = 0; i < gbuffer.spec.ids_place(); ++i)
        api.ClearBufferfv(GL_COLOR, i, black.data());
    if (gbuffer.spec.ids) api.ClearBufferuiv(GL_COLOR, gbuffer.spec.ids_place(), nobody.data());
    if (gbuffer.spec.triangles)
        api.ClearBufferuiv(GL_COLOR, gbuffer.spec.triangles_place(), nobody.data());
}

base::Result<gl::Program> GBufferPass::make(const gl::Context& gl, const Key& key) const {
    const GBufferSpec spec{.emissive = key.emissive, .specular = key.specular, .ids = key.ids};
    const std::string text =
        defines(key.material) + define("FORWARD", false) + define("EMISSIVE_TARGET", key.emissive) +
        define("SPECULAR_TARGET", key.specular) +
        fmt::format("#define FACET_SPECULAR_LOCATION {}\n", spec.specular_place()) +
        define("ID_TARGET", key.ids) + define("TRIANGLE_TARGET", key.triangles) +
        fmt::format("#define FACET_ID_LOCATION {}\n", spec.ids_place()) +
        fmt::format("#define FACET_TRIANGLE_LOCATION {}\n", spec.triangles_place());
    auto program = gl::build_program(
        gl, *sources_, {"frame/gbuffer/gbuffer.vert", "frame/gbuffer/gbuffer.frag", text});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_block(gl, *program, "DrawBlock", draw_binding);
    bind_material_samplers(gl, *program, key.material);
    return program;
}

base::Status GBufferPass::run(const gl::Context& gl, const GpuScene& scene,
                              const std::vector<std::size_t>& order, const GBuffer& out) {
    const gl::Api& api = gl.api();
    const gl::Program* current = nullptr;
    api.BindFramebuffer(GL_FRAMEBUFFER, out.framebuffer.name());
    api.DepthMask(GL_TRUE);
    constexpr float far_depth = 1.0F;
    api.ClearBufferfv(GL_DEPTH, 0, &far_depth);
    // Colours need no clear, but for clear()'s reason: no pass reads them where the depth is far.
    api.BindVertexArray(scene.vertex_array.name());
    for (const std::size_t index : order) {
        const Draw& draw = scene.draws[index];
        if (draw.blended) continue;
        const Key key{draw.key, out.spec.emissive, out.spec.specular, out.spec.ids,
                      out.spec.triangles};
        const auto program = programs_.get(key, [&](const Key& k) { return make(gl, k); });
        if (!program) return tl::unexpected(program.error());
        const gl::Pipeline pipeline{.depth_func = GL_LESS,
                                    .depth_write = true,
                                    .cull = draw.double_sided ? gl::Cull::none : gl::Cull::back};
        if (*program != current)
            gl::begin_draw(gl, out.framebuffer, out.spec.size, **program, pipeline);
        else
            gl::set_pipeline(gl, pipeline);
        current = *program;
        draw_instance(gl, scene, draw);
    }
    return {};
}

void bind_material_samplers(const gl::Context& gl, const gl::Program& program,
                            const MaterialKey& key) {
    for_each_texture(key, [&](std::size_t slot, GLuint unit) {
        gl::bind_sampler(gl, program, tables::material_textures[slot].key.data(),
                         static_cast<GLint>(unit));
    });
}

void draw_instance(const gl::Context& gl, const GpuScene& scene, const Draw& draw) {
    const gl::Api& api = gl.api();
    for_each_texture(draw.key, [&](std::size_t slot, GLuint unit) {
        if (draw.textures[slot].texture != nullptr)
            gl::bind_texture(gl, unit, GL_TEXTURE_2D, *draw.textures[slot].texture,
                             draw.textures[slot].sampler);
    });
    api.BindBufferRange(GL_UNIFORM_BUFFER, draw_binding, scene.draw_blocks.name(),
                        static_cast<GLintptr>(draw.block_offset), sizeof(shared::Draw));
    api.DrawElementsBaseVertex(
        GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)), draw.base_vertex);
}

}  // namespace facet::frame
