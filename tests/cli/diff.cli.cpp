// facet diff: the numbers, the bounds, the heat map.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/write.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace facet::cli {
namespace {

using support::facet;
using support::Ran;

/// Gray pictures of known difference: b is a, `step` codes brighter.
struct Diff : testing::Test {
    support::TemporaryFolder folder;
    std::string gray(const char* name, int code, math::Extent size = {16, 8}) const {
        image::Image picture(size, 3, image::Sample::u8);
        for (std::byte& byte : picture.bytes) byte = static_cast<std::byte>(code);
        const auto png = image::encode(picture, {.metadata = {}});
        EXPECT_TRUE(png && base::write_file_atomically(folder / name, *png));
        return (folder / name).string();
    }
    static nlohmann::json numbers(const Ran& ran) { return nlohmann::json::parse(ran.out); }
};

TEST_F(Diff, OfAPictureWithItselfIsZeroAndHolds) {
    const auto a = gray("a.png", 100);
    const Ran ran =
        facet({"diff", a, a, "--json", "--max-rmse", "0", "--max-error", "0", "--max-flip", "0"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(numbers(ran)["rmse"], 0.0);
    EXPECT_TRUE(numbers(ran)["psnr"].is_null());
    EXPECT_EQ(numbers(ran)["pixels"], 128);
}
// A constant offset d has RMSE = max = d and PSNR = -20 log10 d.
TEST_F(Diff, OfAConstantOffsetIsTheOffset) {
    const Ran ran = facet({"diff", gray("a.png", 100), gray("b.png", 151), "--json"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const double offset = 51.0 / 255.0;
    EXPECT_NEAR(numbers(ran)["rmse"], offset, 1e-6);
    EXPECT_NEAR(numbers(ran)["max"], offset, 1e-6);
    EXPECT_NEAR(numbers(ran)["psnr"], -20.0 * std::log10(offset), 1e-4);
}
TEST_F(Diff, BeyondABoundIsStatus1AndSaysWhich) {
    const auto a = gray("a.png", 100);
    const auto b = gray("b.png", 151);
    EXPECT_EQ(facet({"diff", a, b, "--max-rmse", "0.21"}).exit, 0);
    const Ran ran = facet({"diff", a, b, "--max-rmse", "0.19"});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_NE(ran.out.find("rmse    0.200000  beyond 0.19"), std::string::npos) << ran.out;
    EXPECT_EQ(facet({"diff", a, b, "--max-error", "0.19"}).exit, 1);
    EXPECT_EQ(facet({"diff", a, b, "--min-psnr", "15"}).exit, 1);
    EXPECT_EQ(facet({"diff", a, b, "--min-psnr", "13"}).exit, 0);
}
TEST_F(Diff, WritesAHeatMapOfTheSameSize) {
    const auto heat = (folder / "heat.png").string();
    const auto a = gray("a.png", 0);
    const auto b = gray("b.png", 255);
    ASSERT_EQ(facet({"diff", a, b, "-o", heat, "--heat", "error"}).exit, 0);
    EXPECT_EQ(facet({"diff", heat, gray("white.png", 255), "--max-rmse", "0"}).exit, 0);
    ASSERT_EQ(facet({"diff", a, b, "-o", heat}).exit,
              0);  // FLIP: pale yellow at its end, dark where equal
    EXPECT_EQ(facet({"diff", heat, gray("white.png", 255), "--min-psnr", "10"}).exit, 0);
    ASSERT_EQ(facet({"diff", a, a, "-o", heat}).exit, 0);
    EXPECT_EQ(facet({"diff", heat, a, "--max-rmse", "0.01"}).exit, 0);
    EXPECT_EQ(facet({"diff", a, b, "-o", heat, "--heat", "hot"}).exit, 2);
}
TEST_F(Diff, SaysWhichFlipAndTheRelativeMse) {
    const auto ldr = numbers(facet({"diff", gray("a.png", 0), gray("b.png", 255), "--json"}));
    EXPECT_EQ(ldr["flip_kind"], "ldr");
    EXPECT_NEAR(ldr["rel_mse"].get<double>(), 1.0 / 0.01, 1e-6);  // (0 - 1)^2 / (0^2 + 0.01)
    image::Image radiance({16, 8}, 3, image::Sample::f32);
    for (float& value : radiance.as<float>()) value = 2.0F;
    const auto hdr = folder / "a.hdr";
    const auto bytes =
        image::encode(radiance, {.format = tables::ImageFormat::hdr, .metadata = {}});
    ASSERT_TRUE(bytes && base::write_file_atomically(hdr, *bytes));
    const auto same = numbers(facet({"diff", hdr.string(), hdr.string(), "--json"}));
    EXPECT_EQ(same["flip_kind"], "hdr");
    EXPECT_EQ(same["flip"], 0.0);
    EXPECT_EQ(facet({"diff", gray("a.png", 0), gray("b.png", 9), "--max-rel-mse", "1e-9"}).exit, 1);
}
TEST_F(Diff, OfDifferentSizesOrNoPicturesIsStatus3) {
    const auto a = gray("a.png", 1);
    EXPECT_EQ(facet({"diff", a, gray("b.png", 1, {8, 8})}).exit, 3);
    EXPECT_EQ(facet({"diff", a, folder.write("c.png", "no picture").string()}).exit, 3);
    const Ran missing = facet({"diff", a, (folder / "missing.png").string()});
    EXPECT_EQ(missing.exit, 3);
    EXPECT_TRUE(missing.err.starts_with("facet: " + (folder / "missing.png").string()))
        << missing.err;
}
TEST_F(Diff, RefusesAnOutputThatIsAnInput) {
    const auto a = gray("a.png", 1);
    EXPECT_EQ(facet({"diff", a, a, "-o", a}).exit, 2);
    EXPECT_EQ(facet({"diff", a}).exit, 2);
    EXPECT_EQ(facet({"diff", a, a, "-o", (folder / "heat.exr").string()}).exit, 2);
    EXPECT_EQ(facet({"diff", a, a, "--max-rmse", "nan"}).exit, 2);
}

}  // namespace
}  // namespace facet::cli
