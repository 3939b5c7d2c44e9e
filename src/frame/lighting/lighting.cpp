// The lighting pass: G-buffer, lights and environment to radiance.
// SPDX-License-Identifier: MIT
#include "frame/lighting/lighting.h"

#include "brdf/ltc.h"
#include "brdf/sheen.h"
#include "frame/texture_units.h"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace facet::frame {
namespace {

/// Of shade.glsl's samplers.
enum Unit : GLuint {
    cube_unit = first_shade_unit,
    irradiance_unit,
    table_unit,
    lights_unit,
    tiles_unit,
    indices_unit,
    visibility_unit,
    ltc_unit = visibility_unit,  // where rays are, lights with a size are theirs
    sky_unit,
    atlas_unit = sky_unit,  // maps are there where rays are not
    rest_unit,
    shadow_views_unit = rest_unit,
    specular_unit,
    guide_unit,
    occlusion_unit = guide_unit,
    profiles_unit,
    sample_diffuse_unit,
    sample_specular_unit,
    sheen_unit,
    far_unit
};
static_assert(far_unit < end_of_shade_units);
/// Units of the G-buffer.
enum GBufferUnit : GLuint {
    albedo_unit = 0,
    normal_unit,
    metal_unit,
    depth_unit,
    emissive_unit,
    reflection_unit
};
static_assert(GLuint{reflection_unit} < first_shade_unit);

base::Result<gl::Program> make(const gl::Context& gl, const gl::ShaderSources& sources,
                               const ShadeKey& shade, bool emissive, bool specular) {
    auto program = gl::build_program(
        gl, sources,
        {"frame/full_screen.vert", "frame/lighting/lighting.frag",
         defines(shade) + define("EMISSIVE_TARGET", emissive) + define("SPECULAR", specular)});
    if (!program) return program;
    gl::bind_block(gl, *program, "ViewBlock", view_binding);
    gl::bind_sampler(gl, *program, "gbuffer_albedo", albedo_unit);
    gl::bind_sampler(gl, *program, "gbuffer_normal", normal_unit);
    gl::bind_sampler(gl, *program, "gbuffer_metal_rough_ao", metal_unit);
    gl::bind_sampler(gl, *program, "gbuffer_depth", depth_unit);
    gl::bind_sampler(gl, *program, "gbuffer_emissive", emissive_unit);
    gl::bind_sampler(gl, *program, "gbuffer_specular", reflection_unit);
    set_shade_samplers(gl, *program);
    return program;
}

}  // namespace

std::string defines(const ShadeKey& key) {
    std::string text =
        define("ENVIRONMENT", key.environment) + define("LOCAL_LIGHTS", key.local_lights) +
        define("AREA_LIGHTS", key.area_lights) + define("LIGHT_PROFILES", key.light_profiles) +
        define("SHADOW_MAPS", key.shadow_maps) + define("OCCLUSION", key.occlusion) +
        define("VISIBILITY", key.visibility) + define("INDIRECT", key.indirect) +
        define("SAMPLE_LIGHT", key.sample_light) + define("LIGHT_PATHS", !key.paths.empty());
    std::string outputs;
    std::string writes;
    for (std::size_t i = 0; i < key.paths.size(); ++i) {
        outputs += fmt::format("layout(location = {0}) out vec4 out_path_{0}; ", i);
        writes += fmt::format("out_path_{} = vec4(({}) * (share), share); ", i,
                              tables::row(key.paths[i]).glsl);
    }
    text += fmt::format("#define FACET_PATH_OUTPUTS {}\n", outputs);
    return text + fmt::format("#define FACET_WRITE_PATHS(share) {}\n", writes);
}

