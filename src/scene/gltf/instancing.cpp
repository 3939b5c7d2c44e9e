// EXT_mesh_gpu_instancing: translation, rotation and scale of each copy, from accessors.
// SPDX-License-Identifier: MIT
#include "scene/gltf/instancing.h"

#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

namespace facet::scene::gltf {
namespace {

/// The attribute's floats; empty where it is absent or of another shape.
std::vector<float> read_attribute(const Import& import, const Json& attributes, const char* name,
                                  std::size_t components, std::size_t& count) {
    const auto index = index_at(attributes, name);
    if (!index || *index >= import.asset.accessors.size()) return {};
    const Accessor& accessor = import.asset.accessors[*index];
    if (!accessor.is_sound || accessor.components != components) return {};
    count = count == 0 ? accessor.count : std::min(count, accessor.count);
    return read_floats(accessor);
}

}  // namespace

base::Result<std::vector<Mat4>> read_instances(const Import& import, std::uint32_t node) {
    const Json* const attributes = find_path(*element_at(import.asset.json, "nodes", node),
                                             "extensions/EXT_mesh_gpu_instancing/attributes");
    if (attributes == nullptr) return std::vector<Mat4>{};
    std::size_t count = 0;
    const auto moves = read_attribute(import, *attributes, "TRANSLATION", 3, count);
    const auto turns = read_attribute(import, *attributes, "ROTATION", 4, count);
    const auto scales = read_attribute(import, *attributes, "SCALE", 3, count);
    constexpr std::size_t most = 1'000'000;
    if (count > most)
        return base::fail(
            {.code = base::ErrorCode::limit_reached,
             .where = pointer_text("nodes", node, "/extensions/EXT_mesh_gpu_instancing"),
             .what = "too many copies",
             .found = fmt::format("{}, limit {}", count, most)});
    std::vector<Mat4> out;
    out.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Mat4 matrix(1.0F);
        if (!moves.empty())
            matrix = glm::translate(matrix, Vec3(moves[i * 3], moves[i * 3 + 1], moves[i * 3 + 2]));
        if (!turns.empty()) {
            math::Quat q;
            q.x = turns[i * 4];
            q.y = turns[i * 4 + 1];
            q.z = turns[i * 4 + 2];
            q.w = turns[i * 4 + 3];
            matrix = matrix * glm::mat4_cast(glm::normalize(q));
        }
        if (!scales.empty())
            matrix = glm::scale(matrix, Vec3(scales[i * 3], scales[i * 3 + 1], scales[i * 3 + 2]));
        out.push_back(matrix);
    }
    return out;
}

}  // namespace facet::scene::gltf
