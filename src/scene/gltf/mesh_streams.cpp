// Vertex streams of a primitive: attributes decoded, numbers that are none mended or refused.
// SPDX-License-Identifier: MIT
#include "scene/gltf/elements.h"
#include "scene/gltf/mesh.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

/// The sound accessor of an attribute; null where the primitive has none or it cannot be read.
const Accessor* find_attribute(const Import& import, const tinygltf::Primitive& primitive,
                               const char* name) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end() || found->second < 0) return nullptr;
    const auto index = static_cast<std::size_t>(found->second);
    if (index >= import.asset.accessors.size() || !import.asset.accessors[index].is_sound)
        return nullptr;
    return &import.asset.accessors[index];
}

template <class Vec>
std::vector<Vec> read_vectors(const Accessor& accessor, const Vec& missing) {
    constexpr auto wanted = static_cast<std::size_t>(Vec::length());
    const std::vector<float> floats = read_floats(accessor);
    std::vector<Vec> out(accessor.count, missing);
    const std::size_t given = std::min(accessor.components, wanted);
    if (given == wanted && accessor.components == wanted) {
        std::memcpy(static_cast<void*>(out.data()), floats.data(), floats.size() * sizeof(float));
        return out;
    }
    for (std::size_t i = 0; i < accessor.count; ++i)
        for (std::size_t c = 0; c < given; ++c)
            out[i][static_cast<typename Vec::length_type>(c)] = floats[i * accessor.components + c];
    return out;
}

