// EXT_meshopt_compression and KHR_meshopt_compression: what the encoder packed is what loads, and
// every fault of a stream is told at its place.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "gltf_faults.h"
#ifdef FACET_HAS_MESHOPT
#include "gltf_meshopt.h"
#endif

namespace facet::test {
namespace {

#ifdef FACET_HAS_MESHOPT

using math::Vec2;
using math::Vec3;

constexpr const char* khr = "KHR_meshopt_compression";
constexpr const char* ext = "EXT_meshopt_compression";

void expect_sheet(const scene::Loaded& loaded) {
    ASSERT_EQ(loaded.scene.meshes.size(), 1U);
    const scene::Mesh& mesh = loaded.scene.meshes[0];
    const Sheet s = sheet();
    ASSERT_EQ(mesh.indices.size(), s.indices.size());
    const auto position = [&](std::size_t v) {
        return Vec3(s.positions[v * 3], s.positions[v * 3 + 1], s.positions[v * 3 + 2]);
    };
    // Flat normals give each corner a vertex of its own; packing may begin a triangle at another of
    // its corners.
    for (std::size_t first = 0; first < s.indices.size(); first += 3) {
        std::size_t turn = 0;
        while (turn < 2 &&
               mesh.positions_m[mesh.indices[first + turn]] != position(s.indices[first]))
            ++turn;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t v = s.indices[first + k];
            const std::size_t at = mesh.indices[first + (turn + k) % 3];
            EXPECT_EQ(mesh.positions_m[at], position(v));
            EXPECT_EQ(mesh.uv0[at], Vec2(static_cast<float>(s.uv[v * 2]) / 65535.0F,
                                         static_cast<float>(s.uv[v * 2 + 1]) / 65535.0F));
        }
    }
}

TEST(Meshopt, attributes_and_triangles_load_as_they_were_before_packing) {
    for (const char* const extension : {khr, ext})
        for (const bool is_glb : {false, true}) {
            SCOPED_TRACE(extension);
            const Document d = packed_sheet(extension);
            const auto loaded = load_text(is_glb ? d.glb() : d.text());
            ASSERT_TRUE(loaded) << base::to_line(loaded.error());
            EXPECT_TRUE(loaded->warnings.empty());
            expect_sheet(*loaded);
        }
}

TEST(Meshopt, indices_of_a_strip_are_a_sequence) {
    const Sheet s = sheet();
    std::vector<std::uint32_t> strip;
    for (std::uint32_t x = 0; x < 9; ++x) strip.insert(strip.end(), {x + 9, x});
    Document d;
    d.positions(s.positions);
    d.accessor("SCALAR", 5125, strip.size(), strip);
    pack_view(d, view_of(d, 1), {encode_indices(strip, false), "INDICES", strip.size(), 4}, ext);
    d.json["extensionsUsed"] = {ext};
    d.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", 5}}}}}};
    d.json["nodes"] = {{{"mesh", 0}}};
    EXPECT_EQ(loaded_or_fail(d).scene.triangle_count(), 16U);
}

TEST(Meshopt, octahedral_normals_and_exponential_positions_are_as_near_as_their_bits) {
    const Sheet s = sheet();
    const std::size_t count = s.positions.size() / 3;
    std::vector<float> normals;
    for (std::size_t i = 0; i < count; ++i) {
        const float a = 0.07F * static_cast<float>(i);
        normals.insert(normals.end(), {std::cos(a) * 0.6F, std::sin(a) * 0.6F, 0.8F, 0.0F});
    }
    std::vector<std::int8_t> octahedral(count * 4);
    meshopt_encodeFilterOct(octahedral.data(), count, 4, 8, normals.data());
    std::vector<float> exponential(count * 3);
    meshopt_encodeFilterExp(exponential.data(), count, 12, 15, s.positions.data());
    Document d = packed_sheet(khr);
    const std::size_t normal = d.accessor("VEC3", 5120, count, octahedral);
    d.json["accessors"][normal]["normalized"] = true;
    d.json["bufferViews"].back()["byteStride"] = 4;
    pack_view(d, view_of(d, normal),
              {encode_attributes(octahedral, 4), "ATTRIBUTES", count, 4, "OCTAHEDRAL"}, khr);
    pack_view(d, view_of(d, 0),
              {encode_attributes(exponential, 12), "ATTRIBUTES", count, 12, "EXPONENTIAL"}, khr);
    d.json["extensionsUsed"] = {khr, "KHR_mesh_quantization"};
    d.json["extensionsRequired"] = {khr, "KHR_mesh_quantization"};
    primitive(d)["attributes"]["NORMAL"] = normal;
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.meshes.size(), 1U);
    const scene::Mesh& mesh = loaded.scene.meshes[0];
    ASSERT_EQ(mesh.positions_m.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        // 8 bits of x and y in -1..1 each, half a step off; 15 bits of what is at most 8.
        EXPECT_NEAR(math::length(mesh.normals[i] -
                                 Vec3(normals[i * 4], normals[i * 4 + 1], normals[i * 4 + 2])),
                    0.0F, 2.0F / 127.0F);
        EXPECT_NEAR(
            math::length(mesh.positions_m[i] -
                         Vec3(s.positions[i * 3], s.positions[i * 3 + 1], s.positions[i * 3 + 2])),
            0.0F, std::sqrt(3.0F) * 8.0F / 16384.0F);
    }
}

