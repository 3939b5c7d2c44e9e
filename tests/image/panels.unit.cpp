// Pictures side by side: where everything is, and that every caption can be read.
// SPDX-License-Identifier: MIT
#include "image/panels.h"

#include "image/dotted_font.h"

#include <gtest/gtest.h>

#include <set>

namespace facet::image {
namespace {

Image plain(math::Extent size, std::uint8_t value, std::uint8_t alpha) {
    Image out(size, 4, Sample::u8);
    const auto v = out.as<std::uint8_t>();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = i % 4 == 3 ? alpha : value;
    return out;
}
std::uint8_t red(const Image& image, std::uint32_t x, std::uint32_t y) {
    return image.as<std::uint8_t>()[(std::size_t{y} * image.size.width + x) * 3];
}

TEST(Panels, LieFromLeftToRightWithAGapAndTheirCaptionsBelow) {
    const Image a = plain({64, 48}, 200, 255);
    const Image b = plain({64, 48}, 100, 255);
    const Panel panels[] = {{&a, {"one", "two"}}, {&b, {"x"}}};
    const Image out = side_by_side(panels);
    EXPECT_EQ(out.channels, 3U);
    EXPECT_EQ(out.size.width, 64U + 2U + 64U);
    EXPECT_GT(out.size.height, 48U);
    EXPECT_EQ(red(out, 63, 47), 200);
    EXPECT_EQ(red(out, 66, 0), 100);
    bool any_text = false;
    for (std::uint32_t x = 0; x < 64; ++x)
        for (std::uint32_t y = 48; y < out.size.height; ++y)
            any_text = any_text || red(out, x, y) > 200;
    EXPECT_TRUE(any_text);
}

TEST(Panels, WithoutLinesHaveNoStripAndAlphaLiesOverMidGray) {
    const Image clear = plain({8, 8}, 255, 0);
    const Panel panels[] = {{&clear, {}}};
    const Image out = side_by_side(panels);
    EXPECT_EQ(out.size, (math::Extent{8, 8}));
    EXPECT_EQ(red(out, 4, 4), 128);
}

TEST(Panels, TextThatIsTooLongIsCutAndNothingIsWrittenOutside) {
    const Image small = plain({4, 4}, 0, 255);
    const Panel panels[] = {{&small, {std::string(500, 'w')}}};
    EXPECT_EQ(side_by_side(panels).size.width, 4U);
}

TEST(DottedFont, HasEveryLetterAndDigitOnceAndNoTwoAlike) {
    std::set<std::uint64_t> shapes;
    std::set<char> characters;
    for (const Glyph& glyph : dotted_font) {
        EXPECT_TRUE(characters.insert(glyph.character).second) << glyph.character;
        EXPECT_TRUE(shapes.insert(glyph.dots).second) << glyph.character;
    }
    for (const char c :
         std::string("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:-+=/%()|_ "))
        EXPECT_TRUE(characters.contains(c)) << c;
}

}  // namespace
}  // namespace facet::image
