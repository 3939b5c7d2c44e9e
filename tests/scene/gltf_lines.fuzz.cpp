// Points and lines, mutated: whatever their indices and counts, loading answers and nothing breaks.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "gltf_mutation.h"

namespace facet::test {
namespace {

/// One primitive of each mode, with all that a body's vertices take from theirs.
Document thin_primitives() {
    Document d = triangle();
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["COLOR_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1});
    primitive(d)["attributes"]["JOINTS_0"] =
        d.accessor<std::uint8_t>("VEC4", 5121, 3, std::vector<std::uint8_t>(12, 0));
    primitive(d)["attributes"]["WEIGHTS_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    Json plain = primitive(d);
    plain["attributes"].erase("NORMAL");
    for (const int mode : {0, 1, 2, 3}) {
        plain["mode"] = mode;
        d.json["meshes"][0]["primitives"].push_back(plain);
    }
    primitive(d)["mode"] = 2;
    d.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"scale", {2, -1, 1}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    d.json["skins"] = {{{"joints", {1}}}};
    return d;
}

TEST(GltfLinesFuzz, mutated_files_never_do_more_than_fail) {
    ASSERT_TRUE(load_document(thin_primitives()));
    const std::string glb = thin_primitives().glb();
    std::mt19937 random(20240604);
    for (std::size_t i = 0; i < rounds() / 3; ++i) {
        SCOPED_TRACE(i);
        feed(mutated(glb, random));
        if (HasFatalFailure()) return;
    }
}

TEST(GltfLinesFuzz, hostile_numbers_never_do_more_than_fail) {
    feed_hostile_numbers(thin_primitives().finished());
}

}  // namespace
}  // namespace facet::test
