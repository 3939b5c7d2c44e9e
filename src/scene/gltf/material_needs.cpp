// What a material asks of the primitives that wear it.
// SPDX-License-Identifier: MIT
#include "scene/gltf/material_needs.h"

#include "scene/gltf/attributes.h"

#include <spdlog/fmt/fmt.h>

#include <set>
#include <vector>

namespace facet::scene::gltf {
namespace {

/// A textureInfo of a material, wherever it stands.
struct Binding {
    std::string path;
    std::uint64_t set = 0;
};

void collect(const Json& object, const std::string& path, std::vector<Binding>& out) {
    if (!object.is_object()) return;
    for (const auto& [name, value] : object.items()) {
        const std::string here = path + "/" + name;
        if (name.ends_with("Texture") && find(value, "index") != nullptr) {
            Binding binding{.path = here, .set = unsigned_at(value, "texCoord").value_or(0)};
            const Json* const transform = find_path(value, "extensions/KHR_texture_transform");
            if (transform != nullptr && unsigned_at(*transform, "texCoord")) {
                binding.set = *unsigned_at(*transform, "texCoord");
                binding.path += "/extensions/KHR_texture_transform";
            }
            out.push_back(std::move(binding));
        } else if (name == "pbrMetallicRoughness" || name == "extensions" ||
                   path.ends_with("/extensions")) {
            collect(value, here, out);
        }
    }
}

std::size_t set_count(const Json& attributes) {
    std::size_t count = 0;
    for (const auto& [name, value] : attributes.items())
        if (const auto parsed = parse_attribute(name); parsed && parsed->semantic == "TEXCOORD")
            ++count;
    return count;
}

void check_coordinates(const Json& material, const std::string& pointer, const Json& attributes,
                       const std::string& where, Problems& problems) {
    std::vector<Binding> bindings;
    collect(material, pointer, bindings);
    const std::size_t count = set_count(attributes);
    for (const Binding& binding : bindings)
        if (binding.set >= count)
            problems.error("MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", where + "/material",
                           "the primitive lacks texture coordinates of its material",
                           fmt::format("{} needs TEXCOORD_{}", binding.path, binding.set));
}

void check_tangents(const Json& material, const Json& primitive, const Json& attributes,
                    const std::string& where, Problems& problems) {
    const auto mode = unsigned_at(primitive, "mode").value_or(4);
    if (mode < 4) return;
    if (attributes.contains("TANGENT") && attributes.contains("NORMAL")) return;
    const bool has_normal_map = find(material, "normalTexture") != nullptr;
    const bool needs_more =
        find_path(material, "extensions/KHR_materials_anisotropy") != nullptr ||
        find_path(material, "extensions/KHR_materials_clearcoat/clearcoatNormalTexture") != nullptr;
    if (has_normal_map)
        problems.note(Severity::warning, "MESH_PRIMITIVE_GENERATED_TANGENT_SPACE",
                      where + "/material", "tangents will be computed");
    else if (needs_more)
        problems.error(
            "MESH_PRIMITIVE_NO_TANGENT_SPACE", where + "/material",
            "the material needs tangents, but there are none and no normal map to make them for");
}

void check_mappings(const Json& json, const Json& primitive, const std::string& where,
                    Problems& problems) {
    const Json* const use = find_path(primitive, "extensions/KHR_materials_variants");
    if (use == nullptr) return;
    const std::string at = where + "/extensions/KHR_materials_variants/mappings";
    const bool is_declared = find_path(json, "extensions/KHR_materials_variants") != nullptr;
    std::set<std::uint64_t> seen;
    for (std::size_t m = 0; m < count_at(*use, "mappings"); ++m) {
        const Json& mapping = *element_at(*use, "mappings", m);
        if (!is_declared)
            problems.error("UNSATISFIED_DEPENDENCY", fmt::format("{}/{}", at, m),
                           "'/extensions/KHR_materials_variants' must be defined as well");
        for (std::size_t v = 0; v < count_at(mapping, "variants"); ++v) {
            const auto variant = as_unsigned(*element_at(mapping, "variants", v));
            if (variant && !seen.insert(*variant).second)
                problems.error("KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT",
                               fmt::format("{}/{}/variants/{}", at, m, v),
                               "variant is mapped twice", std::to_string(*variant));
        }
    }
}

}  // namespace

void check_material_needs(const Json& json, const Json& primitive, const std::string& where,
                          Problems& problems) {
    check_mappings(json, primitive, where, problems);
    const auto index = index_at(primitive, "material");
    const Json* const material = index ? element_at(json, "materials", *index) : nullptr;
    const Json* const attributes = find(primitive, "attributes");
    if (material == nullptr || !material->is_object() || attributes == nullptr ||
        !attributes->is_object())
        return;
    check_coordinates(*material, pointer_text("materials", *index), *attributes, where, problems);
    check_tangents(*material, primitive, *attributes, where, problems);
}

}  // namespace facet::scene::gltf