TEST(Meshopt, quaternions_of_instances_turn_them) {
    const float half = std::sqrt(0.5F);
    // As 16 vertices, the least a group has: turned by 90 degrees about z.
    std::vector<float> turns;
    for (int i = 0; i < 16; ++i) turns.insert(turns.end(), {0, 0, half, half});
    std::vector<std::int16_t> packed(turns.size());
    meshopt_encodeFilterQuat(packed.data(), 16, 8, 16, turns.data());
    Document d = triangle();
    const std::size_t rotation = d.accessor("VEC4", 5122, 16, packed);
    d.json["accessors"][rotation]["normalized"] = true;
    pack_view(d, view_of(d, rotation),
              {encode_attributes(packed, 8), "ATTRIBUTES", 16, 8, "QUATERNION"}, ext);
    d.json["extensionsUsed"] = {ext, "EXT_mesh_gpu_instancing"};
    d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"ROTATION", rotation}};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.instances.size(), 16U);
    const Vec3 turned = Vec3(loaded.scene.instances[3].world_from_object * math::Vec4(1, 0, 0, 0));
    EXPECT_NEAR(math::length(turned - Vec3(0, 1, 0)), 0.0F, 1e-3F);
}

TEST(Meshopt, a_marked_fallback_buffer_in_a_glb_is_not_its_chunk) {
    Document d = packed_sheet(khr);
    Json json = Json::parse(d.text());
    json["buffers"][1]["extensions"][khr]["fallback"] = true;
    const auto loaded = load_text(json.dump());
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    expect_sheet(*loaded);
}

/// A view's first byte is that of a stream of version 1, which no Debian library decodes.
void make_newer(Document& d) { d.bytes[stream_of(d, 0)["byteOffset"].get<std::size_t>()] = '\xA1'; }
void make_colored(Document& d) { stream_of(d, 1)["filter"] = "COLOR"; }

TEST(Meshopt, what_the_library_cannot_decode_is_a_missing_feature) {
    for (const auto& change : {make_newer, make_colored}) {
        Document d = packed_sheet(khr);
        change(d);
        const auto loaded = load_document(d);
        ASSERT_FALSE(loaded);
        EXPECT_EQ(loaded.error().code, ErrorCode::feature_missing) << base::to_line(loaded.error());
        EXPECT_EQ(loaded.error().where, change == make_newer
                                            ? "/bufferViews/0/extensions/KHR_meshopt_compression"
                                            : "/bufferViews/1/extensions/KHR_meshopt_compression");
    }
}

