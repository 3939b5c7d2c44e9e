// Lights from text: units, conventions, what is refused.
// SPDX-License-Identifier: MIT
#include "scene/light_spec.h"

#include "math/blackbody.h"
#include "math/color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::scene {
namespace {

using base::ErrorCode;
using tables::LightKind;

Light light(const std::string& spec) {
    const auto parsed = parse_light(spec);
    EXPECT_TRUE(parsed) << spec << ": " << (parsed ? "" : base::to_line(parsed.error()));
    return parsed.value_or(Light{});
}
/// The error line of a spec that must be refused with `code`.
std::string refusal(const std::string& spec, ErrorCode code = ErrorCode::usage) {
    const auto parsed = parse_light(spec);
    EXPECT_FALSE(parsed) << spec;
    if (parsed) return {};
    EXPECT_EQ(parsed.error().code, code) << spec;
    return base::to_line(parsed.error());
}
void expect_near(const Vec3& found, const Vec3& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5F) << "component " << c;
}

TEST(LightSpec, AzimuthAndElevationSayWhereADirectionalLightComesFrom) {
    const Light sun = light("directional:lux=3,azimuth=60,elevation=40");
    EXPECT_EQ(sun.kind, LightKind::directional);
    EXPECT_EQ(sun.intensity, 3.0F);
    // The vector to the light, from sines and cosines on paper.
    expect_near(-sun.direction, {0.66341395F, 0.64278761F, 0.38302222F});
    expect_near(light("directional:azimuth=0,elevation=0").direction, {0.0F, 0.0F, -1.0F});
    expect_near(light("directional:azimuth=90,elevation=0").direction, {-1.0F, 0.0F, 0.0F});
    expect_near(light("directional:elevation=90").direction, {0.0F, -1.0F, 0.0F});
}

TEST(LightSpec, TargetAimsFromThePositionWhateverTheOrderOfTheKeys) {
    const Vec3 down_right = math::normalize(Vec3(3.0F, -4.0F, 0.0F));
    expect_near(light("spot:target=3 0 1,position=0 4 1").direction, down_right);
    expect_near(light("spot:position=0 4 1,target=3 0 1").direction, down_right);
    expect_near(light("spot:position=0 0 5").direction, {0.0F, 0.0F, -1.0F});  // at the origin
    expect_near(light("spot:candela=1").direction, {0.0F, -1.0F, 0.0F});
}

TEST(LightSpec, AnglesAimALampThatShinesStraightDownWhateverTheOrderOfTheKeys) {
    const Vec3 from_the_right = math::normalize(Vec3(-1.0F, -1.0F, 0.0F));
    expect_near(light("spot:position=0 3 0,azimuth=90,elevation=45").direction, from_the_right);
    expect_near(light("rect:elevation=45,azimuth=90,position=0 3 0").direction, from_the_right);
    Light lamp = light("spot:position=0 3 0");
    ASSERT_TRUE(set_light_key(lamp, "azimuth", "90"));
    expect_near(lamp.direction, {0.0F, -1.0F, 0.0F});
    EXPECT_NEAR(sky_angles(lamp).azimuth_deg, 90.0F, 1e-3F);
    ASSERT_TRUE(set_light_key(lamp, "elevation", "45"));
    expect_near(lamp.direction, from_the_right);
}

TEST(LightSpec, LumenOfALampTooNarrowToHaveAnyIsRefused) {
    EXPECT_TRUE(std::isfinite(light("spot:outer=0.1,lumen=1").intensity));
    Light needle = light("spot:candela=1");
    needle.inner_cone_rad = 0.0F;
    needle.outer_cone_rad = 1e-6F;
    EXPECT_FALSE(set_light_key(needle, "lumen", "1"));
    EXPECT_EQ(needle.intensity, 1.0F);
}

TEST(LightSpec, LumenOfAPointIsFourPiCandela) {
    EXPECT_NEAR(light("point:lumen=800").intensity, 800.0F / (4.0F * math::pi), 1e-3F);
    EXPECT_EQ(light("point:candela=12").intensity, 12.0F);
}

TEST(LightSpec, LumenOfASpotIsSpreadOverItsConeWhateverTheOrderOfTheKeys) {
    const float half_sphere = 2.0F * math::pi * (1.0F - std::cos(glm::radians(60.0F)));
    EXPECT_NEAR(light("spot:lumen=100,outer=60").intensity, 100.0F / half_sphere, 1e-3F);
    EXPECT_NEAR(light("spot:outer=60,lumen=100").intensity, 100.0F / half_sphere, 1e-3F);
    EXPECT_NEAR(light("spot:inner=10,outer=25").inner_cone_rad, glm::radians(10.0F), 1e-6F);
    EXPECT_NEAR(light("spot:inner=10,outer=25").outer_cone_rad, glm::radians(25.0F), 1e-6F);
}

TEST(LightSpec, ColorIsSrgbWithAHashAndLinearAsThreeNumbers) {
    expect_near(light("point:color=#ff8000").color,
                {1.0F, math::linear_from_srgb(128.0F / 255.0F), 0.0F});
    expect_near(light("point:color=0.5 0.25 2").color, {0.5F, 0.25F, 2.0F});
}

TEST(LightSpec, ColorTintsTheColourOfTheTemperature) {
    const Vec3 warm = math::blackbody_color(3000.0F);
    expect_near(light("point:temperature=3000").color, warm);
    expect_near(light("point:color=1 0.5 0,temperature=3000").color, warm * Vec3(1.0F, 0.5F, 0.0F));
}

