// A glTF primitive all the way to a Mesh.
// SPDX-License-Identifier: MIT
#include "scene/gltf/mesh.h"

#include "scene/tangents.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::scene::gltf {
namespace {

bool draws_surface(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Memory for one more copy of the primitive: primitives and poses may share accessors without end.
base::Status take_memory(Import& import, const tinygltf::Primitive& primitive,
                         const std::string& where) {
    constexpr std::size_t vertex_bytes =
        80;  // position, normal, tangent, two coordinates, color, joints
    const auto count_of = [&](int index) -> std::size_t {
        const bool is_there =
            index >= 0 && static_cast<std::size_t>(index) < import.asset.accessors.size();
        return is_there ? import.asset.accessors[static_cast<std::size_t>(index)].count : 0;
    };
    const auto position = primitive.attributes.find("POSITION");
    const std::size_t vertices =
        position == primitive.attributes.end() ? 0 : count_of(position->second);
    return import.take_memory(
        vertices * vertex_bytes + count_of(primitive.indices) * 3 * sizeof(std::uint32_t), where);
}

/// Given tangents of length 1 and w of 1 or -1; empty where one of them is none.
void mend_tangents(Mesh& mesh) {
    for (Vec4& tangent : mesh.tangents) {
        const Vec3 direction(tangent);
        const float size = math::length(direction);
        if (!(size > 1e-6F) || !std::isfinite(size)) {
            mesh.tangents.clear();
            return;
        }
        tangent = Vec4(direction / size, tangent.w < 0.0F ? -1.0F : 1.0F);
    }
}

void complete_normals(Import& import, const std::string& where, Mesh& mesh) {
    if (mesh.normals.empty()) {
        make_flat(mesh);
        return;
    }
    if (const std::size_t count = mend_normals(mesh); count > 0)
        import.warn(where + "/attributes/NORMAL",
                    "normals are zero or not finite, computed from the faces",
                    fmt::format("{} vertices", count));
}

/// Tangents only where the material has a normal map: given ones, else those of MikkTSpace.
void complete_tangents(const Import& import, Mesh& mesh) {
    const Material& material = import.scene.materials[mesh.material.index];
    const Texture* map = nullptr;
    for (std::size_t slot = 0; map == nullptr && slot < material.textures.size(); ++slot)
        if (material.textures[slot] && tables::material_textures[slot].is_normal_map)
            map = &*material.textures[slot];
    if (map == nullptr) {
        mesh.tangents.clear();
        return;
    }
    mend_tangents(mesh);
    if (mesh.tangents.empty()) generate_tangents(mesh, map->uv_set);
}

/// The material that the variant chosen gives a primitive.
std::optional<MaterialId> material_of_variant(const Import& import, std::size_t mesh,
                                              std::size_t primitive) {
    if (!import.variant) return std::nullopt;
    const Json* const json =
        element_at(*element_at(import.asset.json, "meshes", mesh), "primitives", primitive);
    const Json* const use =
        json != nullptr ? find_path(*json, "extensions/KHR_materials_variants") : nullptr;
    if (use == nullptr) return std::nullopt;
    for (std::size_t m = 0; m < count_at(*use, "mappings"); ++m) {
        const Json& mapping = *element_at(*use, "mappings", m);
        const Json* const variants = find(mapping, "variants");
        const auto material = index_at(mapping, "material");
        if (variants == nullptr || !variants->is_array() || !material ||
            *material >= import.model.materials.size())
            continue;
        if (std::find(variants->begin(), variants->end(), Json(*import.variant)) != variants->end())
            return MaterialId{*material};
    }
    return std::nullopt;
}

MaterialId material_of(Import& import, const tinygltf::Primitive& primitive) {
    if (primitive.material < 0) return default_material(import);
    return {static_cast<std::uint32_t>(primitive.material)};
}

base::Status deform(Import& import, const tinygltf::Primitive& primitive, const Pose& pose,
                    const std::string& where, Streams& streams) {
    auto morphed = apply_morphs(import, primitive, pose.morph_weights, where, streams.mesh);
    if (!morphed) return morphed;
    if (pose.joints.empty()) return {};
    return apply_skin(pose.joints, where, streams);
}

}  // namespace

base::Result<std::optional<Mesh>> build_mesh(Import& import, std::size_t mesh_index,
                                             std::size_t primitive_index, const Pose& pose) {
    const tinygltf::Mesh& source = import.model.meshes[mesh_index];
    const tinygltf::Primitive& primitive = source.primitives[primitive_index];
    const std::string where = fmt::format("/meshes/{}/primitives/{}", mesh_index, primitive_index);
    if (!draws_surface(primitive.mode)) {
        import.warn(where + "/mode", "points and lines are not drawn",
                    std::to_string(primitive.mode));
        return std::nullopt;
    }
    if (auto taken = take_memory(import, primitive, where); !taken)
        return tl::unexpected(taken.error());
    auto streams = read_streams(import, primitive, where);
    if (!streams) return tl::unexpected(streams.error());
    Mesh& mesh = streams->mesh;
    if (mesh.positions_m.empty()) {
        import.warn(where, "primitive without positions is skipped");
        return std::nullopt;
    }
    if (auto deformed = deform(import, primitive, pose, where, *streams); !deformed)
        return tl::unexpected(deformed.error());
    auto triangles = read_triangles(import, primitive, mesh.positions_m.size(), where);
    if (!triangles) return tl::unexpected(triangles.error());
    mesh.indices = std::move(*triangles);
    const std::size_t dropped = drop_degenerates(mesh);
    if (dropped > 0 && primitive.mode == TINYGLTF_MODE_TRIANGLES)
        import.warn(where, "triangles without area are skipped", std::to_string(dropped));
    if (mesh.indices.empty()) {
        import.warn(where, "primitive without triangles is skipped");
        return std::nullopt;
    }
    mesh.name = source.name.empty() ? fmt::format("mesh {}", mesh_index) : source.name;
    const auto chosen = material_of_variant(import, mesh_index, primitive_index);
    mesh.material =
        material_for(import, chosen ? *chosen : material_of(import, primitive), mesh, where);
    complete_normals(import, where, mesh);
    complete_tangents(import, mesh);
    if (pose.is_mirrored) mirror(mesh);
    for (const Vec3& position : mesh.positions_m) mesh.bounds_m.add(position);
    return std::move(mesh);
}

}  // namespace facet::scene::gltf
