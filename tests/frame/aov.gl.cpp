// What the G-buffer holds, read as AOVs, on shapes whose answer is known.
// SPDX-License-Identifier: MIT
#include "support/frame_harness.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

/// A quad 2 m before an orthographic camera of half height 2 m: it covers the middle half of the
/// picture.
class AovTest : public testing::Test {
protected:
    AovTest()
        : shot{.scene = scene_of(quad(2.0F), material({0.5F, 0.25F, 0.75F}, 0.2F, 0.6F)),
               .camera = camera_on_z(2.0F, 2.0F)} {
        for (std::size_t i = 0; i < tables::aovs.size(); ++i)
            shot.aovs.push_back(static_cast<tables::Aov>(i));
    }

    /// Value of channel `c` at a pixel of the AOV `name`.
    float value(const Picture& picture, const char* name, std::uint32_t x, std::uint32_t y,
                std::size_t c = 0) {
        for (const image::Layer& layer : picture.aovs)
            if (layer.name == name)
                return layer.image
                    .as<float>()[(std::size_t{y} * 64 + x) * layer.image.channels + c];
        ADD_FAILURE() << "no AOV " << name;
        return 0.0F;
    }

    Harness harness;
    Shot shot;
};

TEST_F(AovTest, TheMaterialComesBackAsItWasSet) {
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    EXPECT_NEAR(value(*picture, "albedo", 32, 32, 0), 0.5F, 1e-5F);  // 16 bits
    EXPECT_NEAR(value(*picture, "albedo", 32, 32, 1), 0.25F, 1e-5F);
    EXPECT_NEAR(value(*picture, "albedo", 32, 32, 2), 0.75F, 1e-5F);
    EXPECT_NEAR(value(*picture, "metallic", 32, 32), 0.2F, 0.5F / 255.0F);
    EXPECT_NEAR(value(*picture, "roughness", 32, 32), 0.6F, 0.5F / 255.0F);
    EXPECT_NEAR(value(*picture, "ao", 32, 32), 1.0F, 1e-6F);
}

TEST_F(AovTest, DepthIsTheDistanceAlongTheViewAndInfiniteBehindEverything) {
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_NEAR(value(*picture, "depth", 32, 32), 2.0F, 1e-4F);
    EXPECT_TRUE(std::isinf(value(*picture, "depth", 2, 2)));
}

TEST_F(AovTest, PositionAndNormalAreInWorldSpace) {
    shot.scene.instances[0].world_from_object =
        glm::rotate(math::Mat4(1.0F), glm::radians(60.0F), math::Vec3(0, 1, 0));
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_NEAR(value(*picture, "normal", 32, 32, 0), std::sin(glm::radians(60.0F)), 1e-4F);
    EXPECT_NEAR(value(*picture, "normal", 32, 32, 2), std::cos(glm::radians(60.0F)), 1e-4F);
    EXPECT_NEAR(value(*picture, "position", 32, 32, 1), -1.0F / 32.0F, 1e-4F)
        << "row 32 lies under the middle";
}

TEST_F(AovTest, IdsAreThoseOfTheNodeAndTheMaterialAndZeroOnTheBackground) {
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 1.0F);
    EXPECT_EQ(value(*picture, "material_id", 32, 32), 1.0F);
    EXPECT_EQ(value(*picture, "object_id", 2, 2), 0.0F);
}

TEST_F(AovTest, ThePictureIsTheRightSideUp) {
    shot.scene.instances[0].world_from_object =
        glm::translate(math::Mat4(1.0F), math::Vec3(0, 1.5F, 0));
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 4), 1.0F) << "the top of the picture";
    EXPECT_EQ(value(*picture, "object_id", 32, 60), 0.0F);
}

TEST_F(AovTest, BackFacesAreCulledUnlessTheMaterialIsDoubleSided) {
    shot.scene.instances[0].world_from_object =
        glm::rotate(math::Mat4(1.0F), math::pi, math::Vec3(0, 1, 0));
    auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 0.0F);
    shot.scene.materials[0].double_sided = true;
    picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 1.0F);
    EXPECT_NEAR(value(*picture, "normal", 32, 32, 2), 1.0F, 1e-4F) << "it turns to the viewer";
}

// The importer turns the triangles of a mirrored node (scene.h); normals must still point outwards.
TEST_F(AovTest, AMirroredInstanceOfATurnedMeshShowsItsFrontFaces) {
    shot.scene.instances[0].world_from_object = glm::scale(math::Mat4(1.0F), math::Vec3(-1, 1, 1));
    shot.scene.meshes[0].indices = {0, 2, 1, 0, 3, 2};
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 1.0F);
    EXPECT_NEAR(value(*picture, "normal", 32, 32, 2), 1.0F, 1e-4F);
}

TEST_F(AovTest, MaskedAlphaLeavesAHole) {
    shot.scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    shot.scene.materials[0].values.opacity = 0.4F;
    auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 0.0F);
    shot.scene.materials[0].values.alpha_cutoff = 0.3F;
    picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_EQ(value(*picture, "object_id", 32, 32), 1.0F);
}

TEST_F(AovTest, EmissionIsInNit) {
    shot.scene.materials[0].values.emissive = {1.0F, 0.5F, 0.25F};
    shot.scene.materials[0].values.emissive_strength = 1000.0F;
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_NEAR(value(*picture, "emissive", 32, 32, 1), 500.0F, 0.1F);
    EXPECT_NEAR(picture->center().y, 500.0F, 0.1F) << "and adds to the beauty";
}

// A view may change between frames: what it gives is what a frame made for it gives, and sums begin
// anew. The first list has a G-buffer with ids, the last one with emission.
TEST_F(AovTest, AListThatChangesGivesWhatItGivesFromTheStart) {
    using tables::Aov;
    shot.scene.materials[0].values.emissive = {1.0F, 0.5F, 0.25F};
    shot.samples = 4;
    for (const std::vector<Aov>& list :
         {std::vector<Aov>{},
          {Aov::depth, Aov::albedo},
          {Aov::emissive, Aov::n_dot_v, Aov::albedo, Aov::background},
          {Aov::emission, Aov::diffuse_direct}}) {
        shot.aovs = list;
        shot.earlier_aovs = std::nullopt;
        const auto fresh = harness.draw(shot);
        ASSERT_TRUE(fresh) << base::to_line(fresh.error());
        shot.earlier_aovs = {Aov::albedo, Aov::object_id, Aov::n_dot_v, Aov::emission};
        const auto changed = harness.draw(shot);
        ASSERT_TRUE(changed) << base::to_line(changed.error());
        EXPECT_EQ(fresh->radiance.bytes, changed->radiance.bytes);
        ASSERT_EQ(changed->aovs.size(), list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            EXPECT_EQ(changed->aovs[i].name, tables::row(list[i]).key);
            EXPECT_EQ(changed->aovs[i].image.bytes, fresh->aovs[i].image.bytes)
                << changed->aovs[i].name;
        }
    }
}

// out = c a + under (1 - a), associated alpha.
TEST_F(AovTest, BlendedAlphaIsCoverage) {
    shot.scene.materials[0].alpha_mode = scene::AlphaMode::blend;
    shot.scene.materials[0].values.opacity = 0.25F;
    shot.scene.materials[0].unlit = true;
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_NEAR(picture->center().w, 0.25F, 1e-5F);
    EXPECT_NEAR(picture->center().x, 0.125F, 1e-5F);
}

}  // namespace
}  // namespace facet::test
