// Baked environments that are kept: the same bytes as a bake, whatever happens to the files.
// SPDX-License-Identifier: MIT
#include "frame/environment/baked_file.h"

#include "base/disk_cache.h"
#include "support/environment_bake.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace facet::frame {
namespace {

namespace fs = std::filesystem;

image::Image sky() {
    return picture(
        64, [](const Vec3& d) { return Vec3(std::exp(3.0F * d.x), 1.0F + d.y * d.z, d.y * d.y); });
}

/// A folder of a bake's own, and the bake without any.
struct BakedFile : testing::Test {
    support::TemporaryFolder folder;
    base::ThreadPool pool{2};
    base::Warnings warnings;
    const image::Image latlong = sky();
    EnvironmentSettings settings{30.0F, 1.5F, folder.path()};
    const base::Bytes fresh = bytes_of(bake_environment(latlong, 30.0F, 1.5F, pool));

    [[nodiscard]] base::Bytes baked() {
        return bytes_of(baked_environment(latlong, settings, pool, warnings));
    }
    [[nodiscard]] std::vector<fs::path> files() const {
        std::error_code error;
        std::vector<fs::path> out;
        for (const auto& entry : fs::directory_iterator(folder / "environments", error))
            out.push_back(entry.path());
        return out;
    }
};

TEST_F(BakedFile, BytesGiveTheSameBakeAgain) {
    const auto known = baked_from(fresh);
    ASSERT_TRUE(known);
    EXPECT_EQ(bytes_of(*known), fresh);
    const auto bake = bake_environment(latlong, 30.0F, 1.5F, pool);
    EXPECT_EQ(known->radiance, bake.radiance);
    EXPECT_EQ(known->irradiance, bake.irradiance);
    ASSERT_EQ(known->kept.size(), bake.kept.size());
    for (std::size_t i = 0; i < bake.kept.size(); ++i) {
        EXPECT_EQ(known->kept[i].side, bake.kept[i].side);
        EXPECT_EQ(std::memcmp(known->kept[i].texels.data(), bake.kept[i].texels.data(),
                              bake.kept[i].texels.size() * sizeof(Lanes)),
                  0);
    }
}

TEST_F(BakedFile, IsWrittenOnceAndFoundAfterwards) {
    EXPECT_EQ(baked(), fresh);
    ASSERT_EQ(files().size(), 1U);
    // That it is found and not baked shows where another environment lies in its place.
    const auto other = bake_environment(latlong, 0.0F, 1.0F, pool);
    const base::DiskCache cache(folder / "environments");
    ASSERT_TRUE(cache.put(bake_key(latlong, 30.0F, 1.5F, pool), bytes_of(other), pool));
    EXPECT_EQ(baked(), bytes_of(other));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(BakedFile, WrongFilesChangeNothingAndAreReplaced) {
    EXPECT_EQ(baked(), fresh);
    const fs::path file = files().front();
    const std::string whole = support::text_of(file);
    std::string bent = whole;
    bent[whole.size() / 2] = static_cast<char>(bent[whole.size() / 2] ^ 4);
    for (const std::string& text : {std::string(), whole.substr(0, whole.size() / 2), bent}) {
        folder.write("environments/" + file.filename().string(), text);
        EXPECT_EQ(baked(), fresh);
        EXPECT_EQ(support::text_of(file), whole);
    }
    // An entry that is whole, but no bake.
    const base::DiskCache cache(folder / "environments");
    ASSERT_TRUE(cache.put(bake_key(latlong, 30.0F, 1.5F, pool),
                          std::as_bytes(std::span("something else")), pool));
    EXPECT_EQ(baked(), fresh);
    EXPECT_EQ(support::text_of(file), whole);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(BakedFile, WithoutAFolderThatCanBeUsedThereIsOneWarningAndTheSameBake) {
    folder.write("file", "");
    settings.cache_folder = folder / "file";
    EXPECT_EQ(baked(), fresh);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(warnings[0].spares_result);
    settings.cache_folder.clear();
    EXPECT_EQ(baked(), fresh);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(BakedFile, SaysAgainWhatTheBakeSaid) {
    const image::Image sun =
        picture(64, [](const Vec3& d) { return Vec3(d.x > 0.99F ? 1e9F : 1); });
    for (int i = 0; i < 2; ++i)
        (void)baked_environment(sun, {.cache_folder = folder.path()}, pool, warnings);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(base::to_line(warnings[0]), base::to_line(warnings[1]));
    EXPECT_FALSE(warnings[0].spares_result);
}

TEST_F(BakedFile, KeysDifferWithAllThatABakeHangsOn) {
    image::Image other = sky();
    other.as<float>()[5] += 1e-6F;
    image::Image wide({latlong.size.height, latlong.size.width}, 3, image::Sample::f32);
    std::ranges::copy(latlong.bytes, wide.bytes.begin());
    const std::set<std::string> keys = {
        bake_key(latlong, 0.0F, 1.0F, pool), bake_key(latlong, 1.0F, 1.0F, pool),
        bake_key(latlong, 0.0F, 2.0F, pool), bake_key(other, 0.0F, 1.0F, pool),
        bake_key(wide, 0.0F, 1.0F, pool)};
    EXPECT_EQ(keys.size(), 5U);
    base::ThreadPool one(1);
    EXPECT_EQ(bake_key(latlong, 0.0F, 1.0F, one), bake_key(latlong, 0.0F, 1.0F, pool));
}

}  // namespace
}  // namespace facet::frame
