// Lessons' Markdown: text, figures, links, and what is taken out of it.
// SPDX-License-Identifier: MIT
#include "teach/markdown.h"

#include <gtest/gtest.h>

namespace facet::teach {
namespace {

base::Result<std::string> html(std::string_view markdown) {
    return html_of(markdown, [](const Figure& f) -> base::Result<std::string> {
        return "[" + f.kind + "|" + f.name + "|" + f.caption + "]";
    });
}

TEST(Markdown, LeavesOutTheTitleAndSetsTheRest) {
    EXPECT_EQ(html("# Title\n\nSome *text* and `code`.\n\n## More\n\n- one\n- two\n").value(),
              "<p>Some <em>text</em> and <code>code</code>.</p>\n<h2>More</h2>\n"
              "<ul><li>one</li>\n<li>two</li>\n</ul>\n");
}

TEST(Markdown, FiguresStandAloneAndNumbersInTheLine) {
    EXPECT_EQ(html("![A *caption* & more](strip:s)\n").value(), "[strip|s|A caption & more]\n");
    EXPECT_EQ(html("It is ![](number:n) here.\n").value(), "<p>It is [number|n|] here.</p>\n");
    EXPECT_EQ(html("![](number:n)\n").value(), "<p>[number|n|]</p>\n");
}

TEST(Markdown, SetsFormulas) {
    const auto set = html("With $k_d$ and\n\n$$a<b$$\n");
    ASSERT_TRUE(set);
    EXPECT_NE(set->find("<p>With <math><semantics>"), std::string::npos) << *set;
    EXPECT_NE(set->find("<math display=\"block\">"), std::string::npos) << *set;
    EXPECT_FALSE(html("$\\nosuch$"));
}

TEST(Markdown, TakesNoHtmlAndNoStrangeLinks) {
    EXPECT_EQ(html("<script>x</script>").value(), "<p>&lt;script&gt;x&lt;/script&gt;</p>\n");
    EXPECT_TRUE(html("[a](https://example.org/a?b=1&c=2)"));
    EXPECT_TRUE(html("[a](fresnel.html)"));
    EXPECT_FALSE(html("[a](javascript:alert(1))"));
    EXPECT_FALSE(html("[a](data:text/html,x)"));
    EXPECT_FALSE(html("[a](/etc/passwd)"));
}

TEST(Markdown, TellsItsFiguresCommandsAndSections) {
    const std::string_view text =
        "# T\n\nIntro.\n\n## One\n\n![c](plot:p)\n\nWords $4 (n \\cdot v)\\, \\alpha$.\n\n- "
        "item\n\n## Two\n\n"
        "```sh\nfacet teach\nfacet help\n```\n";
    ASSERT_EQ(figures_of(text).size(), 1U);
    EXPECT_EQ(figures_of(text)[0].kind, "plot");
    EXPECT_EQ(shell_blocks(text), (std::vector<std::string>{"facet teach\nfacet help\n"}));
    EXPECT_EQ(plain_section(text, 1), (std::vector<std::string>{"Words 4 (n·v) α.", "item"}));
    EXPECT_TRUE(plain_section(text, 7).empty());
}

}  // namespace
}  // namespace facet::teach
