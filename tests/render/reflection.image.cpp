// KHR_materials_ior, KHR_materials_specular and specular-glossiness, raster against reference.
// SPDX-License-Identifier: MIT
#include "image/write.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>

namespace facet::render {
namespace {

Request quick(std::string scene) {
    Request request = test::small_request(std::move(scene), "overcast");
    request.settings.light = {"directional:azimuth=40,elevation=50,lux=2"};
    return request;
}

TEST(Reflection, OfADielectricIsAsTheReferenceHasIt) {
    for (const std::vector<std::string>& edits :
         {std::vector<std::string>{"material.ball.ior=2.4"},
          {"material.ball.ior=1", "material.ball.roughness=0.2"},
          {"material.ball.specular=0.4"},
          {"material.ball.ior=0", "material.ball.specular_color=0.9 0.5 0.1"},
          {"material.ball.metallic=0.5", "material.ball.specular_color=0 4 9"}}) {
        Request request = quick("builtin:ball");
        request.settings.set = edits;
        request.settings.reference = "128";
        request.settings.compare = true;
        for (const char* const shadows : {"traced", "off"}) {
            request.settings.shadows = shadows;
            EXPECT_LT(test::rmse_to_reference(request), 0.015) << edits.front() << ' ' << shadows;
        }
    }
}

/// A pane of glossiness 0.6 and that specular colour, by factors or by its texture.
std::string write_pane(const support::TemporaryFolder& folder, bool textured) {
    image::Image map({2, 2}, 4, image::Sample::u8);
    const auto texels = map.as<std::uint8_t>();
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = std::array<std::uint8_t, 4>{255, 188, 99, 153}[i % 4];  // sRGB; alpha 0.6
    const auto png = image::encode(map, {.depth = image::Depth::u8, .metadata = {}});
    EXPECT_TRUE(png);
    std::ofstream(folder / "map.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(png->data()),
               static_cast<std::streamsize>(png->size()));
    const std::string file = (folder / (textured ? "map.gltf" : "plain.gltf")).string();
    std::ofstream(file)
        << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"extensionsUsed":["KHR_materials_pbrSpecularGlossiness"],"textures":[{"source":0}],"images":[{"uri":"map.png"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"doubleSided":true,"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.2,0.3,0.4,1],)"
        << (textured ? R"("specularGlossinessTexture":{"index":0})"
                     : R"("specularFactor":[1,0.5029,0.1248],"glossinessFactor":0.6)")
        << R"(}}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteLength":24}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
        << R"("}]})";
    return file;
}

TEST(SpecularGlossiness, OfATextureIsThatOfItsFactorsInRasterAndReference) {
    const support::TemporaryFolder folder;
    Request plain = quick(write_pane(folder, false));
    plain.settings.camera = "orbit:azimuth=20,elevation=10";
    Request mapped = plain;
    mapped.scene = write_pane(folder, true);
    const auto a = test::rendered(plain);
    const auto b = test::rendered(mapped);
    ASSERT_TRUE(a && b);
    int most = 0;
    const auto of_factors = a->display.as<std::uint8_t>();
    const auto of_texture = b->display.as<std::uint8_t>();
    for (std::size_t i = 0; i < of_factors.size(); ++i)
        most = std::max(most, std::abs(int{of_factors[i]} - int{of_texture[i]}));
    EXPECT_LE(most, 2);
    mapped.settings.reference = "128";
    mapped.settings.compare = true;
    EXPECT_LT(test::rmse_to_reference(mapped), 0.015);
}

}  // namespace
}  // namespace facet::render