TEST(Meshopt, plain_data_beside_a_stream_that_is_too_new_is_used_with_a_warning) {
    Document d = packed_sheet(khr);
    make_newer(d);
    const Sheet s = sheet();
    const std::size_t plain =
        d.view({reinterpret_cast<const char*>(s.positions.data()), s.positions.size() * 4});
    Json& view = d.json["bufferViews"][0];
    view["buffer"] = 0;
    view["byteOffset"] = d.json["bufferViews"][plain]["byteOffset"];
    const scene::Loaded loaded = loaded_or_fail(d);
    expect_sheet(loaded);
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_EQ(loaded.warnings[0].found, "the plain data beside it is used");
}

/// A change of a packed sheet's stream, and the member of it that is blamed.
struct StreamFault {
    const char* name;
    std::size_t view;
    std::function<void(Json&)> change;
    const char* member;
    ErrorCode code = invalid;
};

void expect_stream_fault(const StreamFault& fault, const base::Limits& limits = {}) {
    SCOPED_TRACE(fault.name);
    Document d = packed_sheet(khr);
    fault.change(stream_of(d, fault.view));
    const auto loaded = load_document(d, {}, limits);
    ASSERT_FALSE(loaded) << "loads";
    EXPECT_EQ(loaded.error().code, fault.code) << base::to_line(loaded.error());
    EXPECT_EQ(loaded.error().where, "/bufferViews/" + std::to_string(fault.view) +
                                        "/extensions/KHR_meshopt_compression" + fault.member)
        << base::to_line(loaded.error());
}

TEST(Meshopt, every_fault_of_a_stream_is_told_at_its_place) {
    const std::vector<StreamFault> faults{
        {"cut off", 0, [](Json& s) { s["byteLength"] = 20; }, ""},
        {"a byte left over", 0, [](Json& s) { s["byteLength"] = s["byteLength"].get<int>() + 1; },
         ""},
        {"triangles cut off", 2, [](Json& s) { s["byteLength"] = 30; }, ""},
        {"another mode", 2, [](Json& s) { s["mode"] = "INDICES"; }, ""},
        {"count less than the view", 0, [](Json& s) { s["count"] = 80; }, "/count"},
        {"count more than the view", 0, [](Json& s) { s["count"] = 82; }, "/count"},
        {"count near 2^53", 0, [](Json& s) { s["count"] = 9007199254740991; }, "/count"},
        {"count 0", 0, [](Json& s) { s["count"] = 0; }, "/count"},
        {"count negative", 0, [](Json& s) { s["count"] = -3; }, "/count"},
        {"count a fraction", 0, [](Json& s) { s["count"] = 0.5; }, "/count"},
        {"count of triangles", 2, [](Json& s) { s["count"] = 383; }, "/count"},
        {"stride 0", 0, [](Json& s) { s["byteStride"] = 0; }, "/byteStride"},
        {"stride 6", 0, [](Json& s) { s["byteStride"] = 6; }, "/byteStride"},
        {"stride 260", 0, [](Json& s) { s["byteStride"] = 260; }, "/byteStride"},
        {"stride of indices", 2, [](Json& s) { s["byteStride"] = 3; }, "/byteStride"},
        {"stride of a filter", 0, [](Json& s) { s["filter"] = "QUATERNION"; }, "/byteStride"},
        {"filter of triangles", 2, [](Json& s) { s["filter"] = "EXPONENTIAL"; }, "/filter"},
        {"filter unknown", 0, [](Json& s) { s["filter"] = "SEPIA"; }, "/filter"},
        {"mode unknown", 0, [](Json& s) { s["mode"] = "POINTS"; }, "/mode"},
        {"mode missing", 0, [](Json& s) { s.erase("mode"); }, ""},
        {"offset beyond", 0, [](Json& s) { s["byteOffset"] = 1 << 20; }, "/byteOffset"},
        {"offset near 2^64", 0, [](Json& s) { s["byteOffset"] = ~std::uint64_t{0}; },
         "/byteOffset"},
        {"length beyond", 0, [](Json& s) { s["byteLength"] = 1 << 20; }, "/byteLength"},
        {"buffer beyond", 0, [](Json& s) { s["buffer"] = 7; }, "/buffer"},
        {"buffer without bytes", 0, [](Json& s) { s["buffer"] = 1; }, "/buffer"},
    };
    for (const StreamFault& fault : faults) expect_stream_fault(fault);
}

