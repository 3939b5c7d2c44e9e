// Kept environments of hostile bytes: none, or one whose sizes fit together.
// SPDX-License-Identifier: MIT
#include "frame/environment/baked_file.h"

#include "base/disk_cache.h"
#include "support/environment_bake.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace facet::frame {
namespace {

base::Bytes smallest_bake() {
    base::ThreadPool pool(2);
    return bytes_of(
        bake_environment(picture(8, [](const Vec3&) { return Vec3(1.0F); }), 0.0F, 1.0F, pool));
}

/// Bends its head and cuts its end: the rest are numbers, of which any are good.
void bend(base::Bytes& bytes, std::size_t head, std::mt19937& random) {
    for (std::uint_fast32_t edits = random() % 4; edits > 0; --edits)
        bytes[random() % std::min(head, bytes.size())] = static_cast<std::byte>(random() & 0xFFU);
    switch (random() % 4) {
        case 0:
            bytes.resize(1 + random() % bytes.size());
            break;
        case 1:
            bytes.resize(bytes.size() + random() % 5);
            break;
        default:
            break;
    }
}

TEST(BakedFileFuzz, GivesNoneOrABakeOfThoseBytes) {
    const base::Bytes seed = smallest_bake();
    std::mt19937 random(3);
    int whole = 0;
    for (int round = 0; round < 400; ++round) {
        base::Bytes bytes = seed;
        bend(bytes, 16, random);
        const auto baked = baked_from(bytes);
        if (!baked) continue;
        ++whole;
        ASSERT_GE(baked->unit_nit, 1.0F);
        // The last four bytes of its head are not used.
        ASSERT_EQ(bytes_of(*baked).size(), bytes.size());
        ASSERT_EQ(baked->radiance.size(), baked_level_count(baked->face_px));
    }
    EXPECT_GT(whole, 0);
}

// An entry that was bent is no entry, unless what was bent is what it was.
TEST(DiskCacheFuzz, AnEntryIsWholeOnlyAsItWasPut) {
    base::ThreadPool pool(1);
    const std::string key(64, 'f');
    const base::Bytes payload(777, std::byte{7});
    base::Bytes seed = base::entry_header(key, payload, pool);
    seed.insert(seed.end(), payload.begin(), payload.end());
    ASSERT_TRUE(base::is_whole_entry(seed, key, pool));
    std::mt19937 random(4);
    for (int round = 0; round < 20'000; ++round) {
        base::Bytes bytes = seed;
        bend(bytes, bytes.size(), random);
        ASSERT_EQ(base::is_whole_entry(bytes, key, pool), bytes == seed);
    }
}

}  // namespace
}  // namespace facet::frame
