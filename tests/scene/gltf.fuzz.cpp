// The glTF importer on mutated files: whatever comes, it answers and nothing breaks.
// SPDX-License-Identifier: MIT
#include "scene/gltf/gltf.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

/// A document that touches most of the importer: skin, morph, sparse, image, light, camera,
/// extensions.
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
    const std::size_t indices = d.view(std::string("\1\0\2\0", 4));
    const std::vector<float> moved{1, 0, 0, 0, 1, 0};
    const std::size_t values = d.view({reinterpret_cast<const char*>(moved.data()), 24});
    d.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    return d;
}

std::size_t rounds() {
    const char* const asked = std::getenv("FACET_FUZZ_ROUNDS");
    return asked != nullptr ? static_cast<std::size_t>(std::strtoull(asked, nullptr, 10)) : 6000;
}

void feed(const std::string& text) {
    base::Limits limits;
    limits.memory_bytes = std::size_t{64} << 20;
    const auto loaded = load_text(text, {}, limits);
    if (!loaded) {
        const int code = base::exit_code(loaded.error().code);
        ASSERT_TRUE(code >= 3 && code <= 5) << base::to_line(loaded.error());
    }
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    const auto findings =
        scene::gltf::check_bytes(base::Bytes(first, first + text.size()),
                                 {.label = "fuzz", .folder = {}, .allowed_folders = {}}, limits);
    ASSERT_LE(findings.size(), 10'000U);
}

std::string mutated(std::string text, std::mt19937& random) {
    const auto pick = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
    for (std::size_t n = 1 + pick(4); n > 0 && text.size() > 4; --n) {
        const std::size_t at = pick(text.size());
        switch (pick(5)) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
                break;
            case 2:
                text.erase(at, 1 + pick(8));
                break;
            case 3:
                text.insert(at, text.substr(pick(text.size()), 1 + pick(16)));
                break;
            default:
                text[at] = "0123456789-{}[],"[pick(16)];
                break;
        }
    }
    return text;
}

TEST(GltfFuzz, the_seed_itself_is_sound) {
    const auto loaded = load_document(rich());
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_EQ(loaded->scene.triangle_count(), 1U);
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

/// Every number of a document in turn replaced by ones that break things.
void replace_numbers(const Json& whole, Json& at, const Json& bad, std::size_t& left) {
    if (left == 0) return;
    if (at.is_structured()) {
        for (Json& child : at) replace_numbers(whole, child, bad, left);
        return;
    }
    if (!at.is_number()) return;
    --left;
    const Json kept = std::exchange(at, bad);
    feed(whole.dump());
    at = kept;
}

TEST(GltfFuzz, every_number_replaced_by_a_hostile_one_never_does_more_than_fail) {
    for (const Json& bad :
         {Json(-1), Json(0), Json(2147483647), Json(4294967295U), Json(18446744073709551615U),
          Json(1e300), Json(0.5), Json("x"), Json(nullptr), Json::array(), Json::object()}) {
        Json json = rich().finished();
        std::size_t left = 400;
        replace_numbers(json, json, bad, left);
        if (HasFatalFailure()) return;
    }
}

TEST(GltfFuzz, every_cut_of_a_glb_never_does_more_than_fail) {
    const std::string glb = rich().glb();
    for (std::size_t size = 0; size < glb.size(); size += 3) feed(glb.substr(0, size));
}

}  // namespace
}  // namespace facet::test
