// A scene at a time: clips move nodes, and nodes carry meshes, cameras and lights.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/rig.h"
#include "scene/scene.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace facet::scene {

/// The clip of a name, else of an index; the first for an empty text, null where there is none.
/// Errors: usage (no such clip, with those that there are), and what is wrong with it.
[[nodiscard]] base::Result<const Clip*> find_clip(const Scene& scene, const std::string& name);

/// Where everything is.
struct Pose {
    std::vector<Mat4> world_from_node;
    std::map<std::uint32_t, std::vector<float>> weights;  ///< of morph targets, by node that moves
};
/// `clip` null: as the file has it.
[[nodiscard]] Pose pose_at(const Rig& rig, const Clip* clip, double time_s);

/// world_from_object of each joint, found once for all meshes of a skin. Rig and pose outlive it.
class Joints {
public:
    Joints(const Rig& rig, const Pose& pose) : rig_(rig), pose_(pose), by_skin_(rig.skins.size()) {}
    /// Lives as long as this.
    [[nodiscard]] std::span<const Mat4> of(std::uint32_t skin);

private:
    const Rig& rig_;
    const Pose& pose_;
    std::vector<std::vector<Mat4>> by_skin_;  ///< empty: not asked for yet
};
/// Whether nothing is left of what such a matrix places, or its place is none.
[[nodiscard]] bool is_flat(const Mat4& matrix);
[[nodiscard]] bool is_mirroring(const Mat4& matrix);

void place(Camera& camera, const Mat4& world_from_node);
void place(Light& light, const Mat4& world_from_node);
/// A camera that a node carries from one pose to another, whatever it was turned to on it.
[[nodiscard]] Camera carried(const Camera& camera, const Pose& from, const Pose& to);

/// Puts the scene's meshes, instances and cameras where the pose of its rig has them. Whether
/// vertices or triangles are other ones now. Shapes of lights are gone until
/// place_light_shapes().
bool take_pose(const Pose& pose, Scene& scene);
/// The same of lights that hang on nodes. Whether one is elsewhere now.
bool take_pose(const Pose& pose, std::vector<Light>& lights);

}  // namespace facet::scene
