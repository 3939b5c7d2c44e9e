// A glTF primitive all the way to a Mesh.
// SPDX-License-Identifier: MIT
#include "scene/gltf/mesh.h"

#include "scene/gltf/points_and_lines.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::scene::gltf {
namespace {

bool is_surface(int mode) { return !draws_points(mode) && !draws_lines(mode); }

/// Memory for one more copy of the primitive: primitives and poses may share accessors without end.
base::Status take_memory(Import& import, const tinygltf::Primitive& primitive,
                         const std::string& where) {
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

std::string place_of(const PrimitiveId& id) {
    return fmt::format("/meshes/{}/primitives/{}", id.mesh, id.primitive);
}

}  // namespace

base::Result<std::optional<Shape>> read_shape(Import& import, const PrimitiveId& id,
                                              std::span<const float> weights) {
    const tinygltf::Mesh& source = import.model.meshes[id.mesh];
    const tinygltf::Primitive& primitive = source.primitives[id.primitive];
    const std::string where = place_of(id);
    if (auto taken = take_memory(import, primitive, where); !taken)
        return tl::unexpected(taken.error());
    auto shape = read_streams(import, primitive, where);
    if (!shape) return tl::unexpected(shape.error());
    Mesh& mesh = shape->mesh;
    if (mesh.positions_m.empty()) {
        import.warn(where, "primitive without positions is skipped");
        return std::nullopt;
    }
    const bool has_surface = is_surface(primitive.mode);
    const bool is_lit = has_surface || !mesh.normals.empty();
    if (auto read = read_targets(import, primitive, weights, where, *shape); !read)
        return tl::unexpected(read.error());
    if (has_surface) {
        auto triangles = read_triangles(import, primitive, mesh.positions_m.size(), where);
        if (!triangles) return tl::unexpected(triangles.error());
        mesh.indices = std::move(*triangles);
    } else if (auto body = thicken(import, id.mesh, primitive, where, *shape); !body) {
        return tl::unexpected(body.error());
    }
    mesh.name = source.name.empty() ? fmt::format("mesh {}", id.mesh) : source.name;
    const auto chosen = material_of_variant(import, id.mesh, id.primitive);
    mesh.material =
        material_for(import, chosen ? *chosen : material_of(import, primitive), mesh, where);
    if (!is_lit) mesh.material = unlit_material(import, mesh.material);
    return std::move(*shape);
}

base::Result<Mesh> build_mesh(Import& import, const PrimitiveId& id, Shape shape,
                              const Deformation& by) {
    const std::string where = place_of(id);
    if (!by.joints.empty())
        if (auto checked = check_joints(shape, by.joints.size(), where); !checked)
            return tl::unexpected(checked.error());
    const Material& material = import.scene.materials[shape.mesh.material.index];
    Mesh undeformed = std::move(shape.mesh);
    // Flat faces have vertices of their own, and tangents may part others.
    const std::size_t read = undeformed.positions_m.size();
    const std::size_t expected =
        undeformed.normals.empty() ? std::max(read, undeformed.indices.size()) : read;
    if (auto taken = import.take_memory((expected - read) * vertex_bytes, where); !taken)
        return tl::unexpected(taken.error());
    Deformed posed = deformed(std::move(undeformed), shape, by, material);
    const std::size_t parted = std::max(posed.mesh.positions_m.size(), expected) - expected;
    if (auto taken = import.take_memory(parted * vertex_bytes, where); !taken)
        return tl::unexpected(taken.error());
    const int mode = import.model.meshes[id.mesh].primitives[id.primitive].mode;
    if (posed.flat_triangles > 0 && mode == TINYGLTF_MODE_TRIANGLES)
        import.warn(where, "triangles without area are skipped",
                    std::to_string(posed.flat_triangles));
    if (posed.mesh.indices.empty()) import.warn(where, "primitive without triangles is skipped");
    if (posed.mended_normals > 0)
        import.warn(where + "/attributes/NORMAL",
                    "normals are zero or not finite, computed from the faces",
                    fmt::format("{} vertices", posed.mended_normals));
    return std::move(posed.mesh);
}

}  // namespace facet::scene::gltf