base::Result<LightBuffers> make_light_buffers(const gl::Context& gl) {
    LightBuffers out;
    const std::array<std::byte, light_texels * sizeof(math::Vec4)> nothing{};
    out.lights = gl::make_buffer(gl, nothing);
    out.tiles = gl::make_buffer(gl, nothing);
    out.indices = gl::make_buffer(gl, nothing);
    out.profiles = gl::make_buffer(gl, nothing);
    out.lights_texture = gl::make_buffer_texture(gl, out.lights, GL_RGBA32F);
    out.tiles_texture = gl::make_buffer_texture(gl, out.tiles, GL_RG32UI);
    out.indices_texture = gl::make_buffer_texture(gl, out.indices, GL_R16UI);
    out.profiles_texture = gl::make_buffer_texture(gl, out.profiles, GL_R32F);
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = {brdf::ltc_size, brdf::ltc_size}};
    auto table = gl::make_texture(gl, spec);
    if (!table) return tl::unexpected(table.error());
    out.ltc_table = std::move(*table);
    gl::upload(gl, out.ltc_table, spec, 0, 0, {GL_RGBA, GL_FLOAT},
               std::as_bytes(std::span(brdf::ltc_ggx)));
    const gl::TextureSpec sheen{.format = GL_R32F, .size = {brdf::sheen_columns, brdf::sheen_rows}};
    table = gl::make_texture(gl, sheen);
    if (!table) return tl::unexpected(table.error());
    out.sheen_table = std::move(*table);
    gl::upload(gl, out.sheen_table, sheen, 0, 0, {GL_RED, GL_FLOAT},
               std::as_bytes(std::span(brdf::sheen_charlie)));
    out.table_sampler = gl::make_sampler(gl, {.min_filter = GL_LINEAR, .mag_filter = GL_LINEAR});
    return out;
}

void update_lights(const gl::Context& gl, const LightBuffers& buffers, const PackedLights& lights) {
    if (!lights.texels.empty())
        gl::update_buffer(gl, buffers.lights, std::as_bytes(std::span(lights.texels)));
    if (!lights.profiles.empty())
        gl::update_buffer(gl, buffers.profiles, std::as_bytes(std::span(lights.profiles)));
}

void update_lists(const gl::Context& gl, const LightBuffers& buffers, const LightLists& lists) {
    gl::update_buffer(gl, buffers.tiles, std::as_bytes(std::span(lists.tiles)));
    gl::update_buffer(gl, buffers.indices, std::as_bytes(std::span(lists.indices)));
}

void set_shade_samplers(const gl::Context& gl, const gl::Program& program) {
    gl::bind_sampler(gl, program, "radiance_cube", cube_unit);
    gl::bind_sampler(gl, program, "irradiance_cube", irradiance_unit);
    gl::bind_sampler(gl, program, "albedo_table", table_unit);
    gl::bind_sampler(gl, program, "lights", lights_unit);
    gl::bind_sampler(gl, program, "light_tiles", tiles_unit);
    gl::bind_sampler(gl, program, "light_indices", indices_unit);
    gl::bind_sampler(gl, program, "light_profiles", profiles_unit);
    gl::bind_sampler(gl, program, "light_visibility", visibility_unit);
    gl::bind_sampler(gl, program, "ltc_table", ltc_unit);
    gl::bind_sampler(gl, program, "shadow_atlas", atlas_unit);
    gl::bind_sampler(gl, program, "shadow_views", shadow_views_unit);
    gl::bind_sampler(gl, program, "ambient_occlusion", occlusion_unit);
    gl::bind_sampler(gl, program, "indirect_sky", sky_unit);
    gl::bind_sampler(gl, program, "indirect_rest", rest_unit);
    gl::bind_sampler(gl, program, "indirect_specular", specular_unit);
    gl::bind_sampler(gl, program, "indirect_guide", guide_unit);
    gl::bind_sampler(gl, program, "sample_diffuse", sample_diffuse_unit);
    gl::bind_sampler(gl, program, "sample_specular", sample_specular_unit);
    gl::bind_sampler(gl, program, "sheen_table", sheen_unit);
    gl::bind_sampler(gl, program, "sample_far", far_unit);
}

