// Checks of meshes: attributes, formats, counts, indices, morph targets.
// SPDX-License-Identifier: MIT
#include "scene/gltf/attributes.h"
#include "scene/gltf/check.h"
#include "scene/gltf/material_needs.h"
#include "scene/gltf/schema.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <set>

namespace facet::scene::gltf {
namespace {

/// One primitive under the eye of the checks.
struct Looking {
    const Asset& asset;
    const Json& primitive;
    std::string where;
    Quantized quantized;
    Problems& problems;

    /// Null where the index is none of an accessor with a known shape.
    [[nodiscard]] const Accessor* accessor(const Json& value) const {
        const auto index = as_unsigned(value);
        if (!index || *index >= asset.accessors.size()) return nullptr;
        const Accessor& found = asset.accessors[*index];
        return found.components > 0 ? &found : nullptr;
    }
    [[nodiscard]] const Json& json_of(const Json& value) const {
        return *element_at(asset.json, "accessors", *as_unsigned(value));
    }
};

Quantized quantized_of(const Json& json) {
    const Json* const used = find(json, "extensionsUsed");
    const bool is_used =
        used != nullptr && used->is_array() &&
        std::find(used->begin(), used->end(), Json("KHR_mesh_quantization")) != used->end();
    return is_used ? Quantized::yes : Quantized::no;
}

void check_format(Looking& l, const Accessor& accessor, std::string_view formats,
                  const std::string& at) {
    const std::string format = format_of(accessor);
    if (accessor.component == Component::u32) {
        l.problems.error("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", at,
                         "vertex attributes cannot be 32-bit integers", format);
        return;
    }
    if (!formats.empty() && !is_listed(formats, format))
        l.problems.error("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", at,
                         "wrong format for this attribute",
                         fmt::format("{}, not {}", format, formats));
}

void check_alignment(Looking& l, const Json& value, const Accessor& accessor,
                     const std::string& at) {
    const Json& json = l.json_of(value);
    const auto view_index = index_at(json, "bufferView");
    const Json* const view =
        view_index ? element_at(l.asset.json, "bufferViews", *view_index) : nullptr;
    if (view == nullptr) return;
    const bool is_strided = find(*view, "byteStride") != nullptr;
    const std::size_t element_size = component_bytes(accessor.component) * accessor.components;
    if (unsigned_at(json, "byteOffset").value_or(0) % 4 != 0 ||
        (!is_strided && element_size % 4 != 0))
        l.problems.error("MESH_PRIMITIVE_ACCESSOR_UNALIGNED", at,
                         "vertex attribute is not aligned to 4 bytes");
}

void check_bounds(Looking& l, const Json& value, const std::string& at) {
    const Json& json = l.json_of(value);
    if (find(json, "min") == nullptr || find(json, "max") == nullptr)
        l.problems.error("MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", at,
                         "positions without min and max");
}

/// Attributes of the primitive or of one target; `base_count` is that of the primitive's own, 0 for
/// itself.
void check_attribute(Looking& l, const std::string& name, const Json& value, const std::string& at,
                     bool is_morph) {
    const auto parsed = parse_attribute(name);
    if (!parsed) {
        l.problems.error("MESH_PRIMITIVE_INVALID_ATTRIBUTE", at, "unknown attribute",
                         name.substr(0, 80));
        return;
    }
    const Accessor* const accessor = l.accessor(value);
    if (accessor == nullptr) return;
    check_format(l, *accessor, formats_of(parsed->semantic, is_morph, l.quantized), at);
    check_alignment(l, value, *accessor, at);
    if (parsed->semantic == "POSITION") check_bounds(l, value, at);
}

/// TEXCOORD_0, TEXCOORD_1, … without a gap.
void check_continuity(Looking& l, const Json& attributes) {
    std::map<std::string_view, std::set<std::size_t>> sets;
    for (const auto& [name, value] : attributes.items())
        if (const auto parsed = parse_attribute(name); parsed && parsed->set)
            sets[parsed->semantic].insert(*parsed->set);
    for (const auto& [semantic, numbers] : sets)
        if (*numbers.rbegin() + 1 != numbers.size())
            l.problems.error(
                "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY", l.where + "/attributes",
                "sets of an attribute are not numbered 0, 1, …",
                fmt::format("{}: {} up to {}", semantic, numbers.size(), *numbers.rbegin()));
    if (sets["JOINTS"].size() != sets["WEIGHTS"].size())
        l.problems.error("MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", l.where + "/attributes",
                         "JOINTS and WEIGHTS differ in number",
                         fmt::format("{} and {}", sets["JOINTS"].size(), sets["WEIGHTS"].size()));
}

void check_counts(Looking& l, const Json& attributes) {
    std::size_t count = 0;
    std::map<std::uint32_t, std::set<std::uint64_t>>
        uses;  // accessors in each view without a stride
    for (const auto& [name, value] : attributes.items()) {
        const Accessor* const accessor = l.accessor(value);
        if (accessor == nullptr) continue;
        const std::string at = l.where + "/attributes/" + name;
        if (count == 0) count = accessor->count;
        if (accessor->count != count)
            l.problems.error("MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", at,
                             "attributes of one primitive differ in count",
                             fmt::format("{}, but another has {}", accessor->count, count));
        const auto view = index_at(l.json_of(value), "bufferView");
        const Json* const view_json =
            view ? element_at(l.asset.json, "bufferViews", *view) : nullptr;
        if (view_json == nullptr || find(*view_json, "byteStride") != nullptr) continue;
        if (uses[*view].insert(*as_unsigned(value)).second && uses[*view].size() > 1)
            l.problems.error("MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", at,
                             "two attributes in one buffer view without a stride");
    }
}

void check_attributes(Looking& l) {
    const Json* const attributes = find(l.primitive, "attributes");
    if (attributes == nullptr || !attributes->is_object()) return;
    for (const auto& [name, value] : attributes->items())
        check_attribute(
            l, name, value,
            (Pointer() / std::string_view(name)).text().insert(0, l.where + "/attributes"), false);
    check_continuity(l, *attributes);
    check_counts(l, *attributes);
    if (attributes->contains("TANGENT") && !attributes->contains("NORMAL"))
        l.problems.note(Severity::warning, "MESH_PRIMITIVE_TANGENT_WITHOUT_NORMAL",
                        l.where + "/attributes/TANGENT", "tangents without normals are ignored");
    if (!attributes->empty() && !attributes->contains("POSITION"))
        l.problems.note(Severity::warning, "MESH_PRIMITIVE_NO_POSITION", l.where + "/attributes",
                        "no positions");
}

/// Vertices or indices drawn; 0 where that is not known.
std::size_t drawn_count(const Looking& l) {
    if (const Json* const indices = find(l.primitive, "indices")) {
        const Accessor* const accessor = l.accessor(*indices);
        return accessor != nullptr ? accessor->count : 0;
    }
    const Json* const position = find_path(l.primitive, "attributes/POSITION");
    const Accessor* const accessor = position != nullptr ? l.accessor(*position) : nullptr;
    return accessor != nullptr ? accessor->count : 0;
}

void check_mode(Looking& l) {
    const std::size_t count = drawn_count(l);
    if (count == 0) return;
    const auto mode = unsigned_at(l.primitive, "mode").value_or(4);
    const bool fits = (mode == 1 && count % 2 == 0) || ((mode == 2 || mode == 3) && count >= 2) ||
                      (mode == 4 && count % 3 == 0) || ((mode == 5 || mode == 6) && count >= 3) ||
                      mode == 0 || mode > 6;
    if (!fits)
        l.problems.note(Severity::warning, "MESH_PRIMITIVE_INCOMPATIBLE_MODE", l.where,
                        "count does not fit the mode", fmt::format("{} in mode {}", count, mode));
}

void check_indices(Looking& l) {
    const Json* const value = find(l.primitive, "indices");
    const Accessor* const accessor = value != nullptr ? l.accessor(*value) : nullptr;
    if (accessor == nullptr) return;
    const std::string at = l.where + "/indices";
    const auto view = index_at(l.json_of(*value), "bufferView");
    const Json* const view_json = view ? element_at(l.asset.json, "bufferViews", *view) : nullptr;
    if (view_json != nullptr && find(*view_json, "byteStride") != nullptr)
        l.problems.error("MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", at,
                         "indices in a buffer view with a stride");
    if (!is_listed("SCALAR u8|SCALAR u16|SCALAR u32", format_of(*accessor)))
        l.problems.error("MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", at,
                         "wrong format for indices", format_of(*accessor));
}

void check_target(Looking& l, std::size_t index) {
    const Json& target = *element_at(l.primitive, "targets", index);
    if (!target.is_object()) return;
    for (const auto& [name, value] : target.items()) {
        const std::string at = fmt::format("{}/targets/{}{}", l.where, index,
                                           (Pointer() / std::string_view(name)).text());
        check_attribute(l, name, value, at, true);
        if (!parse_attribute(name)) continue;
        const Json* const attributes = find(l.primitive, "attributes");
        const Json* const base = attributes != nullptr ? find(*attributes, name) : nullptr;
        if (base == nullptr) {
            l.problems.error("MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", at,
                             "the primitive lacks this attribute");
            continue;
        }
        const Accessor* const own = l.accessor(value);
        const Accessor* const other = l.accessor(*base);
        if (own != nullptr && other != nullptr && own->count != other->count)
            l.problems.error("MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", at,
                             "morph target differs in count from the primitive",
                             fmt::format("{}, but there are {}", own->count, other->count));
    }
}

void check_morphs(const Asset& asset, std::size_t index, Problems& problems) {
    const Json& mesh = *element_at(asset.json, "meshes", index);
    const std::size_t primitive_count = count_at(mesh, "primitives");
    if (primitive_count == 0) return;
    const std::size_t target_count = count_at(*element_at(mesh, "primitives", 0), "targets");
    for (std::size_t p = 1; p < primitive_count; ++p) {
        const Json& primitive = *element_at(mesh, "primitives", p);
        const std::size_t count = count_at(primitive, "targets");
        const Json* const targets = find(primitive, "targets");
        if (count == target_count || (targets != nullptr && !targets->is_array())) continue;
        const std::string where = fmt::format("/meshes/{}/primitives/{}", index, p);
        problems.error("MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT",
                       count > 0 ? where + "/targets" : where,
                       "primitives of one mesh differ in their number of morph targets",
                       fmt::format("{}, but the first has {}", count, target_count));
    }
    if (const std::size_t weights = count_at(mesh, "weights");
        weights > 0 && weights != target_count)
        problems.error("MESH_INVALID_WEIGHTS_COUNT", pointer_text("meshes", index, "/weights"),
                       "number of weights differs from that of morph targets",
                       fmt::format("{}, but there are {}", weights, target_count));
}

}  // namespace

void check_meshes(const Asset& asset, Problems& problems) {
    const Quantized quantized = quantized_of(asset.json);
    const std::vector<MaterialNeeds> needs = read_material_needs(asset.json);
    for (std::size_t m = 0; m < count_at(asset.json, "meshes"); ++m) {
        const Json& mesh = *element_at(asset.json, "meshes", m);
        for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p) {
            const Json& primitive = *element_at(mesh, "primitives", p);
            if (!primitive.is_object()) continue;
            Looking looking{asset, primitive, fmt::format("/meshes/{}/primitives/{}", m, p),
                            quantized, problems};
            check_attributes(looking);
            check_indices(looking);
            check_mode(looking);
            for (std::size_t t = 0; t < count_at(primitive, "targets"); ++t)
                check_target(looking, t);
            check_material_needs(needs, primitive, looking.where, problems);
            check_mappings(asset.json, primitive, looking.where, problems);
        }
        check_morphs(asset, m, problems);
    }
}

}  // namespace facet::scene::gltf
