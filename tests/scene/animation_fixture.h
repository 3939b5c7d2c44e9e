// Small animated glTF documents made in memory.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/animate.h"

#include <cmath>
#include <string>
#include <vector>

#include "gltf_fixture.h"

namespace facet::test {

/// Times with the bounds that glTF wants of them; the accessor's index.
inline std::size_t times(Document& d, const std::vector<float>& values) {
    const std::size_t index = d.floats("SCALAR", 1, values);
    d.json["accessors"][index]["min"] = {values.front()};
    d.json["accessors"][index]["max"] = {values.back()};
    return index;
}

/// Adds a channel to the document's animation `clip`, made where it is not there.
inline void animate(Document& d, std::size_t clip, std::size_t node, const char* path,
                    std::size_t input, std::size_t output, const char* interpolation = "LINEAR") {
    Json& json = d.json["animations"][clip];
    const std::size_t sampler = json["samplers"].size();
    json["samplers"].push_back(
        {{"input", input}, {"output", output}, {"interpolation", interpolation}});
    json["channels"].push_back(
        {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
}

/// A triangle on node 0 that goes along x in 2 s.
inline Document moving() {
    Document d = triangle();
    animate(d, 0, 0, "translation", times(d, {0, 2}), d.floats("VEC3", 3, {0, 0, 0, 4, 0, 0}));
    return d;
}

/// A strip from the origin to (0, 2, 0), whose upper end hangs on a joint at (0, 1, 0).
inline Document skinned() {
    Document d = triangle();
    primitive(d)["attributes"]["POSITION"] = d.positions({0, 0, 0, 1, 0, 0, 0, 2, 0});
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["JOINTS_0"] =
        d.accessor<std::uint8_t>("VEC4", 5121, 3, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    primitive(d)["attributes"]["WEIGHTS_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    d.json["nodes"] = {
        {{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"translation", {0, 1, 0}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    const auto bind = d.floats("MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                            1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
    d.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}}};
    // The upper joint turns by 90 degrees around x: up becomes towards +z.
    const float s = std::sqrt(0.5F);
    animate(d, 0, 2, "rotation", times(d, {0, 1}), d.floats("VEC4", 4, {0, 0, 0, 1, s, 0, 0, s}));
    return d;
}

/// A triangle that one target lifts along z, another along y.
inline Document morphed() {
    Document d = triangle();
    primitive(d)["targets"] = {{{"POSITION", d.positions({0, 0, 2, 0, 0, 2, 0, 0, 2})}},
                               {{"POSITION", d.positions({0, 4, 0, 0, 4, 0, 0, 4, 0})}}};
    d.json["meshes"][0]["weights"] = {0.25, 0};
    animate(d, 0, 0, "weights", times(d, {0, 1}), d.floats("SCALAR", 1, {0, 0, 1, 0.5F}));
    return d;
}

/// The document's scene at a time of a clip; empty, and a failed test, where it is not played.
inline scene::Scene posed(const Document& d, double time_s, const std::string& clip = "") {
    scene::Scene scene = loaded_or_fail(d).scene;
    const auto found = scene::find_clip(scene, clip);
    EXPECT_TRUE(found && *found != nullptr) << (found ? "no clip" : base::to_line(found.error()));
    if (!found || *found == nullptr) return scene;
    const scene::Pose pose = scene::pose_at(*scene.rig, *found, time_s);
    scene::take_pose(pose, scene);
    scene::take_pose(pose, scene.lights);
    return scene;
}

inline math::Vec3 origin_of(const scene::Scene& scene, std::size_t instance = 0) {
    return math::Vec3(scene.instances[instance].world_from_object[3]);
}

}  // namespace facet::test
