// A scene at a time.
// SPDX-License-Identifier: MIT
#include "scene/animate.h"

#include "base/text.h"
#include "scene/deform.h"
#include "scene/keyframes.h"
#include "scene/light_shapes.h"
#include "scene/relief.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace facet::scene {
namespace {

Mat4 matrix_of(const RigNode& node) {
    if (node.matrix) return *node.matrix;
    const Mat4 moved = glm::translate(Mat4(1.0F), node.translation);
    return glm::scale(moved * glm::mat4_cast(node.rotation), node.scale);
}

Vec3 sample_vector(const Keyframes& keyframes, double time_s) {
    std::array<float, 3> out{};
    sample(keyframes, time_s, out);
    return {out[0], out[1], out[2]};
}

void move(const Clip& clip, double time_s, std::vector<RigNode>& nodes, Pose& pose) {
    for (const Channel& channel : clip.channels) {
        const Keyframes& keyframes = clip.keyframes[channel.keyframes];
        RigNode& node = nodes[channel.node];
        switch (channel.what) {
            case Moves::translation:
                node.translation = sample_vector(keyframes, time_s);
                break;
            case Moves::rotation:
                node.rotation = sample_rotation(keyframes, time_s);
                break;
            case Moves::scale:
                node.scale = sample_vector(keyframes, time_s);
                break;
            case Moves::weights: {
                std::vector<float>& weights = pose.weights[channel.node];
                weights.resize(keyframes.width);
                sample(keyframes, time_s, weights);
                break;
            }
        }
    }
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
    const float size = math::length(v);
    return size > 0.0F && std::isfinite(size) ? v / size : otherwise;
}

/// Rotation and translation of `matrix`: z and y kept as they are seen, x made to fit, so that a
/// mirrored node still gives a camera that is not mirrored.
Mat4 rigid(const Mat4& matrix) {
    const Vec3 z = unit_or(Vec3(matrix[2]), Vec3(0.0F, 0.0F, 1.0F));
    const Vec3 spare = std::fabs(z.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F);
    const Vec3 x = unit_or(math::cross(unit_or(Vec3(matrix[1]), spare), z),
                           unit_or(math::cross(spare, z), spare));
    const Vec3 y = math::cross(z, x);
    return {Vec4(x, 0.0F), Vec4(y, 0.0F), Vec4(z, 0.0F), Vec4(Vec3(matrix[3]), 1.0F)};
}

/// The same mesh turned round for the other kind of matrix, made at first need.
MeshId mirror_image(Scene& scene, MeshId id) {
    if (!scene.meshes[id.index].mirror_image) {
        const MeshId made{static_cast<std::uint32_t>(scene.meshes.size())};
        lower_relief(scene.meshes[id.index]);
        Mesh image = scene.meshes[id.index];
        mirror(image);
        image.is_mirrored = !image.is_mirrored;
        image.mirror_image = id;
        scene.meshes.push_back(std::move(image));
        scene.meshes[id.index].mirror_image = made;
    }
    return *scene.meshes[id.index].mirror_image;
}

/// The meshes of one placing, deformed anew.
void deform(const Rig& rig, const Placing& placing, const Deformation& by, Scene& scene) {
    for (std::size_t p = 0; p < placing.shapes.size(); ++p) {
        const Shape& shape = rig.shapes[placing.shapes[p]];
        const Material& material = scene.materials[shape.mesh.material.index];
        scene.meshes[placing.meshes[p].index] = deformed(shape.mesh, shape, by, material).mesh;
    }
}

}  // namespace

base::Result<const Clip*> find_clip(const Scene& scene, const std::string& name) {
    const std::span<const Clip> clips =
        scene.rig == nullptr ? std::span<const Clip>{} : std::span(scene.rig->clips);
    if (name.empty() && clips.empty()) return nullptr;
    std::size_t index = name.empty() ? 0 : clips.size();
    for (std::size_t i = clips.size(); i-- > 0;)
        if (!name.empty() && clips[i].name == name) index = i;
    const auto number = base::parse_integer(name);
    if (index == clips.size() && number && *number >= 0 &&
        static_cast<std::size_t>(*number) < clips.size())
        index = static_cast<std::size_t>(*number);
    if (index < clips.size()) {
        if (clips[index].fault) return base::fail(*clips[index].fault);
        return &clips[index];
    }
    std::vector<std::string> names;
    for (const Clip& clip : clips) names.push_back(base::escaped(clip.name));
    return base::fail({.code = base::ErrorCode::usage,
                       .what = "the file has no such animation",
                       .found = name,
                       .remedy = names.empty()
                                     ? "it has none"
                                     : fmt::format("one of {}, or its index, 0 to {}",
                                                   base::join(names, ", "), names.size() - 1)});
}

