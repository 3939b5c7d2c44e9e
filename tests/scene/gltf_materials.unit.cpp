// The glTF importer on sound files: materials, textures and their extensions.
// SPDX-License-Identifier: MIT
#include "scene/dielectric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;
using tables::TextureSlot;

/// Smallest PNG there is: one pixel, as bytes.
std::string tiny_png() {
    const std::vector<unsigned char> bytes{
        0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0,    0,    0,    0x0D, 'I',  'H',
        'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1,    8,    2,    0,    0,
        0,    0x90, 0x77, 0x53, 0xDE, 0,    0,    0,    0x0C, 'I',  'D',  'A',  'T',  8,
        0xD7, 0x63, 0xF8, 0xCF, 0xC0, 0,    0,    3,    1,    1,    0,    0x18, 0xDD, 0x8D,
        0xB0, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xAE, 0x42, 0x60, 0x82};
    return {bytes.begin(), bytes.end()};
}

/// A triangle with coordinates, a material and one texture.
Document textured() {
    Document d = triangle();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 1, 1, 1, 0, 0});
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive(d)["material"] = 0;
    d.json["images"] = {{{"uri", "data:image/png;base64," + base64(tiny_png())}}};
    d.json["textures"] = {{{"source", 0}}};
    d.json["materials"] = {
        {{"name", "Painted"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    return d;
}

TEST(GltfMaterials, what_is_not_given_has_the_defaults_of_gltf) {
    Document d = triangle();
    d.json["materials"] = {Json::object()};
    primitive(d)["material"] = 0;
    const scene::Material material = loaded_or_fail(d).scene.materials[0];
    EXPECT_EQ(material.values.metallic, 1.0F);
    EXPECT_EQ(material.values.roughness, 1.0F);
    EXPECT_EQ(material.values.base_color, Vec3(1));
    EXPECT_EQ(material.values.emissive, Vec3(0));
    EXPECT_EQ(material.alpha_mode, scene::AlphaMode::opaque);
    EXPECT_FALSE(material.double_sided);
}

TEST(GltfMaterials, factors_alpha_and_the_extensions_known_are_read) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_emissive_strength", "KHR_materials_unlit"};
    d.json["materials"] = {{{"pbrMetallicRoughness",
                             {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                              {"metallicFactor", 0.5},
                              {"roughnessFactor", 0.25}}},
                            {"emissiveFactor", {1, 0.5, 0}},
                            {"alphaMode", "MASK"},
                            {"alphaCutoff", 0.75},
                            {"doubleSided", true},
                            {"extensions",
                             {{"KHR_materials_emissive_strength", {{"emissiveStrength", 300}}},
                              {"KHR_materials_unlit", Json::object()}}}}};
    primitive(d)["material"] = 0;
    const scene::Material material = loaded_or_fail(d).scene.materials[0];
    EXPECT_FLOAT_EQ(material.values.base_color.y, 0.2F);
    EXPECT_FLOAT_EQ(material.values.opacity, 0.4F);
    EXPECT_EQ(material.values.roughness, 0.25F);
    EXPECT_EQ(material.values.emissive_strength, 300.0F);
    EXPECT_EQ(material.values.alpha_cutoff, 0.75F);
    EXPECT_EQ(material.alpha_mode, scene::AlphaMode::mask);
    EXPECT_TRUE(material.double_sided);
    EXPECT_TRUE(material.unlit);
}

TEST(GltfMaterials, factors_out_of_range_are_clamped_with_a_warning) {
    Document d = triangle();
    d.json["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", 3.0}}}}};
    primitive(d)["material"] = 0;
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.materials[0].values.roughness, 1.0F);
    ASSERT_FALSE(loaded.warnings.empty());
    EXPECT_EQ(loaded.warnings[0].where, "/materials/0/pbrMetallicRoughness/roughnessFactor");
}

TEST(GltfMaterials, a_texture_brings_its_image_sampler_and_coordinates) {
    Document d = textured();
    d.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    d.json["textures"][0]["sampler"] = 0;
    const scene::Loaded loaded = loaded_or_fail(d);
    const auto& texture = loaded.scene.materials[0].texture(TextureSlot::base_color_texture);
    ASSERT_TRUE(texture.has_value());
    EXPECT_EQ(texture->wrap_u, scene::Wrap::clamp);
    EXPECT_EQ(texture->wrap_v, scene::Wrap::mirror);
    EXPECT_TRUE(texture->nearest);
    ASSERT_EQ(loaded.scene.images.size(), 1U);
}

TEST(GltfMaterials, an_image_used_twice_is_one_image) {
    Document d = textured();
    d.json["textures"].push_back({{"source", 0}});
    d.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
    EXPECT_EQ(loaded_or_fail(d).scene.images.size(), 1U);
}

TEST(GltfMaterials, a_texture_whose_coordinates_the_mesh_lacks_is_ignored_with_a_warning) {
    Document d = textured();
    d.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    const scene::Loaded loaded = loaded_or_fail(d);
    const scene::Material& worn = loaded.scene.materials[loaded.scene.meshes[0].material.index];
    EXPECT_FALSE(worn.texture(TextureSlot::base_color_texture).has_value());
    EXPECT_FALSE(loaded.warnings.empty());
}

TEST(GltfMaterials, the_texture_transform_turns_counter_clockwise_about_the_top_left_corner) {
    Document d = textured();
    d.json["extensionsUsed"] = {"KHR_texture_transform"};
    // Numbers of the Khronos sample TextureTransformTest: at 22.5 degrees the arrow's tip, which
    // lies at (0.778, 0.778) of the picture, is seen at (0.421, 1.016).
    d.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
          ["KHR_texture_transform"] = {{"rotation", 0.39269908169872414}};
    const scene::Loaded loaded = loaded_or_fail(d);
    const auto& texture = loaded.scene.materials[0].texture(TextureSlot::base_color_texture);
    ASSERT_TRUE(texture.has_value());
    const Vec3 seen = texture->uv_from_uv * Vec3(0.42095F, 1.01627F, 1);
    EXPECT_NEAR(seen.x, 0.77782F, 1e-4);
    EXPECT_NEAR(seen.y, 0.77782F, 1e-4);
}

