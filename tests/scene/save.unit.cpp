// Saving: nothing but the edits changes, and what was saved reads back as it was edited.
// SPDX-License-Identifier: MIT
#include "scene/save.h"

#include "base/file.h"
#include "base/resources.h"
#include "image/write.h"
#include "scene/builtin_files.h"
#include "scene/light_spec.h"
#include "scene/set_path.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace facet::scene {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using support::TemporaryFolder;
using support::text_of;

/// A triangle with a light, written as a person might: extras, an unknown extension, odd order.
constexpr const char* document = R"({
  "extras": {"note": [1, 2.50, "x"]},
  "asset": {"version": "2.0", "generator": "hand"},
  "extensionsUsed": ["KHR_lights_punctual", "ACME_unknown"],
  "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "name": "lamp", "intensity": 5,
                 "extras": {"keep": true}}]}, "ACME_unknown": {"a": 0.1}},
  "scene": 0,
  "scenes": [{"nodes": [0, 1]}],
  "nodes": [{"mesh": 0}, {"translation": [1, 2, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
  "materials": [{"extras": {"id": 7}, "pbrMetallicRoughness": {"roughnessFactor": 0.25,
                 "baseColorTexture": {"index": 0, "extras": {"t": 1}}}, "name": "paint"}],
  "textures": [{"source": 0}],
  "images": [{"uri": "p.png"}],
  "buffers": [{"uri": "t.bin", "byteLength": 60}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                 "min": [0, 0, 0], "max": [1, 1, 0]},
                {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]
})";

/// Writes the document with its files.
std::string write_scene(const TemporaryFolder& folder) {
    const float numbers[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
    folder.write("in/t.bin", {reinterpret_cast<const char*>(numbers), sizeof numbers});
    image::Image pixels({2, 2}, 3, image::Sample::u8);
    std::memset(pixels.bytes.data(), 128, pixels.bytes.size());
    const auto png = image::encode(pixels, {.metadata = {}});
    folder.write("in/p.png", {reinterpret_cast<const char*>(png->data()), png->size()});
    return folder.write("in/scene.gltf", document).string();
}

Scene loaded(const std::string& path) {
    base::ThreadPool pool(1);
    auto scene = load(path, {}, {}, pool);
    EXPECT_TRUE(scene) << base::to_line(scene.error());
    return scene ? scene->scene : Scene{};
}

void save_as(const std::string& source, const Scene& original, const Scene& edited,
             const fs::path& target) {
    const auto saved = save({source, original, edited, target, {}}, {});
    ASSERT_TRUE(saved) << base::to_line(saved.error());
}

void expect_same(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        for (const tables::MaterialParam& param : tables::material_params)
            std::visit(
                [&](auto field) {
                    EXPECT_EQ(a.materials[i].values.*field, b.materials[i].values.*field)
                        << a.materials[i].name << " " << param.key;
                },
                param.field);
        for (std::size_t slot = 0; slot < a.materials[i].textures.size(); ++slot)
            EXPECT_EQ(a.materials[i].textures[slot].has_value(),
                      b.materials[i].textures[slot].has_value());
    }
    EXPECT_EQ(a.instances.size(), b.instances.size());
    EXPECT_EQ(a.lights.size(), b.lights.size());
    EXPECT_EQ(a.triangle_count(), b.triangle_count());
}

TEST(Save, WithoutAnEditTheDocumentIsTheSameValueAndItsFilesComeAlong) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    fs::create_directories(folder / "out");
    save_as(source, scene, scene, folder / "out/copy.gltf");
    EXPECT_EQ(Json::parse(text_of(folder / "out/copy.gltf")), Json::parse(document));
    EXPECT_EQ(text_of(folder / "out/t.bin"), text_of(folder / "in/t.bin"));
    EXPECT_EQ(text_of(folder / "out/p.png"), text_of(folder / "in/p.png"));
}

TEST(Save, AnEditChangesItsNumberAndNothingElse) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    ASSERT_TRUE(apply_set(edited, "material.paint.roughness=0.7"));
    save_as(source, scene, edited, source);
    Json expected = Json::parse(document);
    expected["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.7;
    EXPECT_EQ(Json::parse(text_of(source)).dump(), expected.dump());
}

