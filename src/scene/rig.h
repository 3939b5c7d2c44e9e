// What a scene is posed from: nodes, skins, morph targets and the clips that move them, as plain
// data. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace facet::scene {

/// How a value goes from one key to the next (glTF 2.0, appendix C).
enum class Interpolation : std::uint8_t { step, linear, cubic };

/// A value over time.
struct Keyframes {
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times_s;  ///< one at least, rising
    /// [times, width] floats; of a cubic [times, 3, width]: the tangent that comes in, the value,
    /// the tangent that goes out.
    std::vector<float> values;
    std::size_t width = 1;
};

enum class Moves : std::uint8_t { translation, rotation, scale, weights };

/// What of a node some keyframes move.
struct Channel {
    std::uint32_t node = 0;
    Moves what = Moves::translation;
    std::size_t keyframes = 0;  ///< of its clip
};

/// One animation of a file.
struct Clip {
    std::string name;
    std::vector<Keyframes> keyframes;
    std::vector<Channel> channels;
    float end_s = 0.0F;                ///< the last of all times
    std::optional<base::Error> fault;  ///< why it cannot be played
};

/// A node as it stands where nothing moves it.
struct RigNode {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t parent = none;
    std::optional<Mat4> matrix;  ///< in place of the three
    Vec3 translation{0.0F};
    math::Quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
    Vec3 scale{1.0F};
};

struct Skin {
    std::vector<std::uint32_t> joints;    ///< nodes
    std::vector<Mat4> joint_from_object;  ///< the inverse bind matrices, one a joint
};

/// Arrays are empty, or as long as the mesh's.
struct MorphTarget {
    std::vector<Vec3> positions_m;
    std::vector<Vec3> normals;
    std::vector<Vec3> tangents;
};

/// A mesh as it is before anything deforms it. Its normals are as they were read: of any length, or
/// missing, where faces are flat.
struct Shape {
    Mesh mesh;
    std::vector<MorphTarget> targets;
    std::size_t influence_count = 0;    ///< joints a vertex: 0, 4 or 8
    std::vector<std::uint32_t> joints;  ///< [vertices, influence_count]
    std::vector<float> joint_weights;   ///< same shape; each row sums to 1, or is 0
};

/// A mesh of the file at one place.
struct Placing {
    std::uint32_t node = 0;
    Mat4 node_from_copy{1.0F};
    std::optional<std::uint32_t> skin;  ///< where it stands then, in the place of its node
    std::vector<float> weights;         ///< of its morph targets, where nothing moves them
    std::vector<MeshId> meshes;         ///< of the scene, one a primitive
    std::vector<std::size_t> shapes;    ///< of the rig, by mesh; empty: nothing deforms them
    std::string name;                   ///< of the node
};

struct Rig {
    std::vector<RigNode> nodes;
    std::vector<std::uint32_t> order;  ///< all nodes, parents before children
    std::vector<Skin> skins;
    std::vector<Shape> shapes;
    std::vector<Placing> placings;
    std::vector<Clip> clips;
};

}  // namespace facet::scene
