// Mip levels of normal maps: directions, and how rough the bumps are that a level no longer shows.
// SPDX-License-Identifier: MIT
#include "image/normal_mips.h"

#include "image/mips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace facet {
namespace {

using image::Image;
using image::Sample;

using Levels = std::vector<Image>;
/// x and y of a normal, as codes of 255.
using Codes = std::pair<int, int>;

Image normal_map(math::Extent size, const std::function<Codes(std::uint32_t, std::uint32_t)>& of) {
    Image out(size, 4, Sample::u8);
    std::uint8_t* to = out.as<std::uint8_t>().data();
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x, to += 4) {
            const auto [r, g] = of(x, y);
            to[0] = static_cast<std::uint8_t>(r);
            to[1] = static_cast<std::uint8_t>(g);
            to[2] = 255;
            to[3] = static_cast<std::uint8_t>(17 + x);  // somebody's data
        }
    return out;
}

std::uint8_t code(const Image& level, std::size_t pixel, std::size_t channel) {
    return level.as<std::uint8_t>()[pixel * 4 + channel];
}

double tilt(int code) { return 2.0 * code / 255.0 - 1.0; }

/// Code of the alpha whose square is the variance of slopes, both axes, of normals whose x and y
/// have this variance about 0.
double bump_code(double variance) { return 255.0 * std::sqrt(variance / (1.0 - variance)); }

constexpr int left = 128 - 38;  // as far below 127.5 as `right` is above
constexpr int right = 127 + 38;
const double slant2 = tilt(right) * tilt(right);

TEST(NormalMips, the_first_level_is_the_map_but_for_its_alpha) {
    const Image map = normal_map({5, 3}, [](auto x, auto y) { return Codes(90 + 9 * x, 40 + y); });
    const Levels levels = image::build_normal_mips(map);
    const std::vector<math::Extent> sizes{{5, 3}, {2, 1}, {1, 1}};
    ASSERT_EQ(levels.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_EQ(levels[i].size, sizes[i]);
    for (std::size_t i = 0; i < 15; ++i) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(code(levels[0], i, c), code(map, i, c));
        EXPECT_EQ(code(levels[0], i, 3), 0);
    }
    const Levels single =
        image::build_normal_mips(normal_map({1, 1}, [](auto, auto) { return Codes(200, 100); }));
    ASSERT_EQ(single.size(), 1U);
    EXPECT_EQ(code(single[0], 0, 0), 200);
    EXPECT_EQ(code(single[0], 0, 3), 0);
}

TEST(NormalMips, a_map_of_one_normal_has_no_bumps_at_any_level_and_keeps_its_direction) {
    for (const math::Extent size : {math::Extent{8, 8}, {7, 6}, {5, 3}, {1, 9}})
        for (const Codes& codes :
             {Codes(128, 128), Codes(127, 127), Codes(200, 90), Codes(30, 128)})
            for (const Image& level :
                 image::build_normal_mips(normal_map(size, [&](auto, auto) { return codes; })))
                for (std::size_t i = 0; i < level.size.pixels(); ++i) {
                    ASSERT_EQ(code(level, i, 0), codes.first);
                    ASSERT_EQ(code(level, i, 1), codes.second);
                    ASSERT_EQ(code(level, i, 3), 0) << size.width << 'x' << size.height;
                }
}

// Between texels a lookup is linear: the square of what swings between -s and s is s^2 / 3 in the
// mean, along either side.
TEST(NormalMips, tilts_that_cancel_leave_the_variance_of_their_slopes) {
    struct Case {
        const char* name;
        std::function<bool(std::uint32_t, std::uint32_t)> is_right;
        std::size_t level;
        double share;
    };
    const Case cases[] = {
        {"checker", [](auto x, auto y) { return (x + y) % 2 == 0; }, 1, 1.0 / 9.0},
        {"stripes", [](auto x, auto) { return x % 2 == 0; }, 1, 1.0 / 3.0},
        // Half of the way between texels is level: (1 + 1/3) / 2, and the square of that.
        {"coarse checker", [](auto x, auto y) { return (x / 2 + y / 2) % 2 == 0; }, 2, 4.0 / 9.0},
        {"wide stripes", [](auto, auto y) { return y / 2 % 2 == 0; }, 2, 2.0 / 3.0}};
    for (const Case& c : cases) {
        const Levels levels = image::build_normal_mips(normal_map(
            {16, 16}, [&](auto x, auto y) { return Codes(c.is_right(x, y) ? right : left, 128); }));
        for (std::size_t at = c.level; at < levels.size(); ++at)
            for (std::size_t i = 0; i < levels[at].size.pixels(); ++i) {
                EXPECT_NEAR(code(levels[at], i, 0), 127.5, 0.6) << c.name;
                EXPECT_EQ(code(levels[at], i, 2), 255) << c.name;
                EXPECT_NEAR(code(levels[at], i, 3), bump_code(slant2 * c.share), 0.75)
                    << c.name << " level " << at;
            }
    }
}

