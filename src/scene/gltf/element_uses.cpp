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

constexpr double sum_tolerance = 2e-7;  // of the validator, for each weight

void check_indices(const Asset& asset, const Json& primitive, const std::string& where,
                   Problems& problems) {
    const Accessor* const accessor = sound_accessor(asset, find(primitive, "indices"));
    const Json* const attributes = find(primitive, "attributes");
    const auto position = attributes != nullptr ? index_at(*attributes, "POSITION") : std::nullopt;
    if (accessor == nullptr || accessor->components != 1) return;
    const std::vector<std::uint32_t> indices = read_unsigned(*accessor);
    const std::uint64_t restart =
        (std::uint64_t{1} << (8 * component_bytes(accessor->component))) - 1;
    // Its count matters even where it has no data.
    const std::uint32_t position_index = position.value_or(0);
    const bool is_known = position && position_index < asset.accessors.size();
    const std::size_t known = is_known ? asset.accessors[position_index].count : 0;
    const std::size_t vertex_count = known > 0 ? known : restart;
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

/// Joints and weights of all sets of a primitive, by vertex.
struct Influences {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    std::vector<bool> is_float;
    std::size_t count = 0;
};

std::optional<Influences> read_influences(const Asset& asset, const Json& primitive) {
    Influences out;
    for (std::size_t set = 0; set < 8; ++set) {
        const Accessor* const j =
            sound_accessor(asset, find_path(primitive, fmt::format("attributes/JOINTS_{}", set)));
        const Accessor* const w =
            sound_accessor(asset, find_path(primitive, fmt::format("attributes/WEIGHTS_{}", set)));
        if (j == nullptr || w == nullptr || j->components != 4 || w->components != 4 ||
            j->count != w->count)
            break;
        if (set > 0 && j->count != out.count) break;
        out.count = j->count;
        out.joints.push_back(read_unsigned(*j));
        out.weights.push_back(read_floats(*w));
        out.is_float.push_back(w->component == Component::f32);
        if (out.joints.back().empty()) return std::nullopt;
    }
    if (out.joints.empty()) return std::nullopt;
    return out;
}

/// One vertex; false where enough was said.
void check_vertex(const Influences& in, std::size_t v, std::size_t joint_count,
                  const std::string& where, Problems& problems) {
    std::set<std::uint32_t> used;
    double sum = 0;
    for (std::size_t i = 0; i < in.joints.size() * 4; ++i) {
        const std::uint32_t joint = in.joints[i / 4][v * 4 + i % 4];
        const float weight = in.weights[i / 4][v * 4 + i % 4];
        const std::string set = std::to_string(i / 4);
        sum += std::fmax(static_cast<double>(weight), 0.0);
        if (weight < 0.0F)
            problems.error("ACCESSOR_WEIGHTS_NEGATIVE", where + "/attributes/WEIGHTS_" + set,
                           "joint weight is negative", fmt::format("{} of vertex {}", weight, v));
        if (joint >= joint_count)
            problems.error("ACCESSOR_JOINTS_INDEX_OOB", where + "/attributes/JOINTS_" + set,
                           "joint index out of range",
                           fmt::format("{} of vertex {}, but there are {}", joint, v, joint_count));
        else if (weight == 0.0F && joint != 0)
            problems.note(Severity::warning, "ACCESSOR_JOINTS_USED_ZERO_WEIGHT",
                          where + "/attributes/JOINTS_" + set, "joint without weight is not 0",
                          fmt::format("{} of vertex {}", joint, v));
        else if (weight != 0.0F && !used.insert(joint).second)
            problems.error("ACCESSOR_JOINTS_INDEX_DUPLICATE", where + "/attributes/JOINTS_" + set,
                           "joint twice at one vertex", fmt::format("{} of vertex {}", joint, v));
    }
    const double slack = in.is_float[0]
                             ? sum_tolerance * static_cast<double>(in.joints.size() * 4) + 1e-6
                             : 4.0 / 255.0;
    if (std::fabs(sum - 1.0) > slack)
        problems.error("ACCESSOR_WEIGHTS_NON_NORMALIZED", where + "/attributes/WEIGHTS_0",
                       "joint weights do not sum to 1", fmt::format("{} at vertex {}", sum, v));
}

/// Joints of the smallest skin that a mesh is used with; all there could be where it has none.
std::size_t joint_count_of(const Json& json, std::size_t mesh) {
    std::size_t count = std::numeric_limits<std::size_t>::max();
    for (std::size_t n = 0; n < count_at(json, "nodes"); ++n) {
        const Json& node = *element_at(json, "nodes", n);
        const auto skin = index_at(node, "skin");
        if (index_at(node, "mesh") != mesh || !skin || *skin >= count_at(json, "skins")) continue;
        if (const std::size_t joints = count_at(*element_at(json, "skins", *skin), "joints");
            joints > 0)
            count = std::min(count, joints);
    }
    return count;
}

void check_influences(const Asset& asset, const Json& primitive, std::size_t joint_count,
                      const std::string& where, Problems& problems) {
    const auto influences = read_influences(asset, primitive);
    if (!influences) return;
    const std::size_t before = problems.error_count();
    for (std::size_t v = 0; v < influences->count && problems.error_count() < before + 20; ++v)
        check_vertex(*influences, v, joint_count, where, problems);
}

}  // namespace

const Accessor* sound_accessor(const Asset& asset, const Json* index) {
    const auto at = index != nullptr ? as_unsigned(*index) : std::nullopt;
    if (!at || *at >= asset.accessors.size()) return nullptr;
    const Accessor& accessor = asset.accessors[*at];
    return accessor.is_sound && has_data(accessor) ? &accessor : nullptr;
}

void check_primitive_elements(const Asset& asset, Problems& problems) {
    for (std::size_t m = 0; m < count_at(asset.json, "meshes"); ++m) {
        const Json& mesh = *element_at(asset.json, "meshes", m);
        const std::size_t joint_count = joint_count_of(asset.json, m);
        for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p) {
            const Json& primitive = *element_at(mesh, "primitives", p);
            const std::string where = fmt::format("/meshes/{}/primitives/{}", m, p);
            check_indices(asset, primitive, where, problems);
            check_influences(asset, primitive, joint_count, where, problems);
            const Json* const attributes = find(primitive, "attributes");
            if (attributes == nullptr || !attributes->is_object()) continue;
            for (const auto& [name, value] : attributes->items()) {
                const auto parsed = parse_attribute(name);
                const Accessor* const accessor = sound_accessor(asset, &value);
                if (parsed && accessor != nullptr)
                    check_attribute(*accessor, parsed->semantic, where + "/attributes/" + name,
                                    problems);
            }
        }
    }
}

}  // namespace facet::scene::gltf
