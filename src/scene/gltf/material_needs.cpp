// What a material asks of the primitives that wear it.
// SPDX-License-Identifier: MIT
#include "scene/gltf/material_needs.h"

#include "scene/gltf/attributes.h"

#include <spdlog/fmt/fmt.h>

#include <set>
#include <vector>

namespace facet::scene::gltf {
namespace {

constexpr std::size_t max_bindings = 64;  // more than all extensions together have

void collect(const Json& object, const std::string& path, std::vector<Binding>& out) {
    if (!object.is_object()) return;
    for (const auto& [name, value] : object.items()) {
        if (out.size() >= max_bindings) return;
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

void check_coordinates(const MaterialNeeds& needs, const Json& attributes, const std::string& where,
                       Problems& problems) {
    const std::size_t count = set_count(attributes);
    for (const Binding& binding : needs.bindings)
        if (binding.set >= count)
            problems.error("MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", where + "/material",
                           "the primitive lacks texture coordinates of its material",
                           fmt::format("{} needs TEXCOORD_{}", binding.path, binding.set));
}

void check_tangents(const MaterialNeeds& needs, const Json& primitive, const Json& attributes,
                    const std::string& where, Problems& problems) {
    if (unsigned_at(primitive, "mode").value_or(4) < 4) return;
    if (attributes.contains("TANGENT") && attributes.contains("NORMAL")) return;
    if (needs.has_normal_map)
        problems.note(Severity::warning, "MESH_PRIMITIVE_GENERATED_TANGENT_SPACE",
                      where + "/material", "tangents will be computed");
    else if (needs.has_tangent_lobes)
        problems.error(
            "MESH_PRIMITIVE_NO_TANGENT_SPACE", where + "/material",
            "the material needs tangents, but there are none and no normal map to make them for");
}

}  // namespace

std::vector<MaterialNeeds> read_material_needs(const Json& json) {
    std::vector<MaterialNeeds> out(count_at(json, "materials"));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Json& material = *element_at(json, "materials", i);
        collect(material, pointer_text("materials", i), out[i].bindings);
        out[i].has_normal_map = find(material, "normalTexture") != nullptr;
        out[i].has_tangent_lobes =
            find_path(material, "extensions/KHR_materials_anisotropy") != nullptr ||
            find_path(material, "extensions/KHR_materials_clearcoat/clearcoatNormalTexture") !=
                nullptr;
    }
    return out;
}

void check_material_needs(const std::vector<MaterialNeeds>& needs, const Json& primitive,
                          const std::string& where, Problems& problems) {
    const auto index = index_at(primitive, "material");
    const Json* const attributes = find(primitive, "attributes");
    if (!index || *index >= needs.size() || attributes == nullptr || !attributes->is_object())
        return;
    check_coordinates(needs[*index], *attributes, where, problems);
    check_tangents(needs[*index], primitive, *attributes, where, problems);
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

}  // namespace facet::scene::gltf
