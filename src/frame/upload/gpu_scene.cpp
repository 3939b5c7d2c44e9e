// The scene as GL objects: draws, their uniform blocks and samplers.
// SPDX-License-Identifier: MIT
#include "frame/upload/gpu_scene.h"

#include "frame/shared.h"
#include "frame/upload/upload_meshes.h"
#include "frame/upload/upload_textures.h"
#include "scene/dielectric.h"
#include "scene/lobes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace facet::frame {
namespace {

using math::Mat3;
using math::Mat4;
using math::Vec3;
using math::Vec4;

GLint gl_wrap(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat:
            return GL_REPEAT;
        case scene::Wrap::clamp:
            return GL_CLAMP_TO_EDGE;
        case scene::Wrap::mirror:
            return GL_MIRRORED_REPEAT;
    }
    return GL_REPEAT;
}

gl::SamplerSpec sampler_spec(const scene::Texture& texture, bool trilinear, float level_bias) {
    return {.min_filter = trilinear ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST,
            .mag_filter = texture.nearest ? GL_NEAREST : GL_LINEAR,
            .wrap_s = gl_wrap(texture.wrap_u),
            .wrap_t = gl_wrap(texture.wrap_v),
            .level_bias = level_bias};
}

shared::Draw block_of(const scene::Instance& instance, const scene::Material& material,
                      std::uint32_t material_index, std::uint32_t draw_index) {
    const tables::MaterialValues& v = material.values;
    shared::Draw block{};
    block.world_from_object = instance.world_from_object;
    block.normal_from_object = Mat4(math::normal_matrix(Mat3(instance.world_from_object)));
    block.base_color_opacity =
        Vec4(v.base_color, material.alpha_mode == scene::AlphaMode::opaque ? 1.0F : v.opacity);
    block.metallic_roughness_normal_ao = {v.metallic, v.roughness, v.normal_scale, v.ao_strength};
    block.emissive_nit_cutoff = Vec4(v.emissive * v.emissive_strength, v.alpha_cutoff);
    block.dielectric_f0_specular = Vec4(scene::dielectric_f0(v), v.specular);
    block.coat = {v.clearcoat, v.clearcoat_roughness, v.clearcoat_normal_scale, 0.0F};
    block.sheen = Vec4(v.sheen_color, v.sheen_roughness);
    block.transmission = {v.transmission, v.thickness_m, v.ior, v.dispersion};
    block.absorbed_per_m =
        Vec4(scene::extinction_per_m(v) * (1.0F - scene::scattered_share(v)), 0.0F);
    block.diffuse_transmission = Vec4(v.diffuse_transmission_color, v.diffuse_transmission);
    const bool scatters = scene::has_volume(material) && scene::extinction_per_m(v) != Vec3(0.0F);
    block.scattered = Vec4(scatters ? v.scatter_color : Vec3(0.0F), 0.0F);
    block.anisotropy = {v.anisotropy, std::cos(v.anisotropy_rotation_rad),
                        std::sin(v.anisotropy_rotation_rad), 0.0F};
    block.iridescence = {v.iridescence, v.iridescence_ior, v.iridescence_thickness_min_nm,
                         v.iridescence_thickness_max_nm};
    static_assert(sizeof(block.uv_rows) == 2 * sizeof(Vec4) * tables::material_textures.size());
    for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
        const scene::Texture texture = material.textures[slot].value_or(scene::Texture{});
        const Mat3 rows = math::transpose(texture.uv_from_uv);
        const auto set = static_cast<float>(texture.uv_set);
        block.uv_rows[slot * 2] = Vec4(rows[0], set);
        block.uv_rows[slot * 2 + 1] = Vec4(rows[1], set);
    }
    block.ids = {instance.object_id, material_index + 1, material.unlit ? 1U : 0U, draw_index};
    return block;
}

class Uploader {
public:
    Uploader(const gl::Context& gl, const scene::Scene& scene, Filtering filtering, GpuScene& out)
        : gl_(gl), scene_(scene), filtering_(filtering), out_(out) {}

    void add_draw(std::uint32_t index) {
        const scene::Instance& instance = scene_.instances[index];
        const MeshRange& range = out_.mesh_ranges[instance.mesh.index];
        const scene::Mesh& mesh = scene_.meshes[instance.mesh.index];
        const scene::Material& material = scene_.materials[mesh.material.index];
        if (range.index_count == 0) return;
        Draw draw;
        draw.key = material_key(scene_, material, mesh);
        draw.index_count = range.index_count;
        draw.first_index = range.first_index;
        draw.base_vertex = range.base_vertex;
        draw.center_m = Vec3(instance.world_from_object * Vec4(mesh.bounds_m.center(), 1.0F));
        draw.instance = index;
        draw.light = instance.light;
        draw.blended = material.alpha_mode == scene::AlphaMode::blend;
        draw.layered = !draw.blended && scene::has_layers(material);
        draw.double_sided = material.double_sided;
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot)
            if (material.textures[slot])
                draw.textures[slot] = bound(*material.textures[slot], slot);
        draw.block_offset = add_block(block_of(instance, material, mesh.material.index,
                                               static_cast<std::uint32_t>(out_.draws.size())));
        out_.draws.push_back(draw);
    }

    /// What the frame needs targets for: of all meshes, as those without an instance at this time
    /// may have one at another of the same picture.
    void add_needs(const scene::Mesh& mesh) {
        const scene::Material& material = scene_.materials[mesh.material.index];
        if (material.alpha_mode == scene::AlphaMode::blend) return;
        out_.emits = out_.emits || (material.values.emissive != Vec3(0.0F) &&
                                    material.values.emissive_strength > 0.0F);
        out_.has_specular =
            out_.has_specular || material_key(scene_, material, mesh).has(tables::Lobe::specular);
        out_.is_translucent = out_.is_translucent || scene::is_translucent(material);
    }

    void finish() { out_.draw_blocks = gl::make_buffer(gl_, blocks_); }

