// Material files: what they say, what they refuse, and every preset that comes along.
// SPDX-License-Identifier: MIT
#include "scene/material_file.h"

#include "scene/dielectric.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace facet::scene {
namespace {

std::string file_refusal(std::string_view text) {
    const auto file = parse_material(text, {});
    EXPECT_FALSE(file) << text;
    return file ? std::string() : base::to_line(file.error());
}

TEST(MaterialFile, WhatIsWrittenReadsBackToTheSameNumbers) {
    Material material;
    material.name = "odd \"one\"";
    material.values.base_color = {0.1F, 1.0F / 3.0F, 0.7F};
    material.values.roughness = 0.3F;
    material.alpha_mode = AlphaMode::blend;
    material.double_sided = true;
    const auto file = parse_material(material_text(material), {});
    ASSERT_TRUE(file) << base::to_line(file.error());
    EXPECT_EQ(file->name, material.name);
    Material again;
    again.textures[0] = Texture{};
    apply_material(*file, again);
    for (const tables::MaterialParam& param : tables::material_params)
        std::visit(
            [&](auto field) {
                EXPECT_EQ(again.values.*field, material.values.*field) << param.key;
            },
            param.field);
    EXPECT_EQ(again.alpha_mode, AlphaMode::blend);
    EXPECT_TRUE(again.double_sided);
    EXPECT_FALSE(again.textures[0]) << "a texture would multiply what the file says";
}

TEST(MaterialFile, NumbersThatAreLeftOutStay) {
    const auto file = parse_material(R"({"facet": 1, "metallic": 0})", {});
    ASSERT_TRUE(file);
    Material material;
    material.values.roughness = 0.25F;
    apply_material(*file, material);
    EXPECT_EQ(material.values.metallic, 0.0F);
    EXPECT_EQ(material.values.roughness, 0.25F);
}

TEST(MaterialFile, RefusalsNameThePlaceAndWhatItTakes) {
    EXPECT_NE(file_refusal(R"({"facet": 1, "rougness": 0})").find("did you mean roughness"),
              std::string::npos);
    EXPECT_NE(file_refusal(R"({"facet": 1, "roughness": 2})").find("0 to 1"), std::string::npos);
    EXPECT_NE(file_refusal(R"({"facet": 1, "roughness": "a"})").find("/roughness"),
              std::string::npos);
    EXPECT_NE(file_refusal(R"({"facet": 1, "base_color": [0, 1]})").find("[r, g, b]"),
              std::string::npos);
    EXPECT_NE(file_refusal(R"({"facet": 2})").find("/facet"), std::string::npos);
    EXPECT_NE(file_refusal(R"({"roughness": 0.5})").find("/facet"), std::string::npos);
    EXPECT_NE(file_refusal(R"({"facet": 1, "alpha_mode": "glass"})").find("blend"),
              std::string::npos);
    file_refusal("[]");
    file_refusal("");
}

TEST(MaterialFile, EveryPresetReadsAndNamesItsSource) {
    const auto names = material_presets();
    EXPECT_GE(names.size(), 20U);
    for (const std::string& name : names) {
        const auto file = load_material(name, {});
        ASSERT_TRUE(file) << base::to_line(file.error());
        EXPECT_FALSE(file->name.empty()) << name;
        EXPECT_FALSE(file->source.empty()) << name;
    }
}

// scripts/make_resources.py reads them when it makes the scene, which somebody has to run.
TEST(MaterialPresets, AreThoseOfTheHaresOfTheirNamesWhoseMeanWaysRise) {
    base::ThreadPool pool(1);
    const auto loaded = load("builtin:subsurface", {}, {}, pool);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    EXPECT_TRUE(loaded->warnings.empty());
    float way_m = 0.0F;
    for (const char* const name : {"skin", "wax", "jade"}) {
        const auto material = std::ranges::find(loaded->scene.materials, name, &Material::name);
        ASSERT_NE(material, loaded->scene.materials.end()) << name;
        const auto preset = load_material(name, {});
        ASSERT_TRUE(preset) << name;
        Material wanted;
        apply_material(*preset, wanted);
        for (const tables::MaterialParam& param : tables::material_params)
            std::visit(
                [&](auto field) {
                    EXPECT_EQ(material->values.*field, wanted.values.*field)
                        << name << " " << param.key;
                },
                param.field);
        const math::Vec3 ways = 1.0F / extinction_per_m(material->values);
        EXPECT_GT(std::min({ways.x, ways.y, ways.z}), way_m) << name;
        way_m = std::max({ways.x, ways.y, ways.z});
    }
}

TEST(MaterialSetting, GivesOneMaterialOrAllAPresetAndRefusesUnknownNames) {
    Scene scene;
    scene.materials = {{.name = "a"}, {.name = "b"}};
    ASSERT_TRUE(apply_material_setting(scene, "b=charcoal", {}));
    EXPECT_EQ(scene.materials[0].values.metallic, 1.0F);
    EXPECT_EQ(scene.materials[1].values.metallic, 0.0F);
    ASSERT_TRUE(apply_material_setting(scene, "[0]=snow", {}));
    EXPECT_FLOAT_EQ(scene.materials[0].values.base_color.x, 0.81F);
    ASSERT_TRUE(apply_material_setting(scene, "*=gold", {}));
    EXPECT_EQ(scene.materials[1].values.metallic, 1.0F);
    for (const char* wrong : {"c=gold", "a=goldd", "a", "a=../x", "a=/no/such.json"})
        EXPECT_FALSE(apply_material_setting(scene, wrong, {})) << wrong;
}

}  // namespace
}  // namespace facet::scene