TEST(Save, ColoursKeepTheOpacityBesideThem) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    ASSERT_TRUE(apply_set(edited, "material.paint.opacity=0.5"));
    ASSERT_TRUE(apply_set(edited, "material.paint.base_color=0.1 0.2 0.3"));
    save_as(source, scene, edited, folder / "in/b.gltf");
    const Json json = Json::parse(text_of(folder / "in/b.gltf"));
    EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"],
              Json::array({0.1, 0.2, 0.3, 0.5}));
    EXPECT_EQ(json["materials"][0]["extras"], Json({{"id", 7}}));
}

TEST(Save, PacksEverythingIntoAGlbAndTakesItApartAgain) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    ASSERT_TRUE(apply_set(edited, "material.*.metallic=0.3"));
    save_as(source, scene, edited, folder / "one.glb");
    EXPECT_EQ(folder.entry_count(), 2);  // in/ and the GLB: nothing beside it
    const std::string glb = (folder / "one.glb").string();
    const Scene again = loaded(glb);
    expect_same(again, edited);
    ASSERT_EQ(again.images.size(), 1U);
    ASSERT_NE(again.images[0].pixels, nullptr);
    fs::create_directories(folder / "apart");
    save_as(glb, again, again, folder / "apart/two.gltf");
    expect_same(loaded((folder / "apart/two.gltf").string()), edited);
    EXPECT_TRUE(fs::exists(folder / "apart/two.bin"));
}

TEST(Save, DroppedAndReplacedTexturesReadBack) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    const std::string picture = (folder / "in/p.png").string();
    ASSERT_TRUE(apply_set(edited, "material.paint.base_color_texture=none"));
    ASSERT_TRUE(apply_set(edited, "material.paint.emissive_texture=" + picture));
    ASSERT_TRUE(apply_set(edited, "material.paint.height_texture=" + picture));
    ASSERT_TRUE(apply_set(edited, "material.paint.height_scale_m=0.25"));
    for (const char* name : {"in/t.glb", "in/t.gltf"}) {
        save_as(source, scene, edited, folder / name);
        const Scene again = loaded((folder / name).string());
        EXPECT_FALSE(again.materials[0].texture(tables::TextureSlot::base_color_texture)) << name;
        EXPECT_TRUE(again.materials[0].texture(tables::TextureSlot::emissive_texture)) << name;
        EXPECT_TRUE(again.materials[0].texture(tables::TextureSlot::height_texture)) << name;
        EXPECT_EQ(again.materials[0].values.height_scale_m, 0.25F) << name;
    }
    EXPECT_EQ(text_of(folder / "in/t-1.png"), text_of(picture));
}

TEST(Save, LightsThatAreChangedMovedAndAddedReadBack) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    ASSERT_TRUE(apply_set(edited, "light.lamp.candela=9"));
    ASSERT_TRUE(apply_set(edited, "light.lamp.position=4 5 6"));
    edited.lights.push_back(*parse_light("spot:name=beam,position=0 3 0,candela=7,outer=30"));
    edited.lights.push_back(*parse_light("directional:name=sun,azimuth=30,elevation=20,lux=2"));
    edited.lights.push_back(*parse_light("rect:name=panel,nit=5"));
    const auto saved = save({source, scene, edited, folder / "in/l.gltf", {}}, {});
    ASSERT_TRUE(saved) << base::to_line(saved.error());
    EXPECT_EQ(saved->warnings.size(), 1U);  // glTF has no panels
    const Scene again = loaded((folder / "in/l.gltf").string());
    ASSERT_EQ(again.lights.size(), 3U);
    for (const Light& light : again.lights) {
        const auto wanted = std::find_if(edited.lights.begin(), edited.lights.end(),
                                         [&](const Light& l) { return l.name == light.name; });
        ASSERT_NE(wanted, edited.lights.end()) << light.name;
        EXPECT_EQ(light.intensity, wanted->intensity) << light.name;
        EXPECT_NEAR(math::length(light.position_m - wanted->position_m), 0.0F, 1e-6F);
        if (light.kind == tables::LightKind::point) continue;
        // A quaternion in float: some 1e-7 of an angle.
        EXPECT_NEAR(math::dot(light.direction, wanted->direction), 1.0F, 1e-6F) << light.name;
    }
    const Json json = Json::parse(text_of(folder / "in/l.gltf"));
    EXPECT_EQ(json["extensions"]["KHR_lights_punctual"]["lights"][0]["extras"],
              Json({{"keep", true}}));
}