TEST(LightSpec, NameAndRangeAreKeptAndSpacesAroundKeysDoNotMatter) {
    const Light key = light("point: name=key , range=2.5 ,position=1 2 3");
    EXPECT_EQ(key.name, "key");
    EXPECT_EQ(key.range_m, 2.5F);
    expect_near(key.position_m, {1.0F, 2.0F, 3.0F});
    EXPECT_EQ(light("point").name, "point");
}

TEST(LightSpec, MisspeltKindAndKeyAreAnsweredWithTheRightOnes) {
    EXPECT_NE(refusal("pont:candela=1").find("did you mean point"), std::string::npos);
    EXPECT_NE(refusal("point:candella=1").find("did you mean candela"), std::string::npos);
    EXPECT_NE(refusal("directional:candela=1").find("lux"), std::string::npos);
}

TEST(LightSpec, ValueOutOfItsRangeIsAnsweredWithTheRange) {
    EXPECT_NE(refusal("directional:lux=-1").find("0 to 1e+09"), std::string::npos);
    EXPECT_NE(refusal("point:temperature=300").find("1000 to 15000"), std::string::npos);
    EXPECT_NE(refusal("directional:elevation=91").find("-90 to 90"), std::string::npos);
    for (const char* value : {"nan", "inf", "1e400", "", "1 2", "ten"})
        refusal(std::string("point:candela=") + value);
}

TEST(LightSpec, BrokenVectorsColoursAndPairsAreUsageErrors) {
    for (const char* spec :
         {"point:position=1 2", "point:position=1 2 3 4", "point:position=1,2,3",
          "point:color=#12345", "point:color=#gg0000", "point:color=red", "point:candela",
          "point:candela=1,candela=2", "point:candela=1,lumen=2", "", ":",
          "spot:target=1 1 1,position=1 1 1", "spot:target=0 0 0,azimuth=3,position=1 1 1"})
        refusal(spec);
}

TEST(LightSpec, SpotWhoseInnerAngleIsNotBelowItsOuterIsRefused) {
    refusal("spot:inner=30,outer=30");
    refusal("spot:inner=40,outer=30");
    refusal("spot:outer=91");
}

TEST(LightSpec, OnlyLightsWithASizeCanBeVisible) {
    for (const char* kind : {"rect", "disk", "sphere", "tube"}) {
        EXPECT_TRUE(light(std::string(kind) + ":visible=on").is_visible) << kind;
        EXPECT_FALSE(light(kind).is_visible) << kind;
    }
    for (const char* kind : {"point", "spot", "directional", "ies"}) {
        const std::string line = refusal(std::string(kind) + ":visible=on");
        EXPECT_NE(line.find("no shape"), std::string::npos) << line;
        EXPECT_FALSE(light(std::string(kind) + ":visible=off").is_visible) << kind;
    }
    refusal("rect:visible=maybe");
    EXPECT_EQ(light_key_text(light("disk:visible=on"), "visible"), "on");
}

TEST(LightSpec, ShadowIsOnOrOff) {
    EXPECT_TRUE(light("point").casts_shadow);
    EXPECT_TRUE(light("point:shadow=on").casts_shadow);
    EXPECT_FALSE(light("rect:shadow=off").casts_shadow);
    refusal("point:shadow=maybe");
}

// Lambert: a flux leaves an area as radiance flux / (pi area) (Lagarde & de Rousiers 2014,
// Section 4.4).
TEST(LightSpec, LumenOfALightWithASizeIsSpreadOverItsArea) {
    const double pi = 3.14159265358979323846;
    EXPECT_NEAR(light("rect:lumen=100,width=2,height=0.5").intensity, 100.0 / pi, 1e-3);
    EXPECT_NEAR(light("disk:lumen=100,radius=0.5").intensity, 100.0 / (pi * pi * 0.25), 1e-3);
    EXPECT_NEAR(light("sphere:lumen=100,radius=0.5").intensity, 100.0 / (pi * pi), 1e-3);
    EXPECT_NEAR(light("tube:lumen=100,width=2,radius=0.05").intensity, 100.0 / (pi * pi * 0.2),
                1e-2);
    EXPECT_NEAR(light("sphere:radius=2,nit=7").intensity, 7.0, 0.0);
}

TEST(LightSpec, SizesAreMetresAboveZeroAndOfTheKindsThatHaveThem) {
    for (const char* spec : {"rect:width=0", "sphere:radius=-1", "disk:radius=nan",
                             "point:radius=0.1", "sphere:width=1", "rect:nit=1,lumen=1"})
        refusal(spec);
}

TEST(LightSpec, ARectangleIsLevelAndItsAxesAreRightHanded) {
    for (const char* spec :
         {"rect:position=1 2 3,target=0 0 0", "rect:elevation=90", "rect:elevation=-90"}) {
        const Light panel = light(spec);
        const LightAxes axes = axes_of(panel);
        EXPECT_NEAR(axes.x.y, 0.0F, 1e-6F) << spec;
        expect_near(math::cross(axes.x, axes.y), axes.z);
        expect_near(axes.z, panel.direction);
    }
}

TEST(LightSpec, SettingAnAngleKeepsTheOtherAndAnErrorChangesNothing) {
    Light sun = light("directional:azimuth=30,elevation=20");
    ASSERT_TRUE(set_light_key(sun, "azimuth", "120"));
    expect_near(-sun.direction, math::direction_from(120.0F, 20.0F));
    Light spot = light("spot:inner=10,outer=20");
    EXPECT_FALSE(set_light_key(spot, "outer", "5"));
    EXPECT_NEAR(spot.outer_cone_rad, glm::radians(20.0F), 1e-6F);
}

}  // namespace
}  // namespace facet::scene