private:
    BoundTexture bound(const scene::Texture& texture, std::size_t slot) {
        const tables::Texels texels = tables::texels_of(tables::material_textures[slot]);
        const auto use = out_.textures.find({scene_.images[texture.image.index].pixels, texels});
        if (use == out_.textures.end()) return {};
        const bool color = texels == tables::Texels::colors;
        const auto spec =
            sampler_spec(texture, color || !filtering_.is_fast, filtering_.level_bias);
        auto sampler = out_.samplers.find(spec);
        if (sampler == out_.samplers.end())
            sampler = out_.samplers.emplace(spec, gl::make_sampler(gl_, spec)).first;
        return {&use->second, &sampler->second};
    }

    /// Offsets into a uniform buffer must be multiples of a number that is at most 256 everywhere.
    std::size_t add_block(const shared::Draw& block) {
        constexpr std::size_t alignment = 256;
        const std::size_t offset = (blocks_.size() + alignment - 1) / alignment * alignment;
        blocks_.resize(offset + sizeof(block));
        std::memcpy(blocks_.data() + offset, &block, sizeof(block));
        return offset;
    }

    const gl::Context& gl_;
    const scene::Scene& scene_;
    Filtering filtering_;
    GpuScene& out_;
    std::vector<std::byte> blocks_;
};

std::size_t count_tangents(const scene::Scene& scene) {
    return static_cast<std::size_t>(
        std::count_if(scene.meshes.begin(), scene.meshes.end(),
                      [](const scene::Mesh& mesh) { return !mesh.tangents.empty(); }));
}

/// Shapes of lights come and go.
bool has_meshes_of(const scene::Scene& scene, const GpuScene& uploaded) {
    return std::equal(scene.meshes.begin(), scene.meshes.end(), uploaded.mesh_ranges.begin(),
                      uploaded.mesh_ranges.end(),
                      [](const scene::Mesh& mesh, const MeshRange& range) {
                          return mesh.relief == range.relief &&
                                 mesh.indices.size() == static_cast<std::size_t>(range.index_count);
                      });
}

}  // namespace

std::vector<std::size_t> near_to_far(const GpuScene& scene, const shared::View& view) {
    std::vector<std::size_t> order(scene.draws.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const math::Vec3 eye(view.eye_m);
    const math::Vec3 forward(view.forward);
    const auto distance = [&](std::size_t i) {
        return math::dot(scene.draws[i].center_m - eye, forward);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    return order;
}

base::Result<GpuScene> upload_scene(const gl::Context& gl, const scene::Scene& scene,
                                    Filtering filtering, base::ThreadPool& pool) {
    GpuScene out;
    upload_meshes(gl, scene, pool, out);
    out.tangent_count = count_tangents(scene);
    if (auto updated = update_scene(gl, scene, filtering, pool, out); !updated)
        return tl::unexpected(updated.error());
    return out;
}

base::Status update_scene(const gl::Context& gl, const scene::Scene& scene, Filtering filtering,
                          base::ThreadPool& pool, GpuScene& out) {
    if (const std::size_t count = count_tangents(scene);
        count != out.tangent_count || !has_meshes_of(scene, out)) {
        upload_meshes(gl, scene, pool, out);
        out.tangent_count = count;
    }
    if (auto uploaded = upload_textures(gl, scene, pool, out); !uploaded) return uploaded;
    out.draws.clear();
    out.emits = false;
    out.has_specular = false;
    out.is_translucent = false;
    out.bounds_m = scene.seen_bounds_m();
    Uploader uploader(gl, scene, filtering, out);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) uploader.add_draw(i);
    for (const scene::Mesh& mesh : scene.meshes) uploader.add_needs(mesh);
    uploader.finish();
    return gl.check("upload");
}

base::Status move_scene(const gl::Context& gl, const scene::Scene& scene, Filtering filtering,
                        base::ThreadPool& pool, bool with_meshes, GpuScene& out) {
    if (with_meshes) {
        upload_meshes(gl, scene, pool, out);
        out.tangent_count = count_tangents(scene);
    }
    return update_scene(gl, scene, filtering, pool, out);
}

}  // namespace facet::frame
