// Values of a scene by path: what is set, and what is refused.
// SPDX-License-Identifier: MIT
#include "scene/set_path.h"

#include "image/write.h"
#include "math/color.h"
#include "scene/light_spec.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

namespace facet::scene {
namespace {

Scene scene() {
    Scene out;
    for (const char* name : {"Helmet", "Body.001", "Glass", "Helmet"}) {
        Material material;
        material.name = name;
        material.textures[0] = Texture{};
        out.materials.push_back(material);
    }
    out.lights.push_back(*parse_light("point:name=key,candela=5"));
    out.lights.push_back(*parse_light("directional:name=sun,lux=2"));
    return out;
}
std::string set_refusal(const std::string& assignment) {
    Scene changed = scene();
    const auto status = apply_set(changed, assignment);
    EXPECT_FALSE(status) << assignment;
    if (status) return {};
    EXPECT_EQ(status.error().code, base::ErrorCode::usage);
    for (std::size_t i = 0; i < changed.materials.size(); ++i)
        EXPECT_EQ(changed.materials[i].values.roughness, scene().materials[i].values.roughness)
            << assignment;
    return base::to_line(status.error());
}

TEST(SetPath, NameSetsEveryMaterialOfThatNameAndNoOther) {
    Scene changed = scene();
    ASSERT_TRUE(apply_set(changed, "material.Helmet.roughness=0.4"));
    EXPECT_EQ(changed.materials[0].values.roughness, 0.4F);
    EXPECT_EQ(changed.materials[1].values.roughness, 1.0F);
    EXPECT_EQ(changed.materials[3].values.roughness, 0.4F);
}

TEST(SetPath, NamesMayHoldDotsAndEqualsSigns) {
    Scene changed = scene();
    changed.materials[2].name = "a=b.c";
    ASSERT_TRUE(apply_set(changed, "material.Body.001.metallic=0.25"));
    EXPECT_EQ(changed.materials[1].values.metallic, 0.25F);
    ASSERT_TRUE(apply_set(changed, "material.a=b.c.metallic=0.5"));
    EXPECT_EQ(changed.materials[2].values.metallic, 0.5F);
}

TEST(SetPath, StarSetsAllAndAnIndexSetsOne) {
    Scene changed = scene();
    ASSERT_TRUE(apply_set(changed, "material.*.metallic=0"));
    for (const Material& material : changed.materials) EXPECT_EQ(material.values.metallic, 0.0F);
    ASSERT_TRUE(apply_set(changed, "material[3].metallic=1"));
    EXPECT_EQ(changed.materials[0].values.metallic, 0.0F);
    EXPECT_EQ(changed.materials[3].values.metallic, 1.0F);
}

TEST(SetPath, ColoursAreSrgbWithAHashAndLinearAsThreeNumbers) {
    Scene changed = scene();
    ASSERT_TRUE(apply_set(changed, "material[0].base_color=#808080"));
    EXPECT_NEAR(changed.materials[0].values.base_color.y, math::linear_from_srgb(128.0F / 255.0F),
                1e-6F);
    ASSERT_TRUE(apply_set(changed, "material[0].base_color=0.1 0.2 0.3"));
    EXPECT_EQ(changed.materials[0].values.base_color, Vec3(0.1F, 0.2F, 0.3F));
}

TEST(SetPath, NoneDropsATexture) {
    Scene changed = scene();
    ASSERT_TRUE(apply_set(changed, "material.Helmet.base_color_texture=none"));
    EXPECT_FALSE(changed.materials[0].textures[0]);
    EXPECT_TRUE(changed.materials[1].textures[0]);
}

/// The scene with a quad of two triangles for its second material.
Scene with_mesh() {
    Scene out = scene();
    Mesh mesh;
    mesh.material = MaterialId{1};
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, Vec3(0, 0, 1));
    mesh.uv0 = {{0, 1}, {1, 1}, {0, 0}};
    mesh.indices = {0, 1, 2};
    out.meshes.push_back(mesh);
    return out;
}

TEST(SetPath, APictureFileBecomesATextureAndIsReadOnce) {
    const support::TemporaryFolder folder;
    const auto png = image::encode(image::Image({2, 2}, 3, image::Sample::u8), {.metadata = {}});
    const std::string file =
        folder.write("wood.png", {reinterpret_cast<const char*>(png->data()), png->size()})
            .string();
    Scene changed = with_mesh();
    changed.materials[1].textures[0]->wrap_u = Wrap::clamp;
    ASSERT_TRUE(apply_set(changed, "material.Body.001.base_color_texture=" + file));
    ASSERT_TRUE(apply_set(changed, "material.Body.001.normal_texture=" + file));
    ASSERT_EQ(changed.images.size(), 1U);
    EXPECT_EQ(changed.images[0].name, file);
    EXPECT_EQ(changed.materials[1].textures[0]->wrap_u, Wrap::clamp) << "looked up as before";
    EXPECT_EQ(changed.meshes[0].tangents.size(), changed.meshes[0].positions_m.size());
}

TEST(SetPath, ATextureThatComesAlongIsFoundByItsNameAndAMisspeltOneByTheNearest) {
    Scene changed = with_mesh();
    ASSERT_TRUE(apply_set(changed, "material.Body.001.fresnel_ramp_texture=builtin:gold_ramp"));
    ASSERT_EQ(changed.images.size(), 1U);
    EXPECT_EQ(changed.images[0].pixels->size, (math::Extent{64, 1}));
    const auto refused =
        apply_set(changed, "material.Body.001.fresnel_ramp_texture=builtin:gold_ram");
    ASSERT_FALSE(refused);
    EXPECT_NE(base::to_line(refused.error()).find("gold_ramp"), std::string::npos);
}

TEST(SetPath, APictureThatCannotBeUsedLeavesTheSceneAsItWas) {
    const support::TemporaryFolder folder;
    folder.write("text.png", "no picture");
    for (const std::string& value :
         {std::string("/no/such.png"), (folder / "text.png").string(), std::string("/tmp")}) {
        Scene changed = with_mesh();
        EXPECT_FALSE(apply_set(changed, "material.Body.001.base_color_texture=" + value)) << value;
        EXPECT_TRUE(changed.images.empty());
        EXPECT_EQ(changed.materials[1].textures[0]->image, ImageId{});
    }
    EXPECT_NE(set_refusal("material.Helmet.base_color_texture=a.png").find("coordinates"),
              std::string::npos)
        << "no mesh has this material";
}

TEST(SetPath, LightsTakeTheKeysOfTheirKind) {
    Scene changed = scene();
    ASSERT_TRUE(apply_set(changed, "light.key.candela=50"));
    EXPECT_EQ(changed.lights[0].intensity, 50.0F);
    ASSERT_TRUE(apply_set(changed, "light.sun.lux=7"));
    EXPECT_EQ(changed.lights[1].intensity, 7.0F);
    EXPECT_NE(set_refusal("light.sun.candela=7").find("lux"), std::string::npos);
}

TEST(SetPath, OneLightThatRefusesLeavesAllOfThemAsTheyWere) {
    Scene changed = scene();
    EXPECT_FALSE(apply_set(changed, "light.*.candela=9"));  // the second is directional
    EXPECT_EQ(changed.lights[0].intensity, 5.0F);
}

TEST(SetPath, MisspeltNamesAndKeysAreAnsweredWithTheNearestAndWithWhatThereIs) {
    EXPECT_NE(set_refusal("material.Helmt.roughness=0.4").find("did you mean Helmet"),
              std::string::npos);
    EXPECT_NE(set_refusal("material.Helmt.roughness=0.4").find("Glass"), std::string::npos);
    EXPECT_NE(set_refusal("material.Helmet.rougness=0.4").find("did you mean roughness"),
              std::string::npos);
    EXPECT_NE(set_refusal("materiel.Helmet.roughness=0.4").find("did you mean material"),
              std::string::npos);
}

TEST(SetPath, ValueOutOfItsRangeIsAnsweredWithTheRangeOfTheTable) {
    EXPECT_NE(set_refusal("material.Helmet.roughness=1.5").find("0 to 1"), std::string::npos);
    EXPECT_NE(set_refusal("material.Helmet.base_color=2 0 0").find("0 to 1"), std::string::npos);
    EXPECT_NE(set_refusal("material.Helmet.normal_scale=11").find("-10 to 10"), std::string::npos);
}

TEST(SetPath, BrokenPathsAreUsageErrors) {
    for (const char* assignment :
         {"", "=", "material", "material=1", "material.Helmet=1", "material.roughness=1",
          "material[].roughness=1", "material[4].roughness=1", "material[-1].roughness=1",
          "material[1.roughness=1", "material[1]roughness=1", "material.Helmet.roughness",
          "material.Helmet.roughness=", "material.Helmet.roughness=nan"})
        set_refusal(assignment);
}

TEST(SetPath, SceneWithoutLightsSaysSo) {
    Scene empty;
    const auto status = apply_set(empty, "light.*.lux=1");
    ASSERT_FALSE(status);
    EXPECT_NE(base::to_line(status.error()).find("no lights"), std::string::npos);
}

}  // namespace
}  // namespace facet::scene
