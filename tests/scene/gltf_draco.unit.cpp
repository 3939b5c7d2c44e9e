// KHR_draco_mesh_compression: what the encoder packed is what loads, and every disagreement with
// the accessors is told at its place.
// SPDX-License-Identifier: MIT
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gltf_faults.h"
#ifdef FACET_HAS_DRACO
#include "gltf_draco.h"
#endif

namespace facet::test {
namespace {

#ifdef FACET_HAS_DRACO

using math::Vec2;
using math::Vec3;
using math::Vec4;

const std::string draco_where = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

/// Whether some triangle of the mesh has these corners, in this order round.
bool has_triangle(const scene::Mesh& mesh, const std::array<float, 3>* corners, float tolerance) {
    const auto is_near = [&](std::size_t index, std::size_t k) {
        return math::length(mesh.positions_m[mesh.indices[index]] -
                            Vec3(corners[k][0], corners[k][1], corners[k][2])) <= tolerance;
    };
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
        for (std::size_t turn = 0; turn < 3; ++turn)
            if (is_near(first, turn) && is_near(first + 1, (turn + 1) % 3) &&
                is_near(first + 2, (turn + 2) % 3))
                return true;
    return false;
}

void expect_draco_sheet(const scene::Loaded& loaded, float tolerance = 0.0F) {
    ASSERT_EQ(loaded.scene.meshes.size(), 1U);
    const scene::Mesh& mesh = loaded.scene.meshes[0];
    const auto corners = draco_corners();
    ASSERT_EQ(mesh.indices.size(), corners.size());
    for (std::size_t i = 0; i < corners.size(); i += 3)
        EXPECT_TRUE(has_triangle(mesh, &corners[i], tolerance)) << i / 3;
    ASSERT_EQ(mesh.uv0.size(), mesh.positions_m.size());
    for (std::size_t v = 0; v < mesh.positions_m.size(); ++v) {
        const Vec3 p = mesh.positions_m[v];
        const Vec2 lower(p.x * 0.125F, p.y * 0.125F);
        const Vec2 uv = mesh.uv0[v];
        const float off = std::min(math::length(Vec3(uv - lower, 0.0F)),
                                   math::length(Vec3(uv - lower - Vec2(0.0F, 0.25F), 0.0F)));
        EXPECT_LE(off, tolerance) << v;
        EXPECT_EQ(mesh.colors[v], Vec4(1, 0, 0, 1));
    }
}

TEST(Draco, both_methods_load_as_they_were_before_packing) {
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
        for (const bool is_glb : {false, true}) {
            SCOPED_TRACE(method);
            const Document d = draco_document(method);
            const auto loaded = load_text(is_glb ? d.glb() : d.text());
            ASSERT_TRUE(loaded) << base::to_line(loaded.error());
            EXPECT_TRUE(loaded->warnings.empty());
            expect_draco_sheet(*loaded);
        }
}

TEST(Draco, quantised_positions_are_as_near_as_their_bits) {
    // The sheet is 4 wide: 14 bits of that, half a step off in each part.
    const float step = 4.0F / 16383.0F;
    expect_draco_sheet(loaded_or_fail(draco_document(draco::MESH_EDGEBREAKER_ENCODING, 14)), step);
}

/// The triangles of its stream as a strip's.
Document draco_strip() {
    Document d = draco_document();
    primitive(d)["mode"] = 5;
    d.json["accessors"][3]["count"] = 50;  // of the strip that the triangles would make
    return d;
}

TEST(Draco, of_a_strip_the_triangles_are_drawn) {
    expect_draco_sheet(loaded_or_fail(draco_strip()));
}

TEST(Draco, two_uses_of_a_strip_draw_the_same_triangles) {
    Document d = draco_strip();
    d.json["meshes"].push_back(d.json["meshes"][0]);
    d.json["nodes"].push_back({{"mesh", 1}});
    d.json["scenes"][0]["nodes"] = {0, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.meshes.size(), 2U);
    EXPECT_EQ(loaded.scene.meshes[0].indices, loaded.scene.meshes[1].indices);
}

TEST(Draco, two_uses_of_one_stream_are_two_meshes_alike) {
    Document d = draco_document();
    d.json["meshes"].push_back(d.json["meshes"][0]);
    d.json["nodes"].push_back({{"mesh", 1}});
    d.json["scenes"][0]["nodes"] = {0, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.triangle_count(), 2 * draco_corners().size() / 3);
}

TEST(Draco, an_attribute_beside_the_stream_is_read_as_usual) {
    Document d = draco_document();
    const std::size_t count = d.json["accessors"][0]["count"];
    std::vector<float> uv;
    for (std::size_t i = 0; i < count; ++i) uv.insert(uv.end(), {0.5F, 0.25F});
    primitive(d)["attributes"]["TEXCOORD_1"] = d.floats("VEC2", 2, uv);
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.meshes.size(), 1U);
    EXPECT_EQ(loaded.scene.meshes[0].uv1.at(7), Vec2(0.5F, 0.25F));
}

TEST(Draco, plain_data_beside_a_stream_of_an_older_version_is_used_with_a_warning) {
    Document d = triangle();
    Document packed = draco_document();
    const std::size_t view = d.view(packed.bytes);
    d.bytes[d.json["bufferViews"][view]["byteOffset"].get<std::size_t>() + 6] = 1;  // 2.1
    primitive(d)["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                                {"attributes", {{"POSITION", 0}}}};
    d.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.triangle_count(), 1U);
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_EQ(loaded.warnings[0].found, "the plain data beside it is used");
}

/// A change that breaks the document, and where that is told below the extension's object.
struct DracoFault {
    const char* name;
    std::function<void(Document&)> break_it;
    const char* where;
    ErrorCode code = invalid;
};

TEST(Draco, every_fault_of_a_stream_is_told_at_its_place) {
    const auto count = [](std::size_t accessor, int by) {
        return [=](Document& d) {
            Json& at = d.json["accessors"][accessor]["count"];
            at = at.get<int>() + by;
        };
    };
    const auto all_counts = [](int by) {
        return [=](Document& d) {
            for (std::size_t i = 0; i < 3; ++i)
                d.json["accessors"][i]["count"] = d.json["accessors"][i]["count"].get<int>() + by;
        };
    };
    const std::vector<DracoFault> faults{
        {"cut off",
         [](Document& d) {
             Json& length = d.json["bufferViews"][0]["byteLength"];
             length = length.get<int>() / 2;
         },
         ""},
        {"cut within its header", [](Document& d) { d.json["bufferViews"][0]["byteLength"] = 8; },
         ""},
        {"no Draco", [](Document& d) { d.bytes[0] = 'X'; }, ""},
        {"older", [](Document& d) { d.bytes[6] = 1; }, "", ErrorCode::feature_missing},
        {"points", [](Document& d) { d.bytes[7] = 0; }, ""},
        {"method", [](Document& d) { d.bytes[8] = 9; }, ""},
        {"an index more", count(3, 3), ""},
        {"an index less", count(3, -3), ""},
        {"no whole triangles", count(3, 1), ""},
        {"vertices more", all_counts(1), ""},
        {"vertices less", all_counts(-1), ""},
        {"few vertices", all_counts(-20), ""},
        {"a strip too short",
         [](Document& d) {
             primitive(d)["mode"] = 5;
             d.json["accessors"][3]["count"] = 20;
         },
         ""},
        {"lines", [](Document& d) { primitive(d)["mode"] = 1; }, ""},
        {"no indices", [](Document& d) { primitive(d).erase("indices"); }, ""},
        {"view beyond", [](Document& d) { draco_use(d)["bufferView"] = 4; }, "/bufferView"},
        {"view missing", [](Document& d) { draco_use(d).erase("bufferView"); }, ""},
        {"attributes no object", [](Document& d) { draco_use(d)["attributes"] = 3; },
         "/attributes"},
        {"id unknown", [](Document& d) { draco_use(d)["attributes"]["POSITION"] = 77; },
         "/attributes/POSITION"},
        {"id negative", [](Document& d) { draco_use(d)["attributes"]["POSITION"] = -1; },
         "/attributes/POSITION"},
        {"id beyond 2^32", [](Document& d) { draco_use(d)["attributes"]["POSITION"] = 4294967296; },
         "/attributes/POSITION"},
        {"not the primitive's", [](Document& d) { draco_use(d)["attributes"]["NORMAL"] = 1; },
         "/attributes/NORMAL"},
        {"other components", [](Document& d) { draco_use(d)["attributes"]["POSITION"] = 1; },
         "/attributes/POSITION"},
        {"other type",
         [](Document& d) {
             d.json["accessors"][1]["componentType"] = 5121;
             d.json["accessors"][1]["normalized"] = true;
         },
         "/attributes/TEXCOORD_0"},
    };
    for (const DracoFault& fault : faults) {
        SCOPED_TRACE(fault.name);
        Document d = draco_document();
        fault.break_it(d);
        const auto loaded = load_document(d);
        ASSERT_FALSE(loaded) << "loads";
        EXPECT_EQ(loaded.error().code, fault.code) << base::to_line(loaded.error());
        EXPECT_EQ(loaded.error().where, draco_where + fault.where) << base::to_line(loaded.error());
    }
}

TEST(Draco, one_accessor_cannot_be_of_two_streams) {
    Document d = draco_document();
    d.json["meshes"].push_back(d.json["meshes"][0]);
    d.json["bufferViews"].push_back(d.json["bufferViews"][0]);
    d.json["meshes"][1]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["bufferView"] =
        1;
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where, "/meshes/1/primitives/0/extensions/KHR_draco_mesh_compression");
}

