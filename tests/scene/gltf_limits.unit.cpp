// The glTF importer on broken files: containers, versions, limits, cameras and lights.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "gltf_faults.h"

namespace facet::test {
namespace {

TEST(GltfLimits, a_cycle_is_told_as_a_chain) {
    Document d = triangle();
    d.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().found, "1 -> 2 -> 1");
}

TEST(GltfLimits, nodes_nested_deeper_than_the_limit_are_refused_without_recursion) {
    Document d = triangle();
    constexpr int count = 100'000;
    d.json["nodes"] = Json::array();
    for (int i = 0; i + 1 < count; ++i) d.json["nodes"].push_back({{"children", {i + 1}}});
    d.json["nodes"].push_back({{"mesh", 0}});
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached) << base::to_line(loaded.error());
}

TEST(GltfLimits, cameras_and_lights_that_cannot_be_are_errors) {
    const auto camera = [](const Json& view) {
        return [view](Document& d) {
            d.json["cameras"] = {{{"type", "perspective"}, {"perspective", view}}};
        };
    };
    const auto light = [](const Json& one) {
        return [one](Document& d) {
            d.json["extensionsUsed"] = {"KHR_lights_punctual"};
            d.json["extensions"]["KHR_lights_punctual"]["lights"] = {one};
        };
    };
    const std::string lights = "/extensions/KHR_lights_punctual/lights/0";
    const std::vector<Fault> faults{
        {"yfov 0", camera({{"yfov", 0}, {"znear", 0.1}}), invalid, "/cameras/0/perspective/yfov"},
        {"znear 0", camera({{"yfov", 1}, {"znear", 0}}), invalid, "/cameras/0/perspective/znear"},
        {"zfar below znear", camera({{"yfov", 1}, {"znear", 2}, {"zfar", 1}}), invalid,
         "/cameras/0/perspective"},
        {"aspect 0", camera({{"yfov", 1}, {"znear", 1}, {"aspectRatio", 0}}), invalid,
         "/cameras/0/perspective/aspectRatio"},
        {"negative intensity", light({{"type", "point"}, {"intensity", -1}}), invalid,
         lights + "/intensity"},
        {"range 0", light({{"type", "point"}, {"range", 0}}), invalid, lights + "/range"},
        {"cones",
         light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.6}, {"outerConeAngle", 0.5}}}}),
         invalid, lights + "/spot/outerConeAngle"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

TEST(GltfLimits, versions_that_are_not_ours_are_refused) {
    const std::vector<Fault> faults{
        {"1.0", [](Document& d) { d.json["asset"]["version"] = "1.0"; }, ErrorCode::feature_missing,
         "/asset/version"},
        {"3.0", [](Document& d) { d.json["asset"]["version"] = "3.0"; }, ErrorCode::feature_missing,
         "/asset/version"},
        {"minVersion 2.1",
         [](Document& d) {
             d.json["asset"]["version"] = "2.1";
             d.json["asset"]["minVersion"] = "2.1";
         },
         invalid, "/asset/minVersion"},
        {"no version", [](Document& d) { d.json["asset"].erase("version"); }, invalid, "/asset"},
        {"no asset", [](Document& d) { d.json.erase("asset"); }, invalid, ""},
        {"nonsense", [](Document& d) { d.json["asset"]["version"] = "two"; }, invalid,
         "/asset/version"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

TEST(GltfLimits, required_extensions_that_are_missing_are_named_with_what_is_lost) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_texture_basisu"};
    d.json["extensionsRequired"] = {"KHR_texture_basisu"};
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::feature_missing);
    EXPECT_NE(loaded.error().found.find("KTX2"), std::string::npos);
    EXPECT_NE(loaded.error().remedy.find("--ignore-required KHR_texture_basisu"),
              std::string::npos);
    const auto ignored = load_document(d, {.ignored_required = {"KHR_texture_basisu"}});
    EXPECT_TRUE(ignored.has_value());
}

TEST(GltfLimits, extensions_used_and_not_known_are_one_warning_each) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"MSFT_texture_dds", "EXT_made_up"};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->warnings.size(), 2U);
}

