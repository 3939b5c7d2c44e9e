// The glTF importer on broken files: each fault its exit code, its place and its own words.
// SPDX-License-Identifier: MIT
#include "gltf_faults.h"

#include <gtest/gtest.h>

#include <limits>

namespace facet::test {
namespace {

TEST(GltfFaults, every_index_that_leads_nowhere_is_an_error_at_its_place) {
    const std::vector<Fault> faults{
        {"material beyond", [](Document& d) { primitive(d)["material"] = 12; }, invalid,
         "/meshes/0/primitives/0/material"},
        {"material negative", [](Document& d) { primitive(d)["material"] = -1; }, invalid,
         "/meshes/0/primitives/0/material"},
        {"material a string", [](Document& d) { primitive(d)["material"] = "0"; }, invalid,
         "/meshes/0/primitives/0/material"},
        {"material a fraction", [](Document& d) { primitive(d)["material"] = 0.5; }, invalid,
         "/meshes/0/primitives/0/material"},
        {"material huge", [](Document& d) { primitive(d)["material"] = 4294967296; }, invalid,
         "/meshes/0/primitives/0/material"},
        {"attribute", [](Document& d) { primitive(d)["attributes"]["POSITION"] = 9; }, invalid,
         "/meshes/0/primitives/0/attributes/POSITION"},
        {"indices", [](Document& d) { primitive(d)["indices"] = 9; }, invalid,
         "/meshes/0/primitives/0/indices"},
        {"mesh", [](Document& d) { d.json["nodes"][0]["mesh"] = 1; }, invalid, "/nodes/0/mesh"},
        {"camera", [](Document& d) { d.json["nodes"][0]["camera"] = 0; }, invalid,
         "/nodes/0/camera"},
        {"skin", [](Document& d) { d.json["nodes"][0]["skin"] = 3; }, invalid, "/nodes/0/skin"},
        {"child", [](Document& d) { d.json["nodes"][0]["children"] = {5}; }, invalid,
         "/nodes/0/children/0"},
        {"scene root", [](Document& d) { d.json["scenes"][0]["nodes"] = {4}; }, invalid,
         "/scenes/0/nodes/0"},
        {"default scene", [](Document& d) { d.json["scene"] = 1; }, invalid, "/scene"},
        {"view of an accessor", [](Document& d) { d.json["accessors"][0]["bufferView"] = 77; },
         invalid, "/accessors/0/bufferView"},
        {"buffer of a view", [](Document& d) { d.json["bufferViews"][0]["buffer"] = 1; }, invalid,
         "/bufferViews/0/buffer"},
        {"texture source",
         [](Document& d) {
             d.json["textures"] = {{{"source", 0}}};
         },
         invalid, "/textures/0/source"},
        {"sampler",
         [](Document& d) {
             d.json["textures"] = {{{"sampler", 2}}};
         },
         invalid, "/textures/0/sampler"},
        {"texture",
         [](Document& d) {
             d.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
         },
         invalid, "/materials/0/normalTexture/index"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

TEST(GltfFaults, the_message_says_what_was_found_and_how_many_there_are) {
    Document d = triangle();
    d.json["materials"] = {Json::object(), Json::object(), Json::object()};
    primitive(d)["material"] = 12;
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().found, "12, but there are 3");
}

TEST(GltfFaults, ranges_that_leave_their_buffer_are_errors_however_they_wrap) {
    const std::vector<Fault> faults{
        {"view too long", [](Document& d) { d.json["bufferViews"][0]["byteLength"] = 1000; },
         invalid, "/bufferViews/0/byteLength"},
        {"offset beyond", [](Document& d) { d.json["bufferViews"][0]["byteOffset"] = 1 << 20; },
         invalid, "/bufferViews/0/byteOffset"},
        {"offset near 2^53",
         [](Document& d) { d.json["bufferViews"][0]["byteOffset"] = 9007199254740988; }, invalid,
         "/bufferViews/0/byteOffset"},
        {"offset near 2^64",
         [](Document& d) {
             d.json["bufferViews"][0]["byteOffset"] = std::numeric_limits<std::uint64_t>::max();
         },
         invalid, "/bufferViews/0/byteOffset"},
        {"negative offset", [](Document& d) { d.json["bufferViews"][0]["byteOffset"] = -4; },
         invalid, "/bufferViews/0/byteOffset"},
        {"accessor too long", [](Document& d) { d.json["accessors"][0]["count"] = 4; }, invalid,
         "/accessors/0"},
        {"accessor offset", [](Document& d) { d.json["accessors"][0]["byteOffset"] = 4; }, invalid,
         "/accessors/0/byteOffset"},
        {"count 10^18", [](Document& d) { d.json["accessors"][0]["count"] = 1000000000000000000; },
         invalid, "/accessors/0/count"},
        {"count 10^15", [](Document& d) { d.json["accessors"][0]["count"] = 1000000000000000; },
         ErrorCode::limit_reached, "/accessors/0/count"},
        {"zeros of 10^9",
         [](Document& d) {
             d.json["accessors"][0].erase("bufferView");
             d.json["accessors"][0]["count"] = 1000000000;
         },
         ErrorCode::limit_reached, "/accessors/0/count"},
        {"count 0", [](Document& d) { d.json["accessors"][0]["count"] = 0; }, invalid,
         "/accessors/0/count"},
        {"misaligned",
         [](Document& d) {
             d.json["accessors"][0]["byteOffset"] = 1;
             d.json["accessors"][0]["count"] = 2;
         },
         invalid, "/accessors/0/byteOffset"},
        {"small stride", [](Document& d) { d.json["bufferViews"][0]["byteStride"] = 8; }, invalid,
         "/accessors/0"},
        {"odd stride", [](Document& d) { d.json["bufferViews"][0]["byteStride"] = 13; }, invalid,
         "/accessors/0"},
        {"unknown type", [](Document& d) { d.json["accessors"][0]["type"] = "VEC5"; }, invalid,
         "/accessors/0/type"},
        {"type wrong for positions",
         [](Document& d) {
             d.json["accessors"][0]["type"] = "VEC2";
             d.json["accessors"][0].erase("min");
             d.json["accessors"][0].erase("max");
         },
         invalid, "/meshes/0/primitives/0/attributes/POSITION"},
        {"float indices",
         [](Document& d) {
             primitive(d)["indices"] = d.floats("SCALAR", 1, {0, 1, 2});
         },
         invalid, "/meshes/0/primitives/0/indices"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

TEST(GltfFaults, buffers_with_less_than_they_promise_are_errors) {
    Document d = triangle();
    Json json = d.finished();
    json["buffers"][0]["byteLength"] = 1 << 20;
    const auto loaded = load_text(json.dump());
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where, "/buffers/0");
    json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAA*";
    const auto broken = load_text(json.dump());
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().where, "/buffers/0/uri");
}

TEST(GltfFaults, vertex_numbers_and_indices_are_checked_before_use) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Fault> faults{
        {"NaN position",
         [nan](Document& d) {
             primitive(d)["attributes"]["POSITION"] = d.positions({0, 0, 0, nan, 0, 0, 0, 1, 0});
         },
         invalid, "/meshes/0/primitives/0/attributes/POSITION"},
        {"index beyond",
         [](Document& d) {
             primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 3, {0, 1, 3});
         },
         invalid, "/meshes/0/primitives/0/indices"},
        {"restart value",
         [](Document& d) {
             primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 3, {0, 1, 65535});
         },
         invalid, "/meshes/0/primitives/0/indices"},
        {"counts differ",
         [](Document& d) {
             primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0});
         },
         invalid, "/meshes/0/primitives/0/attributes/TEXCOORD_0"},
        {"joint beyond",
         [](Document& d) {
             primitive(d)["attributes"]["JOINTS_0"] =
                 d.accessor<std::uint8_t>("VEC4", 5121, 3, {0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0});
             primitive(d)["attributes"]["WEIGHTS_0"] =
                 d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
             d.json["nodes"][0]["skin"] = 0;
             d.json["skins"] = {{{"joints", {0}}}};
         },
         invalid, "/meshes/0/primitives/0/attributes/JOINTS_0"},
        {"morph of another count",
         [](Document& d) {
             primitive(d)["targets"] = {{{"POSITION", d.positions({0, 0, 0, 1, 1, 1})}}};
         },
         invalid, "/meshes/0/primitives/0/targets/0/POSITION"},
        {"weights of another count", [](Document& d) { d.json["meshes"][0]["weights"] = {0.5}; },
         invalid, "/meshes/0/weights"},
        {"no joints",
         [](Document& d) {
             d.json["skins"] = {{{"joints", Json::array()}}};
         },
         invalid, "/skins/0/joints"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

/// An accessor of three elements with sparse ones on top.
void add_sparse(Document& d, const std::vector<std::uint16_t>& indices, std::size_t count) {
    const std::size_t index_view =
        d.view({reinterpret_cast<const char*>(indices.data()), indices.size() * 2});
    const std::size_t value_view = d.view(std::string(12 * indices.size(), '\0'));
    d.json["accessors"][0]["sparse"] = {
        {"count", count},
        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
        {"values", {{"bufferView", value_view}}}};
}

TEST(GltfFaults, sparse_indices_must_increase_and_stay_within) {
    const std::vector<Fault> faults{
        {"twice",
         [](Document& d) {
             add_sparse(d, {1, 1}, 2);
         },
         invalid, "/accessors/0/sparse/indices"},
        {"falling",
         [](Document& d) {
             add_sparse(d, {2, 0}, 2);
         },
         invalid, "/accessors/0/sparse/indices"},
        {"beyond",
         [](Document& d) {
             add_sparse(d, {0, 3}, 2);
         },
         invalid, "/accessors/0/sparse/indices"},
        {"more than elements",
         [](Document& d) {
             add_sparse(d, {0, 1, 2, 3}, 4);
         },
         invalid, "/accessors/0/sparse/count"},
        {"beyond its view", [](Document& d) { add_sparse(d, {0}, 3); }, invalid,
         "/accessors/0/sparse/indices/byteOffset"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

TEST(GltfFaults, node_graphs_that_are_no_forest_are_errors) {
    const std::vector<Fault> faults{
        {"self", [](Document& d) { d.json["nodes"][0]["children"] = {0}; }, invalid, "/nodes/0"},
        {"cycle",
         [](Document& d) {
             d.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
         },
         invalid, "/nodes/1"},
        {"two parents",
         [](Document& d) {
             d.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
         },
         invalid, "/nodes/1/children/0"},
        {"child twice",
         [](Document& d) {
             d.json["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
         },
         invalid, "/nodes/0/children/1"},
        {"root that is a child",
         [](Document& d) {
             d.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
             d.json["scenes"][0]["nodes"] = {1};
         },
         invalid, "/scenes/0/nodes/0"},
        {"matrix and scale",
         [](Document& d) {
             d.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
             d.json["nodes"][0]["scale"] = {1, 1, 1};
         },
         invalid, "/nodes/0/matrix"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

}  // namespace
}  // namespace facet::test