void bind_shade_textures(const gl::Context& gl, const ShadeInputs& in) {
    const EnvironmentMaps& e = in.environment;
    gl::bind_texture(gl, cube_unit, GL_TEXTURE_CUBE_MAP, e.radiance_cube, &e.cube_sampler);
    gl::bind_texture(gl, irradiance_unit, GL_TEXTURE_CUBE_MAP, e.irradiance_cube, &e.cube_sampler);
    gl::bind_texture(gl, table_unit, GL_TEXTURE_2D, e.albedo_table, &e.table_sampler);
    gl::bind_texture(gl, sheen_unit, GL_TEXTURE_2D, in.lights.sheen_table,
                     &in.lights.table_sampler);
    gl::bind_texture(gl, lights_unit, GL_TEXTURE_BUFFER, in.lights.lights_texture, nullptr);
    gl::bind_texture(gl, tiles_unit, GL_TEXTURE_BUFFER, in.lights.tiles_texture, nullptr);
    gl::bind_texture(gl, indices_unit, GL_TEXTURE_BUFFER, in.lights.indices_texture, nullptr);
    if (in.key.light_profiles)
        gl::bind_texture(gl, profiles_unit, GL_TEXTURE_BUFFER, in.lights.profiles_texture, nullptr);
    if (in.key.area_lights)
        gl::bind_texture(gl, ltc_unit, GL_TEXTURE_2D, in.lights.ltc_table,
                         &in.lights.table_sampler);
    if (in.key.visibility)
        gl::bind_texture(gl, visibility_unit, GL_TEXTURE_BUFFER, in.rays.visibility_texture,
                         nullptr);
    if (in.key.shadow_maps) {
        gl::bind_texture(gl, atlas_unit, GL_TEXTURE_2D, in.shadows.atlas, nullptr);
        gl::bind_texture(gl, shadow_views_unit, GL_TEXTURE_BUFFER, in.shadows.views_texture,
                         nullptr);
    }
    if (in.key.occlusion)
        gl::bind_texture(gl, occlusion_unit, GL_TEXTURE_2D, in.occlusion, nullptr);
    if (!in.key.indirect) return;
    gl::bind_texture(gl, sky_unit, GL_TEXTURE_2D, in.rays.sky, nullptr);
    gl::bind_texture(gl, rest_unit, GL_TEXTURE_2D, in.rays.rest, nullptr);
    gl::bind_texture(gl, specular_unit, GL_TEXTURE_2D, in.rays.specular, nullptr);
    gl::bind_texture(gl, guide_unit, GL_TEXTURE_2D, in.rays.guide, nullptr);
    if (!in.key.sample_light) return;
    gl::bind_texture(gl, sample_diffuse_unit, GL_TEXTURE_2D, in.rays.sample_diffuse, nullptr);
    gl::bind_texture(gl, sample_specular_unit, GL_TEXTURE_2D, in.rays.sample_specular, nullptr);
    if (in.rays.far_size == in.rays.sample_size)
        gl::bind_texture(gl, far_unit, GL_TEXTURE_2D, in.rays.sample_far, nullptr);
}

base::Result<RadianceTarget> RadianceTarget::create(const gl::Context& gl, math::Extent size,
                                                    const gl::Texture& depth,
                                                    std::size_t color_count) {
    RadianceTarget out;
    out.size = size;
    for (std::size_t i = 0; i < color_count; ++i) {
        auto color = gl::make_texture(gl, {.format = GL_RGBA32F, .size = size});
        if (!color) return tl::unexpected(color.error());
        out.colors.push_back(std::move(*color));
    }
    std::vector<const gl::Texture*> colors;
    for (const gl::Texture& color : out.colors) colors.push_back(&color);
    auto framebuffer = gl::make_framebuffer(gl, colors, &depth);
    if (!framebuffer) return tl::unexpected(framebuffer.error());
    out.framebuffer = std::move(*framebuffer);
    return out;
}

void RadianceTarget::clear(const gl::Context& gl) const {
    const std::array<float, 4> nothing{};
    gl.api().BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    for (std::size_t i = 0; i < colors.size(); ++i)
        gl.api().ClearBufferfv(GL_COLOR, static_cast<GLint>(i), nothing.data());
}

base::Status LightingPass::run(const gl::Context& gl, const GBuffer& gbuffer, const ShadeInputs& in,
                               const gl::VertexArray& empty, const DrawTarget& out) {
    const Key key{in.key, gbuffer.spec.emissive, gbuffer.spec.specular};
    const auto program = programs_.get(
        key, [&](const Key& k) { return make(gl, *sources_, k.shade, k.emissive, k.specular); });
    if (!program) return tl::unexpected(program.error());
    gl.texture_barrier();
    gl::begin_draw(gl, out.framebuffer, out.size, **program, {.depth_func = GL_GREATER});
    bind_shade_textures(gl, in);
    gl::bind_texture(gl, albedo_unit, GL_TEXTURE_2D, gbuffer.albedo, nullptr);
    gl::bind_texture(gl, normal_unit, GL_TEXTURE_2D, gbuffer.normal, nullptr);
    gl::bind_texture(gl, metal_unit, GL_TEXTURE_2D, gbuffer.metal_rough_ao, nullptr);
    gl::bind_texture(gl, depth_unit, GL_TEXTURE_2D, gbuffer.depth, nullptr);
    gl::bind_texture(gl, emissive_unit, GL_TEXTURE_2D, gbuffer.emissive_nit, nullptr);
    if (gbuffer.spec.specular)
        gl::bind_texture(gl, reflection_unit, GL_TEXTURE_2D, gbuffer.specular, nullptr);
    gl::draw_full_screen(gl, empty);
    return {};
}

}  // namespace facet::frame
