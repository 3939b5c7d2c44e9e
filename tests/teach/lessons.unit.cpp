// Every lesson: complete in every language, its figures there, its numbers those of the reference
// tables. SPDX-License-Identifier: MIT
#include "base/text.h"
#include "base/texts.h"
#include "support/reference_table.h"
#include "teach/formula.h"
#include "teach/lesson.h"
#include "teach/live.h"
#include "teach/markdown.h"
#include "teach/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace facet::teach {
namespace {

std::vector<Lesson> lessons() {
    auto all = all_lessons();
    EXPECT_TRUE(all) << base::to_line(all.error());
    return all ? std::move(*all) : std::vector<Lesson>{};
}

std::set<std::string> figure_names(const std::string& text) {
    std::set<std::string> out;
    for (const Figure& figure : figures_of(text)) out.insert(figure.kind + ":" + figure.name);
    return out;
}

TEST(Lessons, AreThoseOfTheLecture) {
    const std::vector<std::string> names = lesson_names();
    for (const char* name :
         {"energy", "reflection", "microgeometry", "half-vector", "rendering-equation",
          "lambert-cook-torrance", "distribution", "fresnel", "geometry", "multiscatter",
          "cook-torrance", "light", "environment", "metal-rough", "maps", "global-illumination",
          "shadows", "exposure", "lens"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
}

TEST(Lessons, SayTheSameInEveryLanguage) {
    for (const Lesson& lesson : lessons()) {
        const std::string& first = lesson.texts.at(std::string(base::languages[0]));
        for (const std::string_view language : base::languages) {
            const std::string& text = lesson.texts.at(std::string(language));
            EXPECT_EQ(figure_names(text), figure_names(first)) << lesson.name << " " << language;
            EXPECT_EQ(figures_of(text).size(), figures_of(first).size())
                << lesson.name << " " << language;
            EXPECT_NE(lesson.title(language), lesson.name) << language;
            EXPECT_EQ(shell_blocks(text).size(), 1U) << lesson.name << " " << language;
            EXPECT_FALSE(plain_section(text, 0).empty()) << lesson.name << " " << language;
            EXPECT_FALSE(plain_section(text, 1).empty()) << lesson.name << ": what to notice";
            for (const Figure& figure : figures_of(text))
                EXPECT_TRUE(figure.kind == "number" || !figure.caption.empty())
                    << lesson.name << " " << language << " " << figure.name << " has no caption";
        }
        const bool is_translated = std::ranges::any_of(
            lesson.texts.at("ru"), [](char c) { return static_cast<unsigned char>(c) > 127; });
        EXPECT_TRUE(is_translated) << lesson.name;
    }
}

TEST(Lessons, HaveTheirPicturesPlotsNumbersAndCanvas) {
    for (const Lesson& lesson : lessons()) {
        EXPECT_FALSE(lesson.strips.empty()) << lesson.name;
        EXPECT_FALSE(lesson.plots.empty()) << lesson.name;
        EXPECT_TRUE(lesson.live.has_value()) << lesson.name;
        EXPECT_TRUE(lesson.studio.has_value()) << lesson.name;
        EXPECT_TRUE(std::ranges::any_of(lesson.numbers,
                                        [](const Number& n) { return n.reference.has_value(); }))
            << lesson.name << " has no number that a table knows";
        const std::set<std::string> shown = figure_names(lesson.texts.at("en"));
        const auto expect = [&](const std::string& figure) {
            EXPECT_TRUE(shown.contains(figure)) << lesson.name << " does not show " << figure;
        };
        for (const Strip& strip : lesson.strips) expect("strip:" + strip.name);
        for (const Plot& plot : lesson.plots) expect("plot:" + plot.name);
        EXPECT_EQ(std::ranges::count_if(
                      shown, [](const std::string& f) { return f.starts_with("live:"); }),
                  1)
            << lesson.name;
    }
}

/// What a table of tests/data has for the inputs; none where no row has them.
std::optional<double> value_in(const TableRow& wanted) {
    for (const test::ReferenceRow& row : test::reference_rows(wanted.table)) {
        bool matches = row.numbers.contains(wanted.output);
        for (const auto& [column, value] : wanted.inputs.items()) {
            if (value.is_string())
                matches = matches && row.texts.contains(column) && row.texts.at(column) == value;
            else
                matches = matches && row.numbers.contains(column) &&
                          std::fabs(row.numbers.at(column) - value.get<double>()) < 1e-9;
        }
        if (matches) return row[wanted.output];
    }
    return std::nullopt;
}

TEST(Lessons, ComputeWhatTheReferenceTablesSay) {
    Answers answers;
    int checked = 0;
    for (const Lesson& lesson : lessons())
        for (const Number& number : lesson.numbers) {
            if (!number.reference) continue;
            const auto truth = value_in(*number.reference);
            ASSERT_TRUE(truth) << lesson.name << " " << number.name << ": no such row";
            // Sums over a spectrum depend on the data's step; the rest is quadrature.
            const bool is_spectral = number.ask.what == "metal" || number.ask.what == "blackbody";
            EXPECT_NEAR(answers(number.ask), *truth, is_spectral ? 5e-3 : 2e-4)
                << lesson.name << " " << number.name;
            ++checked;
        }
    EXPECT_GE(checked, 30);
}

TEST(Lessons, SetTheirFormulasAndPlots) {
    Answers answers;
    for (const Lesson& lesson : lessons()) {
        for (const auto& [language, text] : lesson.texts) {
            const auto html =
                html_of(text, [](const Figure&) -> base::Result<std::string> { return ""; });
            EXPECT_TRUE(html) << lesson.name << " " << language << ": "
                              << base::to_line(html.error());
        }
        for (const Plot& plot : lesson.plots) {
            Plot small = plot;  // errors of estimates take long
            if (small.variable == "samples") small.x.high = 8;
            const image::Figure figure = figure_of(small, "en", answers);
            for (const image::Curve& curve : figure.curves)
                EXPECT_GE(curve.points.size(), 4U)
                    << lesson.name << " " << plot.name << " " << curve.name;
        }
    }
}

TEST(Lessons, TellWhatIsWrongWithThem) {
    struct Case {
        const char* json;
        const char* where;
    };
    for (
        const Case& c : {
            Case{"{", ""},
            Case{"[]", ""},
            Case{R"({"facet": 2})", "/facet"},
            Case{R"({"facet": 1, "plot": {}})", "/plot"},
            Case{R"({"facet": 1, "strips": {"s": {"size": [0, 1]}}})", "/strips/s/size"},
            Case{R"({"facet": 1, "strips": {"s": {"rough": 1}}})", "/strips/s/rough"},
            Case{R"({"facet": 1, "strips": {"s": {"show": "Q"}}})", "/strips/s/show"},
            Case{R"({"facet": 1, "strips": {"s": {"over": {"values": [1]}}}})", "/strips/s/over"},
            Case{R"({"facet": 1, "strips": {"s": {"label": {"en": "x"}}}})", "/strips/s/label"},
            Case{R"({"facet": 1, "plots": {"p": {"over": "x", "curves": [{}]}}})", "/plots/p/over"},
            Case{R"({"facet": 1, "plots": {"p": {"over": "theta", "curves": []}}})",
                 "/plots/p/curves"},
            Case{R"({"facet": 1, "plots": {"p": {"over": "theta", "curves": [{"ask": "Z"}]}}})",
                 "/plots/p/curves/0/ask"},
            Case{R"({"facet": 1, "plots": {"p": {"over": "theta", "curves": [{"roughness": 2}]}}})",
                 "/plots/p/curves/0/roughness"},
            Case{
                R"({"facet": 1, "plots": {"p": {"over": "theta", "curves": [{"brdf": "masking=x"}]}}})",
                "/plots/p/curves/0/brdf"},
            Case{R"({"facet": 1, "numbers": {"n": {"ask": "D"}}})", "/numbers/n/label"},
            Case{R"({"facet": 1, "numbers": {"n": {"label": "x", "metal": "lead"}}})",
                 "/numbers/n/metal"},
            Case{R"({"facet": 1, "live": {"sliders": ["rough"]}})", "/live/sliders"},
            Case{R"({"facet": 1, "live": {"curve": "Q"}})", "/live/curve"},
            Case{R"({"facet": 1, "live": {"models": ["x"]}})", "/live/models"},
            Case{R"({"facet": 1, "cover": {"strip": "s"}})", "/cover/strip"},
        }) {
        Lesson lesson;
        const auto parsed = parse_lesson(c.json, lesson);
        ASSERT_FALSE(parsed) << c.json;
        EXPECT_EQ(parsed.error().code, base::ErrorCode::input_invalid) << c.json;
        EXPECT_EQ(parsed.error().where, c.where) << c.json;
    }
}

TEST(Lessons, AnUnknownOneIsAnsweredWithTheNearest) {
    const auto lesson = find_lesson("fresnell");
    ASSERT_FALSE(lesson);
    EXPECT_EQ(lesson.error().code, base::ErrorCode::usage);
    EXPECT_NE(lesson.error().remedy.find("fresnel"), std::string::npos) << lesson.error().remedy;
}

TEST(Live, HasTheProgramsOwnTextAndEveryWord) {
    for (const std::string_view language : base::languages) {
        const auto texts = base::Texts::load(language);
        ASSERT_TRUE(texts);
        for (const Lesson& lesson : lessons()) {
            const auto config = live_config(*lesson.live, *texts);
            ASSERT_TRUE(config) << base::to_line(config.error());
            EXPECT_EQ(config->dump().find("teach."), std::string::npos)
                << lesson.name << " lacks a word";
            const std::string brdf = (*config)["shaders"]["generated/brdf.glsl"];
            for (const char* function : {"real d_ggx(", "real f_dielectric(", "real3 diffuse_eon(",
                                         "uniform int chosen_masking", "BrdfValue brdf_light("})
                EXPECT_NE(brdf.find(function), std::string::npos) << function;
        }
    }
}

}  // namespace
}  // namespace facet::teach
