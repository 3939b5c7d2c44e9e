// Lights of a picture, raster against reference.
// SPDX-License-Identifier: MIT
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace facet::render {
namespace {

/// RMSE of a ball in one light alone, against the reference; 1 where it is not drawn.
double error_of(const std::string& light, const char* shadows, const char* exposure) {
    Request request = test::small_request("builtin:ball", "black");
    tables::Settings& s = request.settings;
    s.exposure = exposure;
    s.shadows = shadows;
    s.light = {light};
    s.reference = "64";
    s.compare = true;
    return test::rmse_to_reference(request);
}

// Lights with a size by linearly transformed cosines: on a lone ball there is no shadow but its
// own.
TEST(LightsWithoutRays, ThoseWithASizeAreAsTheReferenceHasThem) {
    for (const char* const light :
         {"rect:position=0 3 0,target=0 0 0,width=2,height=1,nit=20",
          "disk:position=2 3 1,target=0 0 0,radius=0.5,nit=30",
          "sphere:position=2 2 2,radius=0.5,nit=30",
          "tube:position=0 2.2 1.5,target=0 0 0,width=3,radius=0.1,nit=30",
          "rect:position=0 3 0,target=0 0 0,width=2,height=1,nit=20,range=4"}) {
        EXPECT_LT(error_of(light, "off", "0.6"), 0.02) << light;
    }
}

/// A pane of half coverage, 2 m wide, in the plane z = 0.
std::filesystem::path write_pane(const support::TemporaryFolder& folder) {
    const std::filesystem::path file = folder / "pane.gltf";
    std::ofstream(file)
        << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"alphaMode":"BLEND","doubleSided":true,
"pbrMetallicRoughness":{"baseColorFactor":[0.8,0.6,0.4,0.5],"metallicFactor":0,"roughnessFactor":0.6}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)"
           "AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAAAACAvwAAgD8AAAAAAAABAA"
           "IAAAACAAMA"
        << R"("}]})";
    return file;
}

// With rays too, which do not know of it: one pane throws no shadow on itself.
TEST(BlendedSurface, IsLitByEveryKindOfLight) {
    const support::TemporaryFolder folder;
    Request request{.scene = write_pane(folder).string()};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = "black";
    s.background = "none";
    s.tonemap = "none";
    s.exposure = "1";
    s.camera = "orbit:azimuth=0,elevation=0";
    s.reference = "64";
    s.compare = true;
    for (const char* const light :
         {"directional:azimuth=40,elevation=30,lux=3", "point:position=0.5 0.5 1.5,candela=5",
          "rect:position=0.5 1 1.5,target=0 0 0,nit=5",
          "sphere:position=-1 0.5 1,radius=0.2,nit=20"})
        for (const char* const shadows : {"traced", "off"}) {
            s.light = {light};
            s.shadows = shadows;
            EXPECT_LT(test::rmse_to_reference(request), 0.01) << light << ' ' << shadows;
        }
}

// Through the ceiling of a box, of a lamp with and without a size.
TEST(ShadowOfALight, ThatIsOffIsInRasterAndReferenceAlike) {
    Request request{.scene = "builtin:cornell"};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = "black";
    s.tonemap = "none";
    s.exposure = "1";
    s.set = {"material.lamp.emissive=0 0 0"};
    for (const std::string light :
         {"point:position=0 3 0,candela=9", "rect:position=0 3 0,target=0 0 0,nit=9"}) {
        s.light = {light};
        const auto dark = test::rendered(request);
        ASSERT_TRUE(dark);
        const auto codes = dark->display.as<std::uint8_t>();
        const std::size_t floor = (std::size_t{50} * 80 + 40) * 4;
        EXPECT_LT(codes[floor], 30) << light;
        s.light = {light + ",shadow=off"};
        const auto lit = test::rendered(request);
        ASSERT_TRUE(lit);
        EXPECT_GT(lit->display.as<std::uint8_t>()[floor], 60) << light;
        s.reference = "256";
        s.compare = true;
        EXPECT_LT(test::rmse_to_reference(request), 0.03) << light;
        s.reference.clear();
        s.compare = false;
    }
}

