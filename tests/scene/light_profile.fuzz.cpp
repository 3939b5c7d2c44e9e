// IES files of hostile bytes: an error, or a profile of shares between 0 and 1.
// SPDX-License-Identifier: MIT
#include "scene/light_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace facet::scene {
namespace {

constexpr std::string_view profile_seeds[] = {
    "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 1000 1 3 2 1 2 0 0 0\n1 1 20\n0 45 90\n0 90\n9 8 "
    "7\n6 5 4\n",
    "IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 0.9\n1 -1 2 2 1 1 1 0.1 0 0\n1 1 0\n90 180 0 1e3 5\n",
    "Lamp\nTILT=NONE\n1,1,1,2,4,1,2,0,0,0\r\n1,1,0\r\n0,180\r\n0,90,180,360\r\n1 2 3 4 5 6 7 8"};

TEST(LightProfileFuzz, EndsOnEveryMutationWithSharesOfOne) {
    std::mt19937 random(1);
    const std::string_view alphabet = "0123456789.-+e, \n\r=TN\0\xFF";
    int whole = 0;
    for (int round = 0; round < 4'000; ++round) {
        std::string text(profile_seeds[random() % std::size(profile_seeds)]);
        for (std::uint_fast32_t edits = random() % 6; edits > 0; --edits) {
            const std::size_t at = random() % text.size();
            const char byte = alphabet[random() % alphabet.size()];
            if (random() % 4 == 0) text.resize(std::max<std::size_t>(at, 1));
            if (random() % 2 == 0)
                text.insert(std::min(at, text.size()), 1, byte);
            else
                text[std::min(at, text.size() - 1)] = byte;
        }
        const auto profile = parse_profile(text);
        if (!profile) continue;
        ++whole;
        const auto [low, high] = std::ranges::minmax(profile->shares);
        ASSERT_GE(low, 0.0F) << text;
        ASSERT_LE(high, 1.0F) << text;
        ASSERT_GT(profile->candela, 0.0F) << text;
        ASSERT_LE(profile->flux_per_candela, 12.6F) << text;
    }
    EXPECT_GT(whole, 200);
}

}  // namespace
}  // namespace facet::scene
