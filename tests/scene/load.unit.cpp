// Loading by name: files, what they may read, built-in scenes, and the models of the corpus.
// SPDX-License-Identifier: MIT
#include "scene/builtin_files.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

base::Result<scene::Loaded> load_file(const fs::path& path,
                                      const scene::LoadOptions& options = {}) {
    base::ThreadPool pool(1);
    return scene::load(path.string(), options, {}, pool);
}

/// The triangle with its buffer at `uri`.
std::string with_buffer_at(const std::string& uri) {
    Json json = triangle().finished();
    json["buffers"][0]["uri"] = uri;
    return json.dump();
}

class Loading : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(model_folder);
        write(model_folder / "data.bin", triangle().bytes);
        write(folder.path() / "outside.bin", triangle().bytes);
    }
    std::string error_of(const std::string& uri, const scene::LoadOptions& options = {}) {
        write(model_folder / "model.gltf", with_buffer_at(uri));
        const auto loaded = load_file(model_folder / "model.gltf", options);
        return loaded ? std::string() : base::to_line(loaded.error());
    }
    TemporaryFolder folder;
    fs::path model_folder = folder.path() / "model";
};

TEST_F(Loading, reads_buffers_beside_the_model_and_lists_what_it_read) {
    write(model_folder / "a b.bin", triangle().bytes);
    EXPECT_EQ(error_of("data.bin"), "");
    EXPECT_EQ(error_of("a%20b.bin"), "");
    EXPECT_EQ(error_of("./data.bin"), "");
    const auto loaded = load_file(model_folder / "model.gltf");
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->reads.size(), 2U);
    EXPECT_EQ(loaded->scene.name, "model");
}

TEST_F(Loading, refuses_whatever_leaves_the_folder) {
    for (const std::string uri :
         {"../outside.bin", "%2e%2e%2foutside.bin", "..\\outside.bin", "/etc/passwd", "C:\\x.bin",
          "file:///etc/passwd", "~/x.bin", "a%00b", "", "%zz", "%ff.bin", "\\\\host\\share"}) {
        const std::string error = error_of(uri);
        EXPECT_NE(error.find("/buffers/0/uri"), std::string::npos) << uri << ": " << error;
    }
}

TEST_F(Loading, follows_no_link_out_of_the_folder) {
    fs::create_symlink(folder.path() / "outside.bin", model_folder / "link.bin");
    EXPECT_NE(error_of("link.bin").find("outside the model's folder"), std::string::npos);
    EXPECT_EQ(error_of("link.bin", {.allowed_folders = {folder.path()}}), "");
}

TEST_F(Loading, never_uses_the_network) {
    for (const std::string uri :
         {"http://example.com/a.bin", "https://example.com/a.bin", "ftp://x/a", "blob:x"})
        EXPECT_NE(error_of(uri).find("the network is never used"), std::string::npos) << uri;
}

TEST_F(Loading, a_missing_buffer_is_an_error_and_a_missing_texture_a_white_one) {
    EXPECT_NE(error_of("missing.bin").find("no such file"), std::string::npos);
    Document d = triangle();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0, 0, 1});
    primitive(d)["material"] = 0;
    d.json["images"] = {{{"uri", "missing.png"}}};
    d.json["textures"] = {{{"source", 0}}};
    d.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    write(model_folder / "model.gltf", d.text());
    const auto loaded = load_file(model_folder / "model.gltf");
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    ASSERT_EQ(loaded->scene.images.size(), 1U);
    EXPECT_EQ(loaded->scene.images[0].pixels, nullptr);
    ASSERT_EQ(loaded->warnings.size(), 1U);
    EXPECT_EQ(loaded->warnings[0].where, "/images/0");
    const auto strict = load_file(model_folder / "model.gltf", {.strict = true});
    ASSERT_FALSE(strict);
    EXPECT_EQ(strict.error().code, base::ErrorCode::input_invalid);
}

