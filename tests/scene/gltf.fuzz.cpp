// The glTF importer on mutated files: whatever comes, it answers and nothing breaks.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "animation_fixture.h"
#include "gltf_mutation.h"

namespace facet::test {
namespace {

/// A document that touches most of the importer: skin, morph, sparse, animation, image, light,
/// camera, extensions.
Document rich() {
    Document d = triangle();
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["JOINTS_0"] =
        d.accessor<std::uint8_t>("VEC4", 5121, 3, std::vector<std::uint8_t>(12, 0));
    primitive(d)["attributes"]["WEIGHTS_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    primitive(d)["targets"] = {{{"POSITION", d.positions({0, 0, 1, 0, 0, 1, 0, 0, 1})}}};
    primitive(d)["material"] = 0;
    d.json["meshes"][0]["weights"] = {0.5};
    d.json["images"] = {
        {{"bufferView", d.view("\x89PNG\r\n\x1A\n0000IHDR")}, {"mimeType", "image/png"}}};
    d.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    d.json["samplers"] = {{{"wrapS", 33071}}};
    d.json["materials"] = {
        {{"normalTexture", {{"index", 0}}},
         {"alphaMode", "MASK"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 0.5, 0, 1}}}}}};
    d.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
    d.json["extensionsUsed"] = {"KHR_lights_punctual"};
    d.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", Json::object()}}};
    d.json["nodes"] = {{{"mesh", 0}, {"skin", 0}},
                       {{"children", {2, 3}}, {"rotation", {0, 0, 0, 1}}},
                       {{"camera", 0}, {"scale", {1, -1, 1}}},
                       {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    d.json["skins"] = {{{"joints", {1, 2}}}};
    const std::size_t input = times(d, {0, 1});
    const std::size_t moves = d.floats("VEC3", 3, {0, 0, 0, 1, 0, 0});
    animate(d, 0, 1, "translation", input, moves);
    animate(d, 0, 3, "scale", input, moves, "STEP");
    animate(d, 0, 2, "rotation", input, d.floats("VEC4", 4, {0, 0, 0, 1, 0, 1, 0, 0}));
    animate(d, 0, 0, "weights", input, d.floats("SCALAR", 1, {0, 0, 0, 0, 1, 0}), "CUBICSPLINE");
    const std::size_t indices = d.view(std::string("\1\0\2\0", 4));
    const std::vector<float> moved{1, 0, 0, 0, 1, 0};
    const std::size_t values = d.view({reinterpret_cast<const char*>(moved.data()), 24});
    d.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    return d;
}

TEST(GltfFuzz, the_seed_itself_is_sound) {
    const auto loaded = load_document(rich());
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_EQ(loaded->scene.triangle_count(), 1U);
    EXPECT_FALSE(scene::find_clip(loaded->scene, "").value()->channels.empty());
}

TEST(GltfFuzz, mutated_glb_and_text_never_do_more_than_fail) {
    const std::string glb = rich().glb();
    const std::string text = rich().text();
    std::mt19937 random(20240501);
    for (std::size_t i = 0; i < rounds(); ++i) {
        SCOPED_TRACE(i);
        feed(mutated(i % 2 == 0 ? glb : text, random));
        if (HasFatalFailure()) return;
    }
}

TEST(GltfFuzz, every_number_replaced_by_a_hostile_one_never_does_more_than_fail) {
    feed_hostile_numbers(rich().finished());
}

TEST(GltfFuzz, every_cut_of_a_glb_never_does_more_than_fail) {
    const std::string glb = rich().glb();
    for (std::size_t size = 0; size < glb.size(); size += 3) feed(glb.substr(0, size));
}

}  // namespace
}  // namespace facet::test
