// Checks of the numbers in the buffers by what primitives use them for.
// SPDX-License-Identifier: MIT
#include "scene/gltf/element_uses.h"

#include "scene/gltf/attributes.h"
#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>
#include <set>

namespace facet::scene::gltf {
namespace {

void note_degenerates(const Json& primitive, const std::vector<std::uint32_t>& indices,
                      const std::string& where, Problems& problems) {
    std::size_t degenerate_count = 0;
    if (unsigned_at(primitive, "mode").value_or(4) == 4)
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            degenerate_count += indices[i] == indices[i + 1] || indices[i + 1] == indices[i + 2] ||
                                indices[i + 2] == indices[i];
    if (degenerate_count > 0)
        problems.note(Severity::information, "ACCESSOR_INDEX_TRIANGLE_DEGENERATE",
                      where + "/indices", "triangles without area",
                      fmt::format("{} of {}", degenerate_count, indices.size() / 3));
}

void check_indices(const Asset& asset, const Json& primitive, const std::string& where,
                   Problems& problems, Done& done) {
    const Accessor* const accessor = sound_accessor(asset, find(primitive, "indices"));
    const Json* const attributes = find(primitive, "attributes");
    const auto position = attributes != nullptr ? index_at(*attributes, "POSITION") : std::nullopt;
    if (accessor == nullptr || accessor->components != 1) return;
    const std::uint64_t restart =
        (std::uint64_t{1} << (8 * component_bytes(accessor->component))) - 1;
    // Its count matters even where it has no data.
    const std::uint32_t position_index = position.value_or(0);
    const bool is_known = position && position_index < asset.accessors.size();
    const std::size_t known = is_known ? asset.accessors[position_index].count : 0;
    const std::size_t vertex_count = known > 0 ? known : restart;
    const std::string key =
        fmt::format("indices {} {}", find(primitive, "indices")->dump(), vertex_count);
    if (!done.insert(key).second) return;
    const std::vector<std::uint32_t> indices = read_unsigned(*accessor);
    std::size_t told = 0;
    for (std::size_t i = 0; i < indices.size() && told < most_told; ++i) {
        if (indices[i] == restart)
            problems.error("ACCESSOR_INDEX_PRIMITIVE_RESTART", where + "/indices",
                           "index is the primitive restart value",
                           fmt::format("{} at {}", indices[i], i));
        else if (indices[i] >= vertex_count)
            problems.error("ACCESSOR_INDEX_OOB", where + "/indices", "index out of range",
                           fmt::format("{} at {}, but there are {}", indices[i], i, vertex_count));
        else
            continue;
        ++told;
    }
    note_degenerates(primitive, indices, where, problems);
}

void check_unit(const std::vector<float>& values, std::size_t stride, const std::string& at,
                Problems& problems) {
    std::size_t told = 0;
    for (std::size_t i = 0; i + stride <= values.size() && told < most_told; i += stride) {
        const double x = static_cast<double>(values[i]);
        const double y = static_cast<double>(values[i + 1]);
        const double z = static_cast<double>(values[i + 2]);
        const double size = std::sqrt(x * x + y * y + z * z);
        if (std::fabs(size - 1.0) <= unit_tolerance) continue;
        problems.error("ACCESSOR_VECTOR3_NON_UNIT", at, "vector is not of length 1",
                       fmt::format("{} at {}", size, i / stride));
        ++told;
    }
}

void check_signs(const std::vector<float>& values, const std::string& at, Problems& problems) {
    std::size_t told = 0;
    for (std::size_t i = 3; i < values.size() && told < most_told; i += 4)
        if (values[i] != 1.0F && values[i] != -1.0F) {
            problems.error("ACCESSOR_INVALID_SIGN", at, "handedness is neither 1 nor -1",
                           fmt::format("{} at {}", values[i], i / 4));
            ++told;
        }
}

void check_colors(const std::vector<float>& values, const std::string& at, Problems& problems) {
    std::size_t told = 0;
    for (std::size_t i = 0; i < values.size() && told < most_told; ++i)
        if (values[i] < 0.0F || values[i] > 1.0F) {
            problems.error("ACCESSOR_NON_CLAMPED", at, "color outside 0 to 1",
                           fmt::format("{} at {}", values[i], i));
            ++told;
        }
}

void check_attribute(const Accessor& accessor, std::string_view semantic, const std::string& at,
                     Problems& problems) {
    if (semantic == "NORMAL" && accessor.components == 3)
        check_unit(read_floats(accessor), 3, at, problems);
    if (semantic == "TANGENT" && accessor.components == 4) {
        const std::vector<float> values = read_floats(accessor);
        check_unit(values, 4, at, problems);
        check_signs(values, at, problems);
    }
    if (semantic == "COLOR" && accessor.component == Component::f32)
        check_colors(read_floats(accessor), at, problems);
}

/// By mesh: joints of the smallest skin that it is used with; all there could be where it has none.
std::vector<std::size_t> joint_counts(const Json& json) {
    std::vector<std::size_t> counts(count_at(json, "meshes"),
                                    std::numeric_limits<std::size_t>::max());
    for (std::size_t n = 0; n < count_at(json, "nodes"); ++n) {
        const Json& node = *element_at(json, "nodes", n);
        const auto mesh = index_at(node, "mesh");
        const auto skin = index_at(node, "skin");
        if (!mesh || *mesh >= counts.size() || !skin || *skin >= count_at(json, "skins")) continue;
        if (const std::size_t joints = count_at(*element_at(json, "skins", *skin), "joints");
            joints > 0)
            counts[*mesh] = std::min(counts[*mesh], joints);
    }
    return counts;
}

void check_attributes(const Asset& asset, const Json& attributes, const std::string& where,
                      Problems& problems, Done& done) {
    for (const auto& [name, value] : attributes.items()) {
        const auto parsed = parse_attribute(name);
        const Accessor* const accessor = sound_accessor(asset, &value);
        if (!parsed || accessor == nullptr) continue;
        if (done.insert(fmt::format("{} {}", parsed->semantic, value.dump())).second)
            check_attribute(*accessor, parsed->semantic, where + "/attributes/" + name, problems);
    }
}

}  // namespace

const Accessor* sound_accessor(const Asset& asset, const Json* index) {
    const auto at = index != nullptr ? as_unsigned(*index) : std::nullopt;
    if (!at || *at >= asset.accessors.size()) return nullptr;
    const Accessor& accessor = asset.accessors[*at];
    return accessor.is_sound && has_data(accessor) ? &accessor : nullptr;
}

void check_primitive_elements(const Asset& asset, Problems& problems) {
    const std::vector<std::size_t> counts = joint_counts(asset.json);
    Done done;
    for (std::size_t m = 0; m < count_at(asset.json, "meshes"); ++m) {
        const Json& mesh = *element_at(asset.json, "meshes", m);
        for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p) {
            const Json& primitive = *element_at(mesh, "primitives", p);
            const Json* const attributes = find(primitive, "attributes");
            if (attributes == nullptr || !attributes->is_object()) continue;
            const std::string where = fmt::format("/meshes/{}/primitives/{}", m, p);
            check_indices(asset, primitive, where, problems, done);
            check_influences(asset, primitive, counts[m], where, problems, done);
            check_attributes(asset, *attributes, where, problems, done);
        }
    }
}

}  // namespace facet::scene::gltf
