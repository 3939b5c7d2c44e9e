// The document: edits as settings, undo and redo, and the command that says the same.
// SPDX-License-Identifier: MIT
#include "studio/document.h"

#include "base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace facet::studio {
namespace {

TEST(Document, ALaterValueOfAPathTakesTheEarlierOnesPlace) {
    tables::Settings settings;
    set_path(settings, "material[0].roughness", "0.5");
    set_path(settings, "material[0].metallic", "1");
    set_path(settings, "material[0].roughness", "0.2");
    EXPECT_EQ(settings.set,
              (std::vector<std::string>{"material[0].metallic=1", "material[0].roughness=0.2"}));
    EXPECT_TRUE(has_path(settings, "material[0]."));
    EXPECT_FALSE(has_path(settings, "material[1]."));
    clear_path(settings, "material[0].");
    EXPECT_TRUE(settings.set.empty());
}

TEST(Document, EveryFloatIsSaidInDecimalsThatReadBackToIt) {
    std::mt19937 random(3);
    for (int i = 0; i < 100'000; ++i) {
        const float value =
            std::ldexp(static_cast<float>(random()), static_cast<int>(random() % 60) - 60);
        const auto read = base::parse_number(number_text(value));
        ASSERT_TRUE(read);
        ASSERT_EQ(static_cast<float>(*read), value) << number_text(value);
    }
}

TEST(History, TwoHundredStepsGoBackAndForthToTheSameSettings) {
    tables::Settings settings;
    History history;
    std::vector<tables::Settings> states{settings};
    for (int i = 0; i < 200; ++i) {
        const tables::Settings before = settings;
        set_path(settings, material_path(static_cast<std::size_t>(i % 7), "roughness"),
                 number_text(static_cast<float>(i) / 200.0F));
        history.record("edit", before);
        history.seal();
        states.push_back(settings);
    }
    EXPECT_EQ(history.undo_count(), 200U);
    for (std::size_t i = 200; i-- > 0;) {
        history.undo(settings);
        ASSERT_TRUE(settings == states[i]);
    }
    EXPECT_FALSE(history.can_undo());
    for (std::size_t i = 1; i <= 200; ++i) {
        history.redo(settings);
        ASSERT_TRUE(settings == states[i]);
    }
    EXPECT_FALSE(history.can_redo());
}

TEST(History, ADragIsOneStepAndTheViewIsNone) {
    tables::Settings settings;
    History history;
    for (int i = 0; i < 30; ++i) {
        const tables::Settings before = settings;
        settings.env_rotation = static_cast<float>(i);
        history.record("env_rotation", before);
    }
    history.seal();
    EXPECT_EQ(history.undo_count(), 1U);
    settings.camera = "orbit:azimuth=10";
    history.undo(settings);
    EXPECT_EQ(settings.env_rotation, 0.0F);
    EXPECT_EQ(settings.camera, "orbit:azimuth=10") << "where one looks from is not undone";
}

TEST(History, StepsThatCameToNothingAreForgotten) {
    tables::Settings settings;
    History history;
    history.record("a", settings);
    history.seal();
    history.record("b", settings);
    history.keep(1);
    EXPECT_EQ(history.undo_count(), 1U);
    EXPECT_EQ(history.last_name(), "a");
}

TEST(History, AnEditForgetsWhatWasUndone) {
    tables::Settings settings;
    History history;
    const auto edit = [&](float value) {
        const tables::Settings before = settings;
        settings.env_intensity = value;
        history.record("env_intensity", before);
        history.seal();
    };
    edit(2.0F);
    history.undo(settings);
    edit(3.0F);
    EXPECT_FALSE(history.can_redo());
    history.undo(settings);
    EXPECT_EQ(settings.env_intensity, 1.0F);
}

}  // namespace
}  // namespace facet::studio
