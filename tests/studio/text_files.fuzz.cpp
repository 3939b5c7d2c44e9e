// Scripts and kept work of hostile bytes: they end, with steps, a document or an error.
// SPDX-License-Identifier: MIT
#include "studio/recovery.h"
#include "studio/script.h"

#include <gtest/gtest.h>

#include <random>

namespace facet::studio {
namespace {

std::string mutated(std::mt19937& random, std::string text) {
    for (std::uint_fast32_t edits = 1 + random() % 6; edits > 0; --edits)
        text[random() % text.size()] = static_cast<char>(random() % 256);
    return text;
}

TEST(StudioFuzz, ScriptsNeverHaveMoreStepsThanLines) {
    std::mt19937 random(5);
    const std::string seed =
        "set \"material.A b.roughness\" 0.4\nclick save\n# note\ndrag roughness 0.2\nkey ctrl+z\n"
        "wait 3\nshot /tmp/a.png\nundo\nredo\ntype abc\nquit\n";
    for (int round = 0; round < 20'000; ++round) {
        const std::string text = mutated(random, seed);
        const auto steps = parse_script(text, "fuzz");
        if (!steps) continue;
        ASSERT_LE(steps->size(),
                  static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
    }
}

TEST(StudioFuzz, KeptWorkIsADocumentOrAnError) {
    std::mt19937 random(6);
    Document document{"a.glb", {}};
    document.settings.ev = 2.0F;
    document.settings.light = {"point:candela=3"};
    const std::string seed = recovery_text(document);
    for (int round = 0; round < 20'000; ++round) {
        const auto read = parse_recovery(mutated(random, seed));
        if (read) {
            ASSERT_LE(read->scene.size(), seed.size());
        }
    }
}

}  // namespace
}  // namespace facet::studio