TEST(Save, RefusesWhatItCannotWriteAndLeavesEverythingAsItWas) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    for (const char* target : {"out.obj", "no/such/folder.glb"}) {
        const auto saved = save({source, scene, scene, folder / target, {}}, {});
        ASSERT_FALSE(saved) << target;
        EXPECT_EQ(saved.error().code, base::ErrorCode::usage) << target;
    }
    EXPECT_EQ(text_of(source), document);
    EXPECT_EQ(folder.entry_count(), 1);
}

TEST(Save, AFileThatBecameAnotherIsNotSavedOver) {
    const TemporaryFolder folder;
    const std::string source = write_scene(folder);
    const Scene scene = loaded(source);
    Scene edited = scene;
    ASSERT_TRUE(apply_set(edited, "material.paint.roughness=0.7"));
    ASSERT_TRUE(apply_set(edited, "light.lamp.candela=9"));
    for (const char* other : {R"({"asset": {"version": "2.0"}})", "{", "", R"({"nodes": 3})",
                              R"({"asset": {"version": "2.0"}, "materials": [3], "scene": "a",
                                 "nodes": [{}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}]})"}) {
        folder.write("in/scene.gltf", other);
        const auto saved = save({source, scene, edited, source, {}}, {});
        ASSERT_FALSE(saved) << other;
        EXPECT_EQ(text_of(source), other);
    }
    std::filesystem::remove(source);
    EXPECT_FALSE(save({source, scene, edited, source, {}}, {}));
}

/// Saves, loads and compares one scene, untouched and edited.
void round_trip(const std::string& source, const TemporaryFolder& folder) {
    base::ThreadPool pool(1);
    const auto file = load(source, {.decode_images = false}, {}, pool);
    if (!file) return;  // needs a feature that is not there: nothing is open to be saved
    Scene edited = file->scene;
    if (!edited.materials.empty()) {
        ASSERT_TRUE(apply_set(edited, "material.*.roughness=0.375"));
        ASSERT_TRUE(apply_set(edited, "material.*.base_color=0.5 0.25 0.125"));
    }
    const bool is_glb = file_of(source, builtin_scenes)->extension() == ".glb";
    const fs::path same = folder / (is_glb ? "same.glb" : "same.gltf");
    SCOPED_TRACE(source);
    save_as(source, file->scene, file->scene, same);
    const auto again = load(same.string(), {.decode_images = false}, {}, pool);
    ASSERT_TRUE(again) << base::to_line(again.error());
    expect_same(again->scene, file->scene);
    for (const char* name : {"edited.glb", "edited.gltf"}) {
        const auto saved = save({source, file->scene, edited, folder / name, {}}, {});
        if (!saved && saved.error().code == base::ErrorCode::feature_missing) continue;
        ASSERT_TRUE(saved) << base::to_line(saved.error());
        const auto read = load((folder / name).string(), {.decode_images = false}, {}, pool);
        ASSERT_TRUE(read) << name << ": " << base::to_line(read.error());
        expect_same(read->scene, edited);
    }
}

TEST(Save, EveryBundledSceneComesBackAsItWasSaved) {
    for (const std::string& name : builtin_names(builtin_scenes)) {
        const TemporaryFolder folder;
        round_trip("builtin:" + name, folder);
    }
}

TEST(Save, EveryModelThatIsAtHandComesBackAsItWasSaved) {
    const fs::path models = FACET_SOURCE_DIR "/../shared/assets/models";
    std::error_code error;
    std::size_t count = 0;
    for (fs::recursive_directory_iterator at(models, error), end; !error && at != end;
         at.increment(error)) {
        const fs::path ending = at->path().extension();
        if (ending != ".gltf" && ending != ".glb") continue;
        const TemporaryFolder folder;
        round_trip(at->path().string(), folder);
        ++count;
    }
    if (count == 0) GTEST_SKIP() << "no ../shared/assets/models here";
}

}  // namespace
}  // namespace facet::scene