TEST(GltfLimits, json_is_bounded_in_depth_values_and_keys) {
    const auto code_of = [](const std::string& text, const base::Limits& limits = {}) {
        const auto loaded = load_text(text, {}, limits);
        EXPECT_FALSE(loaded.has_value());
        return loaded ? ErrorCode::internal : loaded.error().code;
    };
    const std::string deep(400'000, '[');
    EXPECT_EQ(code_of("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep),
              ErrorCode::limit_reached);
    base::Limits few;
    few.json_values = 10;
    EXPECT_EQ(code_of(triangle().text(), few), ErrorCode::limit_reached);
    base::Limits small;
    small.json_string_bytes = 100;
    EXPECT_EQ(
        code_of("{\"asset\":{\"version\":\"2.0\",\"generator\":\"" + std::string(200, 'x') + "\"}}",
                small),
        ErrorCode::limit_reached);
    EXPECT_EQ(code_of("{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scene\":0}"),
              ErrorCode::input_invalid);
    EXPECT_EQ(code_of("{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}"),
              ErrorCode::input_invalid);
    EXPECT_EQ(code_of("{\"asset\":"), ErrorCode::input_invalid);
    EXPECT_EQ(code_of("[]"), ErrorCode::input_invalid);
    EXPECT_EQ(code_of(""), ErrorCode::input_invalid);
}

TEST(GltfLimits, a_syntax_error_is_told_with_its_line_and_column) {
    const auto loaded = load_text("{\n  \"asset\": {,\n}");
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where, "2:13") << base::to_line(loaded.error());
}

TEST(GltfLimits, files_that_are_something_else_are_told_what_they_seem_to_be) {
    const auto found = [](const std::string& text) {
        const auto loaded = load_text(text);
        return loaded ? std::string() : loaded.error().found + loaded.error().remedy;
    };
    EXPECT_NE(found("version https://git-lfs.github.com/spec/v1\n").find("git lfs pull"),
              std::string::npos);
    EXPECT_NE(found("\x89PNG\r\n").find("PNG"), std::string::npos);
    EXPECT_NE(found("<html>").find("HTML"), std::string::npos);
    EXPECT_NE(found("").find("empty"), std::string::npos);
}

TEST(GltfLimits, a_glb_with_a_broken_container_is_told_the_field) {
    const std::string good = triangle().glb();
    const auto where_of = [&](std::size_t at, unsigned char value) {
        std::string bad = good;
        bad[at] = static_cast<char>(value);
        const auto loaded = load_text(bad);
        return loaded ? std::string("loads") : loaded.error().where;
    };
    EXPECT_EQ(where_of(4, 1), "@0x4");      // version
    EXPECT_EQ(where_of(10, 1), "@0x8");     // length of the whole
    EXPECT_EQ(where_of(14, 0x7F), "@0xc");  // length of the JSON chunk
    EXPECT_EQ(where_of(16, 'X'), "@0xc");   // type of the JSON chunk
    for (const std::size_t size :
         {std::size_t{4}, std::size_t{12}, std::size_t{19}, good.size() - 1, good.size() - 30})
        EXPECT_FALSE(load_text(good.substr(0, size)).has_value()) << size;
    const auto longer = load_text(good + "tail");
    ASSERT_TRUE(longer.has_value());
    EXPECT_EQ(longer->warnings.size(), 1U);
}

TEST(GltfLimits, memory_is_counted_before_it_is_taken_also_for_primitives_that_share) {
    Document d = triangle();
    for (int i = 0; i < 2000; ++i) d.json["meshes"][0]["primitives"].push_back(primitive(d));
    base::Limits limits;
    limits.memory_bytes = 100'000;
    const auto loaded = load_document(d, {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached);
    EXPECT_TRUE(load_document(d).has_value());
}

TEST(GltfLimits, names_are_counted_as_often_as_copies_keep_them) {
    Document d = triangle();
    d.json["accessors"].push_back({{"componentType", 5126}, {"count", 5000}, {"type", "VEC3"}});
    d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        d.json["accessors"].size() - 1;
    d.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    base::Limits limits;
    limits.memory_bytes = 10'000'000;
    EXPECT_TRUE(load_document(d, {}, limits).has_value());
    d.json["nodes"][0]["name"] = std::string(10'000, 'x');
    const auto loaded = load_document(d, {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached);
}

TEST(GltfLimits, flat_faces_are_counted_with_their_own_vertices) {
    Document d = triangle();
    std::vector<std::uint8_t> indices(30'000);
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint8_t>(i % 3);
    primitive(d)["indices"] = d.accessor<std::uint8_t>("SCALAR", 5121, indices.size(), indices);
    base::Limits limits;
    limits.memory_bytes = 1'500'000;
    const auto loaded = load_document(d, {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached);
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    EXPECT_TRUE(load_document(d, {}, limits).has_value());
}

TEST(GltfLimits, an_error_after_all_problems_that_are_kept_is_still_one) {
    Document d = triangle();
    // Each lacks its channels and samplers, which is wrong in animations alone.
    for (int i = 0; i < 6000; ++i) d.json["animations"].push_back(Json::object());
    EXPECT_TRUE(load_document(d).has_value());
    for (const Json& skin : {Json::object(), Json{{"joints", {999'999}}}}) {
        d.json["skins"] = {skin};
        const auto loaded = load_document(d);
        ASSERT_FALSE(loaded) << skin;
        EXPECT_EQ(loaded.error().code, ErrorCode::input_invalid);
        EXPECT_TRUE(loaded.error().where.starts_with("/skins/0")) << loaded.error().where;
    }
}

TEST(GltfLimits, more_lights_than_the_limit_are_refused) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_lights_punctual"};
    d.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    for (int i = 1; i <= 1001; ++i) {
        d.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        d.json["scenes"][0]["nodes"].push_back(i);
    }
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached);
}

TEST(GltfLimits, what_is_wrong_in_animations_is_a_warning_as_none_is_played) {
    Document d = triangle();
    d.json["animations"] = {{{"samplers", {{{"input", 0}, {"output", 0}}}},
                             {"channels", {{{"sampler", 5}, {"target", {{"path", "dance"}}}}}}}};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_FALSE(loaded->warnings.empty());
}

}  // namespace
}  // namespace facet::test
