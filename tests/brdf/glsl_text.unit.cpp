// The GLSL of a choice: which files it names, and that no file of glsl/brdf lies idle.
// SPDX-License-Identifier: MIT
#include "brdf/glsl_text.h"

#include "base/text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace facet::brdf {
namespace {

namespace fs = std::filesystem;
using tables::BrdfChoice;

const fs::path glsl = fs::path(FACET_SOURCE_DIR) / "glsl";

std::set<std::string> included(const std::string& text) {
    std::set<std::string> files;
    for (const std::string_view line : base::split(text, '\n'))
        if (line.starts_with("#include \"")) files.emplace(line.substr(10, line.size() - 11));
    return files;
}

TEST(BrdfGlslText, NamesOnlyFilesThatExistAndOnlyTheTermsOfTheChoice) {
    const auto text = glsl_text({});
    ASSERT_TRUE(text);
    const auto files = included(*text);
    for (const std::string& file : files) EXPECT_TRUE(fs::exists(glsl / file)) << file;
    EXPECT_TRUE(files.contains("brdf/d_ggx.glsl"));
    EXPECT_TRUE(files.contains("brdf/ms_turquin.glsl"));
    EXPECT_FALSE(files.contains("brdf/d_beckmann.glsl"));
    EXPECT_FALSE(files.contains("brdf/f_conductor.glsl"));
}

TEST(BrdfGlslText, FollowsTheDistributionWithItsMasking) {
    const auto text = glsl_text({.distribution = tables::Distribution::beckmann});
    ASSERT_TRUE(text);
    const auto files = included(*text);
    EXPECT_TRUE(files.contains("brdf/v_smith_beckmann_correlated.glsl"));
    EXPECT_FALSE(files.contains("brdf/v_smith_ggx_correlated.glsl"));
}

TEST(BrdfGlslText, DefinesEverySlotOnceForEveryChoice) {
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != slot.key) continue;
            BrdfChoice choice;
            std::size_t index = 0;
            for (const tables::BrdfTerm& row : tables::brdf_terms) {
                if (&row == &term) break;
                index += row.slot == slot.key ? 1U : 0U;
            }
            slot.set(choice, index);
            const auto text = glsl_text(choice, Parts::sampling);
            ASSERT_TRUE(text) << base::to_line(text.error());
            EXPECT_NE(text->find("return " + std::string(term.call) + ";"), std::string::npos)
                << slot.key << "=" << term.name;
            for (const tables::BrdfSlotFunction& function : tables::brdf_slot_functions) {
                const std::string head = std::string(function.signature) + " {";
                const std::size_t first = text->find(head);
                ASSERT_NE(first, std::string::npos) << head;
                EXPECT_EQ(text->find(head, first + 1), std::string::npos) << head;
            }
        }
}

TEST(BrdfGlslText, AsksForTheLightsAlbedoForKullaContyOnly) {
    EXPECT_NE(glsl_text({})->find("#define FACET_BRDF_NEEDS_E_L 0"), std::string::npos);
    EXPECT_NE(glsl_text({.multiscatter = tables::Multiscatter::kulla_conty})
                  ->find("#define FACET_BRDF_NEEDS_E_L 1"),
              std::string::npos);
}

TEST(BrdfGlslText, EveryTermFileIsNamedByARowAndEveryRowsFileExists) {
    std::set<std::string> named;
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        for (const std::string_view file : base::split(term.files, ' '))
            if (!file.empty()) named.emplace(file);
    std::set<std::string> present;
    for (const auto& entry : fs::directory_iterator(glsl / "brdf"))
        if (entry.path().extension() == ".glsl" && entry.path().stem() != "prelude")
            present.insert(entry.path().stem().string());
    EXPECT_EQ(named, present);
}

}  // namespace
}  // namespace facet::brdf
