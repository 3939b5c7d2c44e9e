// Formulas: what is set, how, and what is refused.
// SPDX-License-Identifier: MIT
#include "teach/formula.h"

#include <gtest/gtest.h>

namespace facet::teach {
namespace {

/// The formula without its wrapping and its source.
std::string inner(std::string_view latex, bool display = false) {
    const auto set = mathml(latex, display);
    if (!set) return "error: " + set.error().what;
    const std::size_t begin = set->find("<semantics><mrow>") + 17;
    return set->substr(begin, set->find("</mrow><annotation") - begin);
}

TEST(Formula, SetsLettersNumbersAndScripts) {
    EXPECT_EQ(inner("x"), "<mi>x</mi>");
    EXPECT_EQ(inner("2.5"), "<mn>2.5</mn>");
    EXPECT_EQ(inner("k_d"), "<msub><mi>k</mi><mi>d</mi></msub>");
    EXPECT_EQ(inner("x_i^2"), "<msubsup><mi>x</mi><mi>i</mi><mn>2</mn></msubsup>");
    EXPECT_EQ(inner("(1-a)^5"),
              "<mo stretchy=\"false\">(</mo><mn>1</mn><mo>−</mo><mi>a</mi>"
              "<msup><mo stretchy=\"false\">)</mo><mn>5</mn></msup>");
}

TEST(Formula, SetsFractionsRootsAndBrackets) {
    EXPECT_EQ(inner("\\frac{c}{\\pi}"),
              "<mfrac><mrow><mi>c</mi></mrow><mrow><mi>π</mi></mrow></mfrac>");
    EXPECT_EQ(inner("\\sqrt{x}"), "<msqrt><mrow><mi>x</mi></mrow></msqrt>");
    EXPECT_EQ(inner("\\left(x\\right)^2"),
              "<msup><mrow><mo>(</mo><mi>x</mi><mo>)</mo></mrow><mn>2</mn></msup>");
    EXPECT_EQ(inner("a \\rightarrow b"), "<mi>a</mi><mo>→</mo><mi>b</mi>");
}

TEST(Formula, PutsTheLimitsOfSumsWhereTheyBelong) {
    EXPECT_EQ(inner("\\sum_k x", true), "<munder><mo>∑</mo><mi>k</mi></munder><mi>x</mi>");
    EXPECT_EQ(inner("\\sum_k x", false), "<msub><mo>∑</mo><mi>k</mi></msub><mi>x</mi>");
    EXPECT_EQ(inner("\\int_\\Omega x", true), "<msub><mo>∫</mo><mi>Ω</mi></msub><mi>x</mi>");
}

TEST(Formula, AlignsRows) {
    EXPECT_EQ(inner("\\begin{aligned} a &= 1 \\\\ b &= 2 \\end{aligned}", true),
              "<mtable class=\"aligned\" displaystyle=\"true\">"
              "<mtr><mtd><mi>a</mi></mtd><mtd><mo>=</mo><mn>1</mn></mtd></mtr>"
              "<mtr><mtd><mi>b</mi></mtd><mtd><mo>=</mo><mn>2</mn></mtd></mtr></mtable>");
}

TEST(Formula, KeepsItsSourceAndEscapesIt) {
    const auto set = mathml("a < b", false);
    ASSERT_TRUE(set);
    EXPECT_NE(set->find("<annotation encoding=\"application/x-tex\">a &lt; b</annotation>"),
              std::string::npos);
}

TEST(Formula, RefusesWhatItCannotSetAndSaysWhat) {
    for (const char* wrong :
         {"\\nosuch", "{a", "a}", "\\frac{a}", "a^", "a^b^c", "\\left(a", "\\sqrt[3", "\\text{a",
          "\\begin{matrix}a\\end{matrix}", "\\begin{aligned}a", "a # b", "\\", "_"}) {
        const auto set = mathml(wrong, true);
        EXPECT_FALSE(set) << wrong;
        if (!set) {
            EXPECT_EQ(set.error().code, base::ErrorCode::input_invalid) << wrong;
        }
    }
    EXPECT_FALSE(mathml(std::string(1000, '{'), true));
}

}  // namespace
}  // namespace facet::teach