// Nothing is lost: bumps that a level shows, and those that it only tells of, are those of the map.
TEST(NormalMips, what_is_seen_and_what_is_told_add_up_to_the_bumps_of_the_map_at_every_level) {
    std::mt19937 random(7);
    const Image map = normal_map({64, 64}, [&](auto x, auto) {
        const auto wave = static_cast<int>(40.0 * std::sin(static_cast<double>(x) * 0.19635));
        return Codes(128 + wave + static_cast<int>(random() % 41) - 20,
                     128 + static_cast<int>(random() % 61) - 30);
    });
    const auto seen_variance = [](const Image& level) {  // of x and y, between texels too
        double sum = 0.0;
        const std::size_t n = level.size.width;
        for (std::size_t y = 0; y < n; ++y)
            for (std::size_t x = 0; x < n; ++x)
                for (std::size_t c = 0; c < 2; ++c) {
                    const auto at = [&](std::size_t i, std::size_t j) {
                        return tilt(code(level, (y + j) % n * n + (x + i) % n, c));
                    };
                    const double a = at(0, 0), b = at(1, 0), d = at(0, 1), e = at(1, 1);
                    // Of four corners, the mean square of what is linear along each side.
                    sum += (2.0 * (a * a + b * b + d * d + e * e) +
                            2.0 * (a * b + a * d + b * e + d * e) + a * e + b * d) /
                           18.0;
                }
        return sum / static_cast<double>(n * n);
    };
    const Levels levels = image::build_normal_mips(map);
    const double all = seen_variance(levels[0]);
    for (std::size_t at = 1; at < levels.size(); ++at) {
        double told = 0.0;
        for (std::size_t i = 0; i < levels[at].size.pixels(); ++i) {
            const double alpha = code(levels[at], i, 3) / 255.0;
            told += alpha * alpha / (1.0 + alpha * alpha);
        }
        told /= static_cast<double>(levels[at].size.pixels());
        EXPECT_NEAR(seen_variance(levels[at]) + told, all, 0.03 * all) << "level " << at;
    }
}

TEST(NormalMips, normals_that_turn_evenly_are_no_bumps) {
    const Levels levels = image::build_normal_mips(normal_map(
        {256, 4}, [](auto x, auto) { return Codes(x < 128 ? 64 + x : 64 + 255 - x, 128); }));
    for (std::size_t at = 1; at <= 2; ++at)
        for (std::size_t x = 4; x + 4 < levels[at].size.width / 2; ++x)
            EXPECT_EQ(code(levels[at], x, 3), 0) << "level " << at << " at " << x;
}

// Of a cone of normals about a tilted one the spread is that about an upright one.
TEST(NormalMips, bumps_on_a_slope_count_as_those_on_the_level) {
    constexpr double around = 0.15;  // radians from the middle
    const Levels levels = image::build_normal_mips(normal_map({64, 64}, [](auto x, auto y) {
        const double turn = 0.19634954 * static_cast<double>(2 * x + y);  // evenly, all ways
        const double u = around * std::cos(turn);
        const double v = around * std::sin(turn);
        const double z = std::sqrt(1.0 - u * u - v * v);
        const double tilted = 0.6 * z + 0.8 * u;  // by 37 degrees
        return Codes(std::lround((tilted * 0.5 + 0.5) * 255.0),
                     std::lround((v * 0.5 + 0.5) * 255.0));
    }));
    const Image& last = levels.back();
    // Between texels circles are chords: a little less.
    EXPECT_NEAR(code(last, 0, 3), bump_code(around * around), 1.5);
    EXPECT_NEAR(code(last, 0, 0), (0.6 * 0.5 + 0.5) * 255.0, 1.0);
}

TEST(NormalMips, an_odd_side_weighs_every_texel_the_same) {
    const Levels levels = image::build_normal_mips(normal_map({5, 5}, [](auto x, auto y) {
        return x == 2 && y == 2 ? Codes(255, 128) : Codes(128, 128);
    }));
    std::vector<int> around;
    for (std::size_t i = 0; i < 4; ++i) around.push_back(code(levels[1], i, 0));
    for (const int one : around) EXPECT_EQ(one, around[0]);
    EXPECT_GT(around[0], 128);
    EXPECT_GT(code(levels[1], 0, 3), 0);
}

// x and y of (1, 1) are beyond a unit's length; what is drawn is their direction.
TEST(NormalMips, codes_that_are_no_normals_give_numbers_all_the_same) {
    for (const Image& level : image::build_normal_mips(normal_map({6, 4}, [](auto x, auto y) {
             return Codes(x % 2 == 0 ? 0 : 255, y % 2 == 0 ? 0 : 255);
         })))
        for (std::size_t i = 0; level.size.width < 6 && i < level.size.pixels(); ++i) {
            EXPECT_NEAR(code(level, i, 0), 127.5, 0.6);
            EXPECT_GT(code(level, i, 3), 100);
        }
}

TEST(NormalMips, are_what_maps_of_normals_get_and_no_others) {
    const Image map =
        normal_map({8, 8}, [](auto x, auto) { return Codes(x % 2 == 0 ? 60 : 200, 128); });
    EXPECT_EQ(image::build_mips(map, tables::Texels::normals)[1].bytes,
              image::build_normal_mips(map)[1].bytes);
    EXPECT_EQ(image::build_mips(map, tables::Texels::numbers)[1].bytes,
              image::build_mips(map, false)[1].bytes);
    EXPECT_EQ(image::build_mips(map, tables::Texels::colors)[1].bytes,
              image::build_mips(map, true)[1].bytes);
    for (const tables::MaterialTexture& row : tables::material_textures)
        EXPECT_EQ(tables::texels_of(row) == tables::Texels::normals, row.is_normal_map) << row.key;
}

}  // namespace
}  // namespace facet
