// Animations of glTF files: what clips move, and what carries on with it.
// SPDX-License-Identifier: MIT
#include "scene/light_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation_fixture.h"

namespace facet::test {
namespace {

using math::Vec3;

void expect_near(const Vec3& a, const Vec3& b, float most = 1e-5F) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], most) << "xyz"[i];
}

TEST(Animation, NodesMoveAndWhatHangsOnThemMovesAlong) {
    Document d = moving();
    d.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}, {"translation", {0, 1, 0}}}};
    const auto turned = d.floats("VEC4", 4, {0, 0, 0, 1, 0, 0, 1, 0});
    animate(d, 0, 0, "rotation", times(d, {0, 1}), turned);
    const auto grown = d.floats("VEC3", 3, {1, 1, 1, 3, 3, 3});
    animate(d, 0, 0, "scale", times(d, {0, 1}), grown);
    const scene::Scene scene = posed(d, 0.5);
    // A quarter turn around z at twice the size: y becomes -x.
    expect_near(origin_of(scene), {1.0F - 2.0F, 0.0F, 0.0F});
    expect_near(Vec3(scene.instances[0].world_from_object[0]), {0, 2, 0});
}

TEST(Animation, TheFilesOwnPoseStaysUntilAClipIsPlayed) {
    Document d = moving();
    d.json["nodes"][0]["translation"] = {7, 0, 0};
    EXPECT_EQ(origin_of(loaded_or_fail(d).scene).x, 7.0F);
    EXPECT_EQ(origin_of(posed(d, 0.0)).x, 0.0F);
    scene::Scene back = posed(d, 2.0);
    EXPECT_EQ(origin_of(back).x, 4.0F);
    scene::take_pose(scene::pose_at(*back.rig, nullptr, 0.0), back);
    EXPECT_EQ(origin_of(back).x, 7.0F);
}

TEST(Animation, TimesBeyondTheClipAreItsEnds) {
    EXPECT_EQ(origin_of(posed(moving(), -3.0)).x, 0.0F);
    EXPECT_EQ(origin_of(posed(moving(), 30.0)).x, 4.0F);
}