TEST_F(Loading, a_damaged_texture_is_a_white_one) {
    Document d = triangle();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0, 0, 1});
    primitive(d)["material"] = 0;
    d.json["images"] = {{{"uri", "data:image/png;base64," + base64("\x89PNG\r\n\x1A\nbroken")}}};
    d.json["textures"] = {{{"source", 0}}};
    d.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_EQ(loaded->scene.images[0].pixels, nullptr);
    EXPECT_FALSE(loaded->warnings.empty());
}

TEST_F(Loading, a_missing_normal_map_is_none_as_white_would_lean) {
    Document d = triangle();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0, 0, 1});
    primitive(d)["material"] = 0;
    d.json["images"] = {{{"uri", "data:image/ktx2;base64," + base64("\xABKTX 20\xBB\r\n\x1A\n")}}};
    d.json["textures"] = {{{"source", 0}}};
    d.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_FALSE(
        loaded->scene.materials[0].texture(tables::TextureSlot::normal_texture).has_value());
    ASSERT_EQ(loaded->warnings.size(), 1U);
    EXPECT_NE(loaded->warnings[0].what.find("KTX2"), std::string::npos);
}

TEST_F(Loading, bytes_without_a_folder_may_not_name_files_unless_given_one) {
    const std::string text = with_buffer_at("data.bin");
    const auto refused = load_text(text);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().remedy.find("--base"), std::string::npos);
    EXPECT_TRUE(load_text(text, {.base_folder = model_folder}).has_value());
}

TEST_F(Loading, files_that_cannot_be_read_say_why) {
    EXPECT_FALSE(load_file(folder.path() / "none.glb").has_value());
    const auto directory = load_file(model_folder);
    ASSERT_FALSE(directory);
    EXPECT_EQ(directory.error().what, "is a directory");
}

TEST(LoadingBuiltins, an_unknown_scene_is_a_usage_error) {
    base::ThreadPool pool(1);
    const auto loaded = scene::load("builtin:no-such-scene", {}, {}, pool);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, base::ErrorCode::usage);
}

TEST(LoadingBuiltins, every_listed_scene_loads) {
    base::ThreadPool pool(1);
    for (const std::string& name : scene::builtin_names(scene::builtin_scenes)) {
        const auto loaded = scene::load("builtin:" + name, {.decode_images = false}, {}, pool);
        EXPECT_TRUE(loaded.has_value()) << name << ": " << base::to_line(loaded.error());
    }
}

TEST(LoadingCorpus, models_load_or_say_which_feature_they_need) {
    const fs::path corpus = fs::path(FACET_SOURCE_DIR) / "../shared/assets/models";
    if (!fs::is_directory(corpus)) GTEST_SKIP() << "no corpus beside the sources";
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
        if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
        const auto loaded = load_file(entry.path(), {.decode_images = false});
        ++count;
        if (loaded) {
            EXPECT_GT(loaded->scene.triangle_count(), 0U) << entry.path();
        } else {
            EXPECT_EQ(loaded.error().code, base::ErrorCode::feature_missing)
                << entry.path() << ": " << base::to_line(loaded.error());
        }
    }
    EXPECT_GT(count, 30U);
}

TEST(LoadingCorpus, broken_files_load_or_are_errors_of_the_documented_kinds) {
    const fs::path corpus = fs::path(FACET_SOURCE_DIR) / "../shared/assets/bad/gltf";
    if (!fs::is_directory(corpus)) GTEST_SKIP() << "no corpus beside the sources";
    for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
        if (!entry.is_regular_file()) continue;
        const auto loaded = load_file(entry.path());
        if (loaded) continue;
        const int code = base::exit_code(loaded.error().code);
        EXPECT_TRUE(code >= 3 && code <= 5)
            << entry.path() << ": " << base::to_line(loaded.error());
        EXPECT_EQ(loaded.error().file, entry.path().string());
    }
}

}  // namespace
}  // namespace facet::test