Pose pose_at(const Rig& rig, const Clip* clip, double time_s) {
    Pose pose;
    std::vector<RigNode> nodes = rig.nodes;
    if (clip != nullptr) move(*clip, time_s, nodes, pose);
    pose.world_from_node.assign(nodes.size(), Mat4(1.0F));
    for (const std::uint32_t index : rig.order) {
        const RigNode& node = nodes[index];
        const Mat4 local = matrix_of(node);
        pose.world_from_node[index] =
            node.parent == RigNode::none ? local : pose.world_from_node[node.parent] * local;
    }
    return pose;
}

std::span<const Mat4> Joints::of(std::uint32_t skin) {
    const Skin& from = rig_.skins[skin];
    std::vector<Mat4>& out = by_skin_[skin];
    for (std::size_t j = out.size(); j < from.joints.size(); ++j)
        out.push_back(pose_.world_from_node[from.joints[j]] * from.joint_from_object[j]);
    return out;
}

bool is_flat(const Mat4& matrix) {
    const float determinant = glm::determinant(Mat3(matrix));
    const Vec4& place = matrix[3];
    return determinant == 0.0F || !std::isfinite(determinant) || !std::isfinite(place.x) ||
           !std::isfinite(place.y) || !std::isfinite(place.z);
}

bool is_mirroring(const Mat4& matrix) { return glm::determinant(Mat3(matrix)) < 0.0F; }

void place(Camera& camera, const Mat4& world_from_node) {
    camera.world_from_view = rigid(world_from_node);
}

void place(Light& light, const Mat4& world_from_node) {
    light.position_m = Vec3(world_from_node[3]);
    light.direction = -unit_or(Vec3(world_from_node[2]), Vec3(0.0F, 0.0F, 1.0F));
}

Camera carried(const Camera& camera, const Pose& from, const Pose& to) {
    Camera out = camera;
    if (!camera.source_node) return out;
    const Mat4 before = rigid(from.world_from_node[*camera.source_node]);
    const Mat4 after = rigid(to.world_from_node[*camera.source_node]);
    if (after != before)
        out.world_from_view = after * (math::inverse(before) * camera.world_from_view);
    return out;
}

bool take_pose(const Pose& pose, Scene& scene) {
    const Rig& rig = *scene.rig;
    remove_light_shapes(scene);  // what is made here is the model's, and comes before them
    const std::size_t mesh_count = scene.meshes.size();
    bool has_deformed = false;
    Joints skins(rig, pose);
    scene.instances.clear();
    for (const Placing& placing : rig.placings) {
        const Mat4 world_from_copy =
            placing.skin ? placing.node_from_copy
                         : pose.world_from_node[placing.node] * placing.node_from_copy;
        if (is_flat(world_from_copy)) continue;
        std::span<const Mat4> joints;
        if (placing.skin) joints = skins.of(*placing.skin);
        const bool is_mirrored = is_mirroring(joints.empty() ? world_from_copy : joints.front());
        if (!placing.shapes.empty()) {
            const auto moved = pose.weights.find(placing.node);
            const std::vector<float>& weights =
                moved == pose.weights.end() ? placing.weights : moved->second;
            deform(rig, placing, {weights, joints, is_mirrored}, scene);
            has_deformed = true;
        }
        for (MeshId id : placing.meshes) {
            if (scene.meshes[id.index].indices.empty()) continue;
            if (scene.meshes[id.index].is_mirrored != is_mirrored) id = mirror_image(scene, id);
            scene.instances.push_back({.mesh = id,
                                       .world_from_object = world_from_copy,
                                       .node = placing.name,
                                       .object_id = placing.node + 1});
        }
    }
    for (Camera& camera : scene.cameras)
        if (camera.source_node) place(camera, pose.world_from_node[*camera.source_node]);
    return has_deformed || scene.meshes.size() != mesh_count;
}

bool take_pose(const Pose& pose, std::vector<Light>& lights) {
    bool has_moved = false;
    for (Light& light : lights) {
        if (!light.source_node || *light.source_node >= pose.world_from_node.size()) continue;
        const Light before = light;
        place(light, pose.world_from_node[*light.source_node]);
        has_moved = has_moved || light.position_m != before.position_m ||
                    light.direction != before.direction;
    }
    return has_moved;
}

}  // namespace facet::scene