template <class Vec>
bool is_finite(const Vec& v) {
    for (typename Vec::length_type i = 0; i < Vec::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

/// Replaces vectors that are not finite; one warning with the count.
template <class Vec>
void mend(Import& import, std::vector<Vec>& values, const std::string& where) {
    std::size_t count = 0;
    for (Vec& v : values)
        if (!is_finite(v)) {
            v = Vec(0.0F);
            ++count;
        }
    if (count > 0)
        import.warn(where, "NaN or infinite, taken as 0", fmt::format("{} vertices", count));
}

/// A stream of `vertex_count` vectors, or an empty one where the attribute is absent.
template <class Vec>
base::Result<std::vector<Vec>> read_stream(Import& import, const tinygltf::Primitive& primitive,
                                           const char* name, const std::string& where,
                                           std::size_t vertex_count,
                                           const Vec& missing = Vec(0.0F)) {
    const Accessor* const accessor = find_attribute(import, primitive, name);
    if (accessor == nullptr) return std::vector<Vec>{};
    const std::string at = where + "/attributes/" + name;
    if (accessor->count != vertex_count)
        return base::fail(
            {.code = ErrorCode::input_invalid,
             .where = at,
             .what = "attributes of one primitive differ in count",
             .found = fmt::format("{}, but POSITION has {}", accessor->count, vertex_count)});
    std::vector<Vec> values = read_vectors<Vec>(*accessor, missing);
    mend(import, values, at);
    return values;
}

base::Result<std::vector<Vec3>> read_positions(Import& import, const tinygltf::Primitive& primitive,
                                               const std::string& where) {
    const Accessor* const accessor = find_attribute(import, primitive, "POSITION");
    if (accessor == nullptr) return std::vector<Vec3>{};
    std::vector<Vec3> positions = read_vectors<Vec3>(*accessor, Vec3(0.0F));
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (!is_finite(positions[i]))
            return base::fail({.code = ErrorCode::input_invalid,
                               .where = where + "/attributes/POSITION",
                               .what = "position is NaN or infinite",
                               .found = fmt::format("accessor {} element {}",
                                                    primitive.attributes.at("POSITION"), i),
                               .remedy = "export the model again"});
    return positions;
}

/// Rows that sum to 1; a row of zeros stays and leaves its vertex where it is.
void normalize_weights(Import& import, const std::string& where, Shape& streams) {
    std::size_t mended = 0;
    for (std::size_t row = 0; row < streams.joint_weights.size(); row += streams.influence_count) {
        float sum = 0.0F;
        for (std::size_t i = 0; i < streams.influence_count; ++i) {
            float& weight = streams.joint_weights[row + i];
            if (!(weight > 0.0F) || !std::isfinite(weight)) weight = 0.0F;
            sum += weight;
        }
        if (std::fabs(sum - 1.0F) > 0.02F) ++mended;
        for (std::size_t i = 0; i < streams.influence_count && sum > 0.0F; ++i)
            streams.joint_weights[row + i] /= sum;
    }
    if (mended > 0)
        import.warn(where + "/attributes/WEIGHTS_0", "joint weights do not sum to 1, scaled",
                    fmt::format("{} vertices", mended));
}

void read_influences(Import& import, const tinygltf::Primitive& primitive, const std::string& where,
                     Shape& streams) {
    const std::size_t vertex_count = streams.mesh.positions_m.size();
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    for (const char* const set : {"0", "1"}) {
        const Accessor* const j =
            find_attribute(import, primitive, (std::string("JOINTS_") + set).c_str());
        const Accessor* const w =
            find_attribute(import, primitive, (std::string("WEIGHTS_") + set).c_str());
        if (j == nullptr || w == nullptr || j->count != vertex_count || w->count != vertex_count)
            break;
        if (j->components != 4 || w->components != 4) break;
        joints.push_back(read_unsigned(*j));
        weights.push_back(read_floats(*w));
        if (joints.back().empty()) return;
    }
    streams.influence_count = joints.size() * 4;
    for (std::size_t v = 0; v < vertex_count; ++v)
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (std::size_t i = 0; i < 4; ++i) {
                streams.joints.push_back(joints[set][v * 4 + i]);
                streams.joint_weights.push_back(weights[set][v * 4 + i]);
            }
    if (streams.influence_count > 0) normalize_weights(import, where, streams);
}

}  // namespace

base::Result<Shape> read_streams(Import& import, const tinygltf::Primitive& primitive,
                                 const std::string& where) {
    Shape streams;
    Mesh& mesh = streams.mesh;
    auto positions = read_positions(import, primitive, where);
    if (!positions) return tl::unexpected(positions.error());
    mesh.positions_m = std::move(*positions);
    const std::size_t count = mesh.positions_m.size();
    if (count == 0) return streams;
    const auto take = [](auto&& read, auto& to) -> base::Status {
        if (!read) return base::fail(read.error());
        to = std::move(*read);
        return {};
    };
    const Accessor* const normals = find_attribute(import, primitive, "NORMAL");
    if (normals != nullptr && normals->count == count)
        mesh.normals = read_vectors<Vec3>(*normals, Vec3(0.0F));
    base::Status status =
        take(read_stream<Vec4>(import, primitive, "TANGENT", where, count), mesh.tangents);
    if (status)
        status = take(read_stream<Vec2>(import, primitive, "TEXCOORD_0", where, count), mesh.uv0);
    if (status)
        status = take(read_stream<Vec2>(import, primitive, "TEXCOORD_1", where, count), mesh.uv1);
    const Vec4 opaque(0.0F, 0.0F, 0.0F, 1.0F);
    if (status)
        status = take(read_stream<Vec4>(import, primitive, "COLOR_0", where, count, opaque),
                      mesh.colors);
    if (!status) return tl::unexpected(status.error());
    for (Vec4& color : mesh.colors) color = glm::clamp(color, 0.0F, 1.0F);
    read_influences(import, primitive, where, streams);
    return streams;
}

base::Status read_targets(Import& import, const tinygltf::Primitive& primitive,
                          std::span<const float> weights, const std::string& where, Shape& shape) {
    const std::size_t count = shape.mesh.positions_m.size();
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
        MorphTarget& to = shape.targets.emplace_back();
        const bool is_used = t < weights.size() && weights[t] != 0.0F;
        if (!is_used && !import.has_clips) continue;
        tinygltf::Primitive target;
        target.attributes = primitive.targets[t];
        const std::string at = fmt::format("{}/targets/{}", where, t);
        if (auto taken = import.take_memory(count * sizeof(Vec3) * 3, at); !taken) return taken;
        auto positions = read_stream<Vec3>(import, target, "POSITION", at, count);
        if (!positions) return base::fail(positions.error());
        auto normals = read_stream<Vec3>(import, target, "NORMAL", at, count);
        if (!normals) return base::fail(normals.error());
        auto tangents = read_stream<Vec3>(import, target, "TANGENT", at, count);
        if (!tangents) return base::fail(tangents.error());
        to = {std::move(*positions), std::move(*normals), std::move(*tangents)};
    }
    return {};
}

base::Status check_joints(const Shape& shape, std::size_t joint_count, const std::string& where) {
    for (std::size_t i = 0; i < shape.joints.size(); ++i)
        if (shape.joint_weights[i] != 0.0F && shape.joints[i] >= joint_count)
            return base::fail(
                {.code = ErrorCode::input_invalid,
                 .where = where + "/attributes/JOINTS_0",
                 .what = "joint index out of range",
                 .found = fmt::format("{} of vertex {}, but there are {}", shape.joints[i],
                                      i / shape.influence_count, joint_count)});
    return {};
}

}  // namespace facet::scene::gltf