TEST(Animation, IntegersAreNormalisedAndSparseValuesTakeTheirPlaces) {
    Document d = triangle();
    // 16-bit quaternion of a half turn around y: (0, 1, 0, 0).
    const auto turns = d.accessor<std::int16_t>("VEC4", 5122, 2, {0, 0, 0, 32767, 0, 32767, 0, 0});
    d.json["accessors"][turns]["normalized"] = true;
    animate(d, 0, 0, "rotation", times(d, {0, 1}), turns);
    const auto moves = d.floats("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, 0, 0});
    const std::size_t indices = d.view(std::string("\2\0", 2));
    const std::vector<float> last{6, 0, 0};
    const std::size_t values = d.view({reinterpret_cast<const char*>(last.data()), 12});
    d.json["accessors"][moves]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    animate(d, 0, 0, "translation", times(d, {0, 1, 2}), moves);
    const scene::Scene scene = posed(d, 1.0);
    expect_near(Vec3(scene.instances[0].world_from_object[0]), {-1, 0, 0}, 1e-4F);
    EXPECT_NEAR(origin_of(posed(d, 1.5)).x, 3.0F, 1e-5F);
}

TEST(Animation, SkinsFollowTheirJoints) {
    const scene::Scene still = posed(skinned(), 0.0);
    ASSERT_EQ(still.instances.size(), 1U);
    expect_near(still.meshes[0].positions_m[2], {0, 2, 0});
    const scene::Scene bent = posed(skinned(), 1.0);
    expect_near(bent.meshes[0].positions_m[0], {0, 0, 0});
    expect_near(bent.meshes[0].positions_m[2], {0, 1, 1});
    expect_near(bent.meshes[0].normals[2], {0, -1, 0});
    EXPECT_NEAR(bent.meshes[0].bounds_m.high.z, 1.0F, 1e-5F);
}

TEST(Animation, MorphTargetsCountAsTheirWeightsSay) {
    Document d = morphed();
    EXPECT_NEAR(loaded_or_fail(d).scene.meshes[0].positions_m[0].z, 0.5F, 1e-6F);
    const scene::Scene half = posed(d, 0.5);
    expect_near(half.meshes[0].positions_m[0], {0, 1, 1});
    // As 8-bit codes, of a cubic with level tangents: half way is the mean.
    const auto codes =
        d.accessor<std::uint8_t>("SCALAR", 5121, 12, {0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 0, 0});
    d.json["accessors"][codes]["normalized"] = true;
    animate(d, 1, 0, "weights", 0, codes, "CUBICSPLINE");
    d.json["animations"][1]["samplers"][0]["input"] =
        d.json["animations"][0]["samplers"][0]["input"];
    expect_near(posed(d, 0.5, "1").meshes[0].positions_m[0], {0, 2, 1});
}

// A scale that turns negative mirrors the mesh: its triangles stay counter-clockwise as placed.
TEST(Animation, AMeshThatIsMirroredOnItsWayKeepsItsFront) {
    Document d = triangle();
    animate(d, 0, 0, "scale", times(d, {0, 1}), d.floats("VEC3", 3, {1, 1, 1, -1, 1, 1}));
    for (const double time_s : {0.0, 0.5, 1.0}) {
        const scene::Scene scene = posed(d, time_s);
        if (time_s == 0.5) {
            EXPECT_TRUE(scene.instances.empty()) << "scaled to nothing";
            continue;
        }
        ASSERT_EQ(scene.instances.size(), 1U) << time_s;
        const scene::Mesh& mesh = scene.meshes[scene.instances[0].mesh.index];
        const auto corner = [&](std::size_t i) {
            const Vec3& p = mesh.positions_m[mesh.indices[i]];
            return Vec3(scene.instances[0].world_from_object * math::Vec4(p, 1.0F));
        };
        EXPECT_GT(math::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0.0F) << time_s;
    }
}

// Meshes that a pose makes are the model's: those of lights' shapes come after them.
TEST(Animation, ShapesOfLightsStayOneEachWhateverIsPosed) {
    Document d = triangle();
    animate(d, 0, 0, "scale", times(d, {0, 1}), d.floats("VEC3", 3, {1, 1, 1, -1, 1, 1}));
    scene::Scene scene = posed(d, 0.0);
    scene.lights.push_back({.kind = tables::LightKind::sphere, .is_visible = true});
    scene::place_light_shapes(scene);
    const std::size_t materials = scene.materials.size();
    for (const double time_s : {0.2, 0.8, 0.2, 0.8}) {
        scene::take_pose(scene::pose_at(*scene.rig, scene.rig->clips.data(), time_s), scene);
        EXPECT_EQ(scene.instances.size(), 1U) << "the model's alone";
        scene::place_light_shapes(scene);
        ASSERT_EQ(scene.instances.size(), 2U) << time_s;
        EXPECT_EQ(scene.instances[1].light, 0U);
        EXPECT_EQ(scene.instances[1].mesh.index + 1, scene.meshes.size());
        EXPECT_LE(scene.meshes.size(), 3U) << "the triangle, its mirror image, the ball";
        EXPECT_EQ(scene.materials.size(), materials);
    }
}

TEST(Animation, WhatIsScaledToNothingAtFirstAppearsLater) {
    Document d = triangle();
    d.json["nodes"][0]["scale"] = {0, 0, 0};
    animate(d, 0, 0, "scale", times(d, {0, 1}), d.floats("VEC3", 3, {0, 0, 0, 2, 2, 2}));
    EXPECT_TRUE(loaded_or_fail(d).scene.instances.empty());
    EXPECT_EQ(posed(d, 1.0).instances.size(), 1U);
}

TEST(Animation, CamerasAndLightsMoveWithTheirNodes) {
    Document d = moving();
    d.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
    d.json["extensionsUsed"] = {"KHR_lights_punctual"};
    d.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", Json::object()}}};
    d.json["nodes"][0] = {
        {"mesh", 0}, {"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
    const auto turned = d.floats("VEC4", 4, {0, 0, 0, 1, 0, 1, 0, 0});
    animate(d, 0, 0, "rotation", times(d, {0, 1}), turned);
    const scene::Scene scene = posed(d, 1.0);
    expect_near(Vec3(scene.cameras[0].world_from_view[3]), {2, 0, 0});
    expect_near(Vec3(scene.cameras[0].world_from_view[2]), {0, 0, -1});
    expect_near(scene.lights[0].position_m, {2, 0, 0});
    expect_near(scene.lights[0].direction, {0, 0, 1});
}

TEST(Animation, IsFoundByNameByIndexAndElseListed) {
    Document d = moving();
    d.json["animations"][0]["name"] = "Walk";
    animate(d, 1, 0, "translation", times(d, {0, 1}), d.floats("VEC3", 3, {0, 0, 0, 0, 9, 0}));
    d.json["animations"][1]["name"] = "Jump";
    EXPECT_EQ(origin_of(posed(d, 1.0)).x, 2.0F);
    EXPECT_EQ(origin_of(posed(d, 1.0, "Jump")).y, 9.0F);
    EXPECT_EQ(origin_of(posed(d, 1.0, "1")).y, 9.0F);
    const scene::Scene scene = loaded_or_fail(d).scene;
    for (const char* const name : {"Run", "2", "-1"}) {
        const auto none = scene::find_clip(scene, name);
        ASSERT_FALSE(none) << name;
        EXPECT_EQ(none.error().code, base::ErrorCode::usage);
        EXPECT_EQ(none.error().remedy, "one of Walk, Jump, or its index, 0 to 1");
    }
    const auto still = loaded_or_fail(triangle());
    EXPECT_EQ(scene::find_clip(still.scene, "").value(), nullptr);
    EXPECT_FALSE(scene::find_clip(still.scene, "Walk"));
}

/// What is wrong with the document's clip; the file itself loads, with a warning of the same place.
base::Error fault_of(const Document& d) {
    const auto loaded = load_document(d);
    EXPECT_TRUE(loaded) << base::to_line(loaded.error());
    if (!loaded) return {};
    const auto clip = scene::find_clip(loaded->scene, "");
    EXPECT_FALSE(clip) << "is played";
    if (clip) return {};
    const auto is_same = [&](const base::Warning& w) { return w.where == clip.error().where; };
    EXPECT_TRUE(std::any_of(loaded->warnings.begin(), loaded->warnings.end(), is_same))
        << "no warning of " << clip.error().where;
    return clip.error();
}

struct BadClip {
    const char* name;
    std::function<void(Document&)> break_it;
    const char* where;
};

// faults.md, G27.
TEST(Animation, AFaultIsAWarningUntilTheAnimationIsAskedFor) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto resample = [](Document& d, const char* key, std::size_t accessor) {
        d.json["animations"][0]["samplers"][0][key] = accessor;
    };
    const std::vector<BadClip> clips{
        {"times fall",
         [&](Document& d) {
             resample(d, "input", times(d, {1, 0}));
         },
         "/animations/0/samplers/0/input"},
        {"times stay",
         [&](Document& d) {
             resample(d, "input", times(d, {1, 1}));
         },
         "/animations/0/samplers/0/input"},
        {"time is NaN",
         [&](Document& d) {
             resample(d, "input", d.floats("SCALAR", 1, {0, nan}));
         },
         "/animations/0/samplers/0/input"},
        {"value is NaN",
         [&](Document& d) {
             resample(d, "output", d.floats("VEC3", 3, {0, 0, nan, 0, 0, 0}));
         },
         "/animations/0/samplers/0/output"},
        {"too many values",
         [&](Document& d) {
             resample(d, "output", d.floats("VEC3", 3, {0, 0, 0, 0, 0, 0, 1, 1, 1}));
         },
         "/animations/0/channels/0/sampler"},
        {"cubic without tangents",
         [](Document& d) {
             d.json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
         },
         "/animations/0/channels/0/sampler"},
        {"unknown interpolation",
         [](Document& d) { d.json["animations"][0]["samplers"][0]["interpolation"] = "BEZIER"; },
         "/animations/0/samplers/0/interpolation"},
        {"unknown path",
         [](Document& d) { d.json["animations"][0]["channels"][0]["target"]["path"] = "color"; },
         "/animations/0/channels/0/target/path"},
        {"no such node",
         [](Document& d) { d.json["animations"][0]["channels"][0]["target"]["node"] = 7; },
         "/animations/0/channels/0/target/node"},
        {"no such sampler",
         [](Document& d) { d.json["animations"][0]["channels"][0]["sampler"] = 3; },
         "/animations/0/channels/0/sampler"},
        {"a node with a matrix",
         [](Document& d) {
             d.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1};
         },
         "/animations/0/channels/0/target"}};
    for (const BadClip& clip : clips) {
        SCOPED_TRACE(clip.name);
        Document d = moving();
        clip.break_it(d);
        const base::Error fault = fault_of(d);
        EXPECT_EQ(fault.code, base::ErrorCode::input_invalid);
        EXPECT_EQ(fault.where, clip.where) << base::to_line(fault);
    }
}

TEST(Animation, AFaultOfOneClipLeavesTheOthers) {
    Document d = moving();
    animate(d, 1, 0, "translation", times(d, {1, 0}), d.floats("VEC3", 3, {0, 0, 0, 0, 9, 0}));
    EXPECT_EQ(origin_of(posed(d, 1.0)).x, 2.0F);
    EXPECT_FALSE(scene::find_clip(loaded_or_fail(d).scene, "1"));
}

TEST(Animation, ChannelsOfPointersAndWithoutNodesAreLeftOut) {
    Document d = moving();
    d.json["animations"][0]["channels"].push_back(
        {{"sampler", 0}, {"target", {{"path", "scale"}}}});
    d.json["extensionsUsed"] = {"KHR_animation_pointer"};
    d.json["animations"][0]["channels"].push_back(
        {{"sampler", 0},
         {"target",
          {{"path", "pointer"},
           {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/0/translation"}}}}}}}});
    EXPECT_EQ(origin_of(posed(d, 1.0)).x, 2.0F);
}

TEST(Animation, WeightsOfAMeshWithoutTargetsAreLeftOut) {
    Document d = moving();
    animate(d, 0, 0, "weights", times(d, {0, 2}), d.floats("SCALAR", 1, {0, 1, 0, 1, 0, 1}));
    EXPECT_EQ(origin_of(posed(d, 1.0)).x, 2.0F);
    const scene::Scene scene = loaded_or_fail(d).scene;
    EXPECT_TRUE(scene::pose_at(*scene.rig, &scene.rig->clips[0], 1.0).weights.empty());
}

TEST(Animation, AnInverseBindMatrixThatIsNoNumberIsRefused) {
    Document d = skinned();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> bind(32, 0.0F);
    bind[21] = nan;
    d.json["skins"][0]["inverseBindMatrices"] = d.floats("MAT4", 16, bind);
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, base::ErrorCode::input_invalid);
    EXPECT_EQ(loaded.error().where, "/skins/0/inverseBindMatrices");
}

TEST(Animation, WhatJointsTakeBeyondAllNumbersIsNotDrawn) {
    Document d = skinned();
    animate(d, 0, 2, "translation", times(d, {0, 1}),
            d.floats("VEC3", 3, {0, 0, 0, 3e38F, 3e38F, 3e38F}));
    animate(d, 0, 1, "scale", times(d, {0, 1}), d.floats("VEC3", 3, {1, 1, 1, 9, 9, 9}));
    const scene::Scene scene = posed(d, 1.0);
    EXPECT_TRUE(scene.instances.empty() || scene.meshes[0].indices.empty());
}

TEST(Animation, SamplersThatShareAccessorsWithoutEndMeetTheLimit) {
    Document d = moving();
    const auto input = times(d, {0, 1});
    const auto output = d.floats("VEC3", 3, {0, 0, 0, 0, 0, 0});
    for (int i = 0; i < 2000; ++i) animate(d, 0, 0, "scale", input, output);
    base::Limits limits;
    limits.memory_bytes = 20000;
    const auto loaded = load_document(d, {}, limits);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_FALSE(scene::find_clip(loaded->scene, ""));
}

}  // namespace
}  // namespace facet::test