TEST(Draco, counts_are_memory_before_they_are_decoded) {
    base::Limits limits;
    limits.memory_bytes = 6000;
    const auto loaded = load_document(draco_document(), {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached) << base::to_line(loaded.error());
    EXPECT_EQ(loaded.error().where, draco_where);
}

TEST(Draco, check_looks_into_the_streams_and_does_not_ask_for_exact_bounds) {
    const auto check = [](const Document& d) {
        const support::TemporaryFolder folder;
        auto findings = scene::check(folder.write("model.gltf", d.text()).string(), {}, {});
        EXPECT_TRUE(findings.has_value());
        return findings ? std::move(*findings) : std::vector<scene::Finding>{};
    };
    for (const scene::Finding& f : check(draco_document(draco::MESH_EDGEBREAKER_ENCODING, 8)))
        EXPECT_GT(f.severity, scene::Finding::Severity::warning) << f.code << f.pointer;
    Document broken = draco_document();
    broken.json["accessors"][3]["count"] = 3;
    const auto findings = check(broken);
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const scene::Finding& f) {
        return f.severity == scene::Finding::Severity::error && f.pointer == draco_where;
    }));
}

#else

TEST(Draco, of_a_build_without_it_is_a_missing_feature) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    d.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::feature_missing);
    EXPECT_NE(loaded.error().remedy.find("FACET_DRACO"), std::string::npos);
}

#endif

}  // namespace
}  // namespace facet::test
