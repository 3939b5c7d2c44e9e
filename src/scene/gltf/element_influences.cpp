// Checks of joints and weights: which joints move a vertex, and by how much in all.
// SPDX-License-Identifier: MIT
#include "scene/gltf/element_uses.h"
#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facet::scene::gltf {
namespace {

constexpr std::size_t max_influences = 32;  // of a vertex; 8 sets
constexpr std::size_t most_broken = 20;     // vertices told of
constexpr double sum_tolerance = 2e-7;      // of the validator, for each weight

/// Joints and weights of all sets of a primitive, by vertex.
struct Influences {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    std::vector<bool> is_float;
    std::size_t count = 0;
};

std::optional<Influences> read_influences(const Asset& asset, const Json& primitive) {
    Influences out;
    for (std::size_t set = 0; set < max_influences / 4; ++set) {
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
    std::array<std::uint32_t, max_influences> used{};
    std::size_t used_count = 0;
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
        else if (weight != 0.0F &&
                 std::count(used.begin(), used.begin() + static_cast<std::ptrdiff_t>(used_count),
                            joint) > 0)
            problems.error("ACCESSOR_JOINTS_INDEX_DUPLICATE", where + "/attributes/JOINTS_" + set,
                           "joint twice at one vertex", fmt::format("{} of vertex {}", joint, v));
        if (weight != 0.0F) used[used_count++] = joint;
    }
    const double slack = in.is_float[0]
                             ? sum_tolerance * static_cast<double>(in.joints.size() * 4) + 1e-6
                             : 4.0 / 255.0;
    if (std::fabs(sum - 1.0) > slack)
        problems.error("ACCESSOR_WEIGHTS_NON_NORMALIZED", where + "/attributes/WEIGHTS_0",
                       "joint weights do not sum to 1", fmt::format("{} at vertex {}", sum, v));
}

/// The accessors of the joints and weights.
std::string key_of(const Json& primitive, std::size_t joint_count) {
    std::string key = fmt::format("joints {}", joint_count);
    for (std::size_t set = 0; set < max_influences / 4; ++set)
        for (const char* const name : {"JOINTS", "WEIGHTS"})
            if (const Json* const index =
                    find_path(primitive, fmt::format("attributes/{}_{}", name, set)))
                key.append(1, ' ').append(index->dump());
    return key;
}

}  // namespace

void check_influences(const Asset& asset, const Json& primitive, std::size_t joint_count,
                      const std::string& where, Problems& problems, Done& done) {
    if (!done.insert(key_of(primitive, joint_count)).second) return;
    const auto influences = read_influences(asset, primitive);
    if (!influences) return;
    const std::size_t before = problems.error_count();
    for (std::size_t v = 0; v < influences->count && problems.error_count() < before + most_broken;
         ++v)
        check_vertex(*influences, v, joint_count, where, problems);
}

}  // namespace facet::scene::gltf
