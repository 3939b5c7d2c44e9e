// Animations in pictures: raster against reference, and what blurs as it moves.
// SPDX-License-Identifier: MIT
#include "image/compare.h"
#include "scene/animation_fixture.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::render {
namespace {

/// A document as a file, and a picture of it.
class Film {
public:
    explicit Film(const test::Document& d) : file_(folder_.write("film.gltf", d.text())) {}

    /// Seen from the front, at a scale that does not depend on what moves: 30 pixels a metre.
    [[nodiscard]] Request at(float time_s) const {
        Request request = test::small_request(file_.string(), "studio");
        tables::Settings& s = request.settings;
        s.size = {200, 80};
        s.camera = "orbit:azimuth=0,elevation=0,distance=10,target=2.5 0.5 0";
        s.fov = 2.0F * std::atan(40.0F / 30.0F / 10.0F) * 180.0F / math::pi;
        s.time = time_s;
        return request;
    }

private:
    support::TemporaryFolder folder_;
    std::filesystem::path file_;
};

using test::radiance_of;

/// Mean over all values of the absolute difference.
double difference(const image::Image& a, const image::Image& b) {
    const auto x = a.as<float>();
    const auto y = b.as<float>();
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::fabs(static_cast<double>(x[i] - y[i]));
    return sum / static_cast<double>(x.size());
}

double covered(const image::Image& image, std::uint32_t first, std::uint32_t last) {
    const auto v = image.as<float>();
    double sum = 0.0;
    for (std::uint32_t y = 0; y < image.size.height; ++y)
        for (std::uint32_t x = first; x < last; ++x)
            sum += static_cast<double>(v[(std::size_t{y} * image.size.width + x) * 4 + 3]);
    return sum;
}

test::Document facing(test::Document d) {
    d.json["materials"] = {{{"doubleSided", true}}};
    test::primitive(d)["material"] = 0;
    return d;
}

/// What of nodes, skins and morph targets clips move.
struct Kind {
    const char* name;
    test::Document document;
};
std::vector<Kind> kinds() {
    return {{"node", facing(test::moving())},
            {"skin", facing(test::skinned())},
            {"morph", facing(test::morphed())}};
}

TEST(AnimationPictures, AreTheSameInRasterAndReference) {
    for (const Kind& kind : kinds()) {
        const Film film(kind.document);
        Request request = film.at(0.7F);
        const image::Image early = radiance_of(film.at(0.0F));
        EXPECT_GT(difference(radiance_of(request), early), 0.002) << kind.name << " moves";
        request.settings.reference = "128";
        request.settings.compare = true;
        EXPECT_LT(test::rmse_to_reference(request), 0.02) << kind.name;
    }
}

// A ball of 0.3 m over the triangle's way, seen itself, whose light moves nowhere.
TEST(AnimationPictures, HoldLightsThatAreSeenStillAsModelsMove) {
    const Film film(facing(test::moving()));
    Request request = film.at(0.5F);
    request.settings.shutter = 0.5F;
    request.settings.light = {"sphere:radius=0.3,position=4 0.5 0,nit=3,visible=on"};
    const image::Image seen = radiance_of(request);
    const auto middle = (std::size_t{40} * 200 + 145) * 4;  // 30 pixels a metre from the left
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen.as<float>()[middle + c], 3.0F, 1e-2F);
    request.settings.reference = "128";
    request.settings.compare = true;
    EXPECT_LT(test::rmse_to_reference(request), 0.02);
}

TEST(AnimationPictures, BlurAlikeInRasterAndReference) {
    for (const Kind& kind : kinds()) {
        const Film film(kind.document);
        Request request = film.at(0.5F);
        const image::Image still = radiance_of(request);
        request.settings.shutter = 0.5F;
        EXPECT_GT(difference(radiance_of(request), still), 0.0005) << kind.name << " blurs";
        request.settings.reference = "256";
        request.settings.compare = true;
        EXPECT_LT(test::rmse_to_reference(request), 0.02) << kind.name;
    }
}

