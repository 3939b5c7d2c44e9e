// Lessons that are cut off, bent and stirred: an error, or a lesson; never anything else.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "base/resources.h"
#include "support/mutate.h"
#include "teach/formula.h"
#include "teach/lesson.h"
#include "teach/markdown.h"

#include <gtest/gtest.h>

#include <string_view>

namespace facet::teach {
namespace {

std::string seed(const char* file) {
    const auto bytes =
        base::read_file(*base::data_folder() / "resources" / "lessons" / file, 1 << 20);
    EXPECT_TRUE(bytes) << file;
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "";
}

constexpr std::string_view signs = "{}[]\"\\$^_&:,.-0e9\n#!()|`<>*";

TEST(LessonFiles, JsonIsALessonOrAnError) {
    for (const char* file : {"cook-torrance/lesson.json", "rendering-equation/lesson.json"})
        support::mutate(seed(file), signs, 11, [](const std::string& text) {
            Lesson lesson;
            const auto parsed = parse_lesson(text, lesson);
            if (!parsed) {
                EXPECT_FALSE(parsed.error().what.empty());
            }
        });
}

TEST(LessonFiles, MarkdownIsHtmlOrAnError) {
    for (const char* file : {"geometry/en.md", "light/ru.md"})
        support::mutate(seed(file), signs, 12, [](const std::string& text) {
            const auto html = html_of(
                text, [](const Figure& f) -> base::Result<std::string> { return f.caption; });
            if (html) {
                EXPECT_EQ(html->find("<script"), std::string::npos);
            }
            (void)figures_of(text);
            (void)plain_section(text, 1);
        });
}

TEST(LessonFiles, FormulasAreSetOrAnError) {
    for (
        const char* formula :
        {R"(D(n, h, \alpha) = \frac{\alpha^2}{\pi \left((n \cdot h)^2 (\alpha^2 - 1) + 1\right)^2})",
         R"(\begin{aligned} a &= \sqrt[3]{x} \\ b &= \sum_{k=1}^{N} \text{w} \end{aligned})"})
        support::mutate(formula, signs, 13,
                        [](const std::string& text) { (void)mathml(text, true); });
}

}  // namespace
}  // namespace facet::teach