// A lamp that is bright aside and dark ahead, other by azimuth; the ball shows all of it.
TEST(LightProfile, LightsAsTheReferenceHasIt) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "lamp.ies";
    std::ofstream(file) << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 4 3 1 2 0 0 0\n1 1 0\n"
                           "0 10 20 90\n0 90 180\n10 90 20 0\n10 40 80 0\n10 20 90 0\n";
    for (const char* const shadows : {"off", "traced"}) {
        EXPECT_LT(
            error_of("ies:file=" + file.string() + ",position=1 1 4,target=0 0 0", shadows, "1"),
            0.015)
            << shadows;
    }
    std::filesystem::remove(file);
}

// The rasteriser takes the sun out of the sky, the reference does not.
TEST(Sun, OfATurnedSkyLightsAsItDoesInThePicture) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = "sky:sun_elevation=20";
    s.env_rotation = 70.0F;
    s.tonemap = "none";
    s.reference = "128";
    s.compare = true;
    for (const char* const shadows : {"off", "traced"}) {
        s.shadows = shadows;
        base::Log log;
        const auto rendered = render(request, log);
        ASSERT_TRUE(rendered) << base::to_line(rendered.error());
        EXPECT_LT(rendered->compared->rmse, 0.015) << shadows;
    }
}

/// Light of a picture of the sky around the sun.
double light_around_the_sun(const std::string& background, const std::string& reference) {
    Request request{.scene = "builtin:ball", .want_linear = true};
    tables::Settings& s = request.settings;
    s.size = {160, 160};
    s.env = "sky:sun_elevation=0.5,sun_azimuth=180";
    s.camera = "orbit:azimuth=0,elevation=0,distance=1000";
    s.fov = 40.0F;
    s.background = background;
    s.exposure = "1";
    s.quality = "draft";
    s.samples = 16;
    s.reference = reference;
    const auto rendered = test::rendered(request);
    if (!rendered) return 0.0;
    double sum = 0.0;
    const auto values = rendered->layers.front().image.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) sum += static_cast<double>(values[i + 1]);
    return sum;
}

// As bright, sharp or blurred, as in the reference, which sees the picture itself.
TEST(Sun, IsSeenInTheBackground) {
    EXPECT_NEAR(light_around_the_sun("env", "") / light_around_the_sun("env", "64"), 1.0, 0.05);
    EXPECT_NEAR(light_around_the_sun("blur:0.2", "") / light_around_the_sun("blur:0.2", "256"), 1.0,
                0.05);
}

Request probed(const std::string& scene) {
    Request request{.scene = scene};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.tonemap = "none";
    s.shadows = "off";
    s.exposure = "1";
    return request;
}

image::Image display_of(const Request& request) {
    auto rendered = test::rendered(request);
    return rendered ? std::move(rendered->display) : image::Image{};
}

// In the middle of a lone ball, whose inside is not seen, a probe sees the environment.
TEST(Probe, OfAnEmptySceneIsItsEnvironment) {
    Request request = probed("builtin:ball");
    request.settings.set = {"material.*.metallic=1", "material.*.roughness=0.3"};
    const image::Image open = display_of(request);
    request.settings.probe = "auto";
    const image::Image with_probe = display_of(request);
    const auto a = open.as<std::uint8_t>();
    const auto b = with_probe.as<std::uint8_t>();
    ASSERT_EQ(a.size(), b.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += std::pow((static_cast<double>(a[i]) - static_cast<double>(b[i])) / 255.0, 2.0);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(a.size())), 0.02);
}

// A mirror in the Cornell box: without a probe it shows the studio, with one the red and the green
// wall.
TEST(Probe, OfABoxShowsItsWallsInAMirror) {
    Request request = probed("builtin:cornell");
    request.settings.env = "black";
    request.settings.set = {"material.white.metallic=1", "material.white.roughness=0.1"};
    const auto red = [](const image::Image& image) {
        // The back wall's left part.
        const auto v = image.as<std::uint8_t>();
        const std::size_t i = (std::size_t{20} * 80 + 26) * 4;
        return std::pair{v[i], v[i + 1]};
    };
    EXPECT_LT(red(display_of(request)).first, 40);
    request.settings.probe = "0 1 0";
    const auto [r, g] = red(display_of(request));
    EXPECT_GT(r, g + 20) << int(r) << " " << int(g);
}

}  // namespace
}  // namespace facet::render