// The triangle is a metre wide and goes by 2 m while the shutter is open: 60 pixels, over which all
// of it passes by every column of the streak's flat part, a third of its length.
TEST(AnimationPictures, DrawStreaksOfTheLengthOfTheWay) {
    const Film film(facing(test::moving()));
    for (const char* const reference : {"", "256"}) {
        Request request = film.at(1.0F);
        request.settings.quality = "draft";
        request.settings.samples = 256;
        request.settings.reference = reference;
        const double still = covered(radiance_of(request), 0, 200);
        request.settings.shutter = 1.0F;
        const image::Image moved = radiance_of(request);
        EXPECT_NEAR(covered(moved, 0, 200) / still, 1.0, 0.01) << "none is lost" << reference;
        const double flat = covered(moved, 94, 106) / 12.0;
        EXPECT_NEAR(covered(moved, 0, 200) / flat, 60.0, 1.0) << reference;
    }
}

TEST(AnimationPictures, ACameraThatGoesAlongSeesItStill) {
    test::Document d = facing(test::moving());
    d.json["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 2.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 20.0}}}}};
    d.json["nodes"] = {
        {{"children", {1, 2}}}, {{"mesh", 0}}, {{"camera", 0}, {"translation", {0, 0, 5}}}};
    const Film film(d);
    for (const char* const reference : {"", "64"}) {
        Request request = film.at(1.0F);
        request.settings.env = "furnace";
        request.settings.camera = "0";
        request.settings.samples = 32;
        request.settings.reference = reference;
        const image::Image still = radiance_of(request);
        EXPECT_GT(covered(still, 0, 200), 100.0);
        request.settings.shutter = 1.0F;
        EXPECT_LT(difference(radiance_of(request), still), 0.0005) << reference;
    }
}

// A lens that bends is resampled from a flat view, which blurs likewise.
TEST(AnimationPictures, BlurBehindALensThatBends) {
    const Film film(facing(test::moving()));
    Request request = film.at(1.0F);
    request.settings.quality = "draft";
    request.settings.shutter = 1.0F;
    const image::Image straight = radiance_of(request);
    request.settings.distortion = 1e-4F;
    EXPECT_LT(difference(radiance_of(request), straight), 0.003);
}

TEST(AnimationPictures, ShadowMapsFollowWhatMoves) {
    test::Document d = facing(test::moving());
    d.json["nodes"] = {{{"mesh", 0}},
                       {{"mesh", 0}, {"translation", {-2, -2, -1}}, {"scale", {9, 9, 1}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    const Film film(d);
    const auto shot = [&](const char* shadows, const char* reference) {
        Request request = film.at(1.0F);
        request.settings.env = "black";
        request.settings.light = {"directional:azimuth=45,elevation=0,lux=3"};
        request.settings.shutter = 1.0F;
        request.settings.samples = 64;
        request.settings.shadows = shadows;
        request.settings.reference = reference;
        return radiance_of(request);
    };
    // 0.0056; where maps stay as they were at first the shadow is sharp, and it is 0.022.
    EXPECT_LT(difference(shot("maps", ""), shot("", "256")), 0.01);
}

TEST(AnimationPictures, TheSameBytesWhateverTheThreads) {
    const Film film(facing(test::skinned()));
    Request request = film.at(0.5F);
    request.settings.shutter = 0.3F;
    request.settings.samples = 4;
    for (const char* const reference : {"", "8"}) {
        request.settings.reference = reference;
        request.settings.threads = 1;
        const image::Image one = radiance_of(request);
        request.settings.threads = 5;
        EXPECT_EQ(radiance_of(request).bytes, one.bytes) << reference;
    }
}

TEST(AnimationPictures, WithoutATimeAreTheFilesOwnPose) {
    const Film animated(facing(test::moving()));
    test::Document d = facing(test::moving());
    d.json.erase("animations");
    const Film plain(d);
    Request a = animated.at(0.0F);
    Request b = plain.at(0.0F);
    a.settings.time.reset();
    b.settings.time.reset();
    EXPECT_EQ(radiance_of(a).bytes, radiance_of(b).bytes);
}

}  // namespace
}  // namespace facet::render