TEST(GltfMaterials, offset_comes_after_rotation_after_scale) {
    Document d = textured();
    d.json["extensionsUsed"] = {"KHR_texture_transform"};
    d.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
          ["KHR_texture_transform"] = {
        {"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", 1.5707963267948966}};
    const scene::Loaded loaded = loaded_or_fail(d);
    const auto& texture = loaded.scene.materials[0].texture(TextureSlot::base_color_texture);
    ASSERT_TRUE(texture.has_value());
    const Vec3 seen = texture->uv_from_uv * Vec3(1, 1, 1);
    EXPECT_NEAR(seen.x, 3.5F, 1e-5);
    EXPECT_NEAR(seen.y, -1.75F, 1e-5);
}

TEST(GltfMaterials, specular_glossiness_is_a_dielectric_of_that_f0) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
    const auto material = [](const Json& diffuse, const Json& specular) {
        return Json{{"extensions",
                     {{"KHR_materials_pbrSpecularGlossiness",
                       {{"diffuseFactor", diffuse},
                        {"specularFactor", specular},
                        {"glossinessFactor", 0.75}}}}}};
    };
    d.json["materials"] = {material({0.8, 0.1, 0.1, 1}, {0.04, 0.04, 0.04}),
                           material({0, 0, 0, 1}, {1, 0.77, 0.34})};
    primitive(d)["material"] = 0;
    const scene::Loaded loaded = loaded_or_fail(d);
    for (const scene::Material& m : loaded.scene.materials) {
        EXPECT_EQ(m.values.metallic, 0);
        EXPECT_NEAR(m.values.roughness, 0.25F, 1e-6);
        EXPECT_TRUE(m.has_glossiness);
    }
    EXPECT_EQ(loaded.scene.materials[0].values.base_color, Vec3(0.8F, 0.1F, 0.1F));
    EXPECT_EQ(scene::dielectric_f0(loaded.scene.materials[0].values), Vec3(0.04F));
    EXPECT_EQ(scene::dielectric_f0(loaded.scene.materials[1].values), Vec3(1, 0.77F, 0.34F));
    EXPECT_TRUE(loaded.warnings.empty());
}

TEST(GltfMaterials, factors_of_extensions_are_read_by_their_rows) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_ior", "KHR_materials_specular"};
    d.json["materials"] = {
        {{"extensions",
          {{"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_specular",
            {{"specularFactor", 2.0}, {"specularColorFactor", {0.5, 1, 30}}}}}}}};
    primitive(d)["material"] = 0;
    const scene::Loaded loaded = loaded_or_fail(d);
    const tables::MaterialValues& v = loaded.scene.materials[0].values;
    EXPECT_EQ(v.ior, 1.33F);
    EXPECT_EQ(v.specular, 1.0F);  // held within its range
    EXPECT_FALSE(loaded.warnings.empty());
    EXPECT_EQ(v.specular_color, Vec3(0.5F, 1, 30));
    const float f0 = 0.33F / 2.33F * 0.33F / 2.33F;
    EXPECT_NEAR(scene::dielectric_f0(v).z, 30 * f0, 1e-5);
}

TEST(GltfMaterials, extras_bring_height_and_fresnel_maps) {
    Document d = textured();
    d.json["materials"][0]["extras"]["facet"] = {
        {"height", {{"texture", {{"index", 0}}}, {"scale_m", -0.25}}},
        {"fresnel_ramp", {{"texture", {{"index", 0}}}}}};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_TRUE(loaded.warnings.empty());
    const scene::Material& material = loaded.scene.materials[0];
    EXPECT_TRUE(material.texture(TextureSlot::height_texture).has_value());
    EXPECT_TRUE(material.texture(TextureSlot::fresnel_ramp_texture).has_value());
    EXPECT_EQ(material.values.height_scale_m, -0.25F);
}

TEST(GltfMaterials, extras_that_cannot_be_read_are_warned_of_by_their_pointer) {
    for (const Json& height :
         {Json{{"texture", {{"index", 7}}}}, Json{{"texture", {{"index", -1}}}},
          Json{{"texture", "bumps.png"}}, Json{{"texture", Json::object()}}}) {
        Document d = textured();
        d.json["materials"][0]["extras"]["facet"]["height"] = height;
        const scene::Loaded loaded = loaded_or_fail(d);
        ASSERT_EQ(loaded.warnings.size(), 1U) << height;
        EXPECT_EQ(loaded.warnings[0].where, "/materials/0/extras/facet/height/texture") << height;
        EXPECT_FALSE(loaded.scene.materials[0].texture(TextureSlot::height_texture).has_value());
    }
    Document d = textured();
    d.json["materials"][0]["extras"]["facet"]["height"] = {{"scale_m", "high"}};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_EQ(loaded.warnings[0].where, "/materials/0/extras/facet/height/scale_m");
}

TEST(GltfMaterials, a_normal_map_makes_tangents_and_none_makes_none) {
    Document d = textured();
    EXPECT_TRUE(loaded_or_fail(d).scene.meshes[0].tangents.empty());
    d.json["materials"][0]["normalTexture"] = {{"index", 0}};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.meshes[0].tangents.size(), 3U);
    EXPECT_EQ(loaded.scene.meshes[0].tangents[0], Vec4(1, 0, 0, 1));
}

}  // namespace
}  // namespace facet::test
