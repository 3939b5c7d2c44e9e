// --brdf values: what is accepted, and what a misspelt one is told.
// SPDX-License-Identifier: MIT
#include "brdf/choice.h"

#include <gtest/gtest.h>

#include <unordered_set>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;

TEST(BrdfChoice, NothingIsTheDefaultModel) {
    const auto choice = parse_choice("", Use::render);
    ASSERT_TRUE(choice);
    EXPECT_EQ(*choice, BrdfChoice{});
    EXPECT_EQ(choice->distribution, tables::Distribution::ggx);
    EXPECT_EQ(choice->masking, tables::Masking::smith_correlated);
    EXPECT_EQ(choice->fresnel, tables::Fresnel::schlick);
    EXPECT_EQ(choice->diffuse, tables::Diffuse::lambert);
    EXPECT_EQ(choice->multiscatter, tables::Multiscatter::on);
}

TEST(BrdfChoice, EveryListedTermIsAcceptedWithDashes) {
    for (const tables::BrdfTerm& term : tables::brdf_terms) {
        if (!term.notes.follows.empty()) continue;
        std::string name(term.name);
        std::replace(name.begin(), name.end(), '_', '-');
        const auto choice = parse_choice(std::string(term.slot) + "=" + name, Use::lesson);
        ASSERT_TRUE(choice) << term.slot << "=" << name << ": " << base::to_line(choice.error());
        const auto slot = std::find_if(tables::brdf_slots.begin(), tables::brdf_slots.end(),
                                       [&](const auto& s) { return s.key == term.slot; });
        ASSERT_NE(slot, tables::brdf_slots.end());
        // The index counts the rows of the slot: the chosen row is the one that was asked for.
        std::size_t left = slot->index(*choice);
        for (const tables::BrdfTerm& row : tables::brdf_terms)
            if (row.slot == term.slot && left-- == 0) {
                EXPECT_EQ(row.name, term.name);
                break;
            }
    }
}

TEST(BrdfChoice, CommasAndSemicolonsSeparateAndTheLastWins) {
    const auto choice =
        parse_choice("distribution=beckmann; fresnel=dielectric,fresnel=f82", Use::render);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->distribution, tables::Distribution::beckmann);
    EXPECT_EQ(choice->fresnel, tables::Fresnel::f82);
}

TEST(BrdfChoice, MaskingIsForLightsAndEnvironmentAlike) {
    const auto choice = parse_choice("masking=smith", Use::render);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->environment_masking, tables::Masking::smith);
}

TEST(BrdfChoice, TheLecturesSetTakesDirectForLightsAndIblForTheEnvironment) {
    const auto choice = parse_choice("lecture", Use::render);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->masking, tables::Masking::schlick_direct);
    EXPECT_EQ(choice->environment_masking, tables::Masking::schlick_ibl);
    EXPECT_EQ(choice->multiscatter, tables::Multiscatter::off);
    EXPECT_EQ(choice->width, tables::Width::squared);
}

TEST(BrdfChoice, TheLiteralReadingIsForLessonsOnly) {
    EXPECT_EQ(parse_choice("lecture-literal", Use::lesson)->width, tables::Width::literal);
    for (const char* text : {"lecture-literal", "distribution=blinn-phong", "width=literal"}) {
        const auto refused = parse_choice(text, Use::render);
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().code, base::ErrorCode::usage) << text;
    }
}

TEST(BrdfChoice, AMisspeltNameIsAnsweredWithTheNearest) {
    const auto term = parse_choice("distribution=gxx", Use::render);
    ASSERT_FALSE(term);
    EXPECT_EQ(term.error().code, base::ErrorCode::usage);
    EXPECT_NE(term.error().remedy.find("ggx"), std::string::npos) << term.error().remedy;
    const auto slot = parse_choice("maskin=smith", Use::render);
    ASSERT_FALSE(slot);
    EXPECT_NE(slot.error().remedy.find("masking"), std::string::npos) << slot.error().remedy;
    const auto word = parse_choice("lectur", Use::render);
    ASSERT_FALSE(word);
    EXPECT_NE(word.error().remedy.find("lecture"), std::string::npos) << word.error().remedy;
}

TEST(BrdfChoice, AMissingValueIsAUsageError) {
    for (const char* text : {"distribution", "distribution=", "=ggx", "fresnel=schlick=f82"}) {
        const auto refused = parse_choice(text, Use::render);
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().code, base::ErrorCode::usage) << text;
        EXPECT_FALSE(refused.error().remedy.empty()) << text;
    }
}

TEST(BrdfChoice, DifferentChoicesHaveDifferentHashes) {
    std::unordered_set<std::size_t> hashes;
    std::size_t count = 0;
    for (const char* masking : {"masking=smith", "masking=none", "lecture", ""})
        for (const char* fresnel : {"fresnel=schlick", "fresnel=none", "fresnel=f82"})
            for (const char* multiscatter : {"multiscatter=on", "multiscatter=kulla-conty"}) {
                const std::string text = std::string(masking) + "," + fresnel + "," + multiscatter;
                hashes.insert(std::hash<BrdfChoice>{}(*parse_choice(text, Use::render)));
                ++count;
            }
    EXPECT_EQ(hashes.size(), count);
}

}  // namespace
}  // namespace facet::brdf