TEST(Meshopt, the_stride_of_the_view_is_that_of_its_stream) {
    Document d = packed_sheet(khr);
    d.json["bufferViews"][0]["byteStride"] = 16;
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where, "/bufferViews/0/extensions/KHR_meshopt_compression/byteStride");
}

TEST(Meshopt, decoded_bytes_count_as_memory_before_they_are_made) {
    base::Limits limits;
    limits.memory_bytes = 3000;
    const auto loaded = load_document(packed_sheet(khr), {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached) << base::to_line(loaded.error());
}

std::vector<scene::Finding> checked(const Document& d) {
    const support::TemporaryFolder folder;
    auto findings = scene::check(folder.write("model.gltf", d.text()).string(), {}, {});
    EXPECT_TRUE(findings.has_value());
    return findings ? std::move(*findings) : std::vector<scene::Finding>{};
}

TEST(Meshopt, check_looks_into_the_streams) {
    for (const scene::Finding& f : checked(packed_sheet(khr)))
        EXPECT_GT(f.severity, scene::Finding::Severity::warning) << f.code << f.pointer;
    Document broken = packed_sheet(khr);
    stream_of(broken, 0)["byteLength"] = 20;
    const auto findings = checked(broken);
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const scene::Finding& f) {
        return f.severity == scene::Finding::Severity::error &&
               f.pointer == "/bufferViews/0/extensions/KHR_meshopt_compression";
    }));
}

/// Packing may begin a triangle at another of its corners.
std::vector<std::uint32_t> smallest_first(std::vector<std::uint32_t> indices) {
    for (auto at = indices.begin(); at != indices.end(); at += 3)
        std::rotate(at, std::min_element(at, at + 3), at + 3);
    return indices;
}

/// All but the normals: its exporter wrote them beside without the filter.
TEST(MeshoptCorpus, a_file_with_both_forms_holds_the_same_in_both) {
    const std::filesystem::path file = std::filesystem::path(FACET_SOURCE_DIR) /
                                       "../shared/assets/models/MeshoptFallback/"
                                       "meshopt-fallback.gltf";
    if (!std::filesystem::is_regular_file(file)) GTEST_SKIP() << "no corpus beside the sources";
    const auto text = base::read_text_file(file, 1U << 20U);
    ASSERT_TRUE(text);
    const scene::LoadOptions options{.base_folder = file.parent_path()};
    const auto decoded = load_text(*text, options);
    ASSERT_TRUE(decoded) << base::to_line(decoded.error());
    Json json = Json::parse(*text);
    for (Json& view : json["bufferViews"]) view.erase("extensions");
    const auto plain = load_text(json.dump(), options);
    ASSERT_TRUE(plain) << base::to_line(plain.error());
    ASSERT_EQ(decoded->scene.meshes.size(), plain->scene.meshes.size());
    for (std::size_t m = 0; m < plain->scene.meshes.size(); ++m) {
        EXPECT_EQ(decoded->scene.meshes[m].positions_m, plain->scene.meshes[m].positions_m);
        EXPECT_EQ(smallest_first(decoded->scene.meshes[m].indices),
                  smallest_first(plain->scene.meshes[m].indices));
    }
}

#else

TEST(Meshopt, of_a_build_without_it_is_a_missing_feature) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"EXT_meshopt_compression"};
    d.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::feature_missing);
    EXPECT_NE(loaded.error().remedy.find("FACET_MESHOPT"), std::string::npos);
}

#endif

}  // namespace
}  // namespace facet::test
