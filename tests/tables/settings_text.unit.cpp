// Settings as texts: what a command says is what is read back from it.
// SPDX-License-Identifier: MIT
#include "tables/settings_text.h"

#include "tables/settings_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace facet::tables {
namespace {

TEST(SettingsText, TheCommandQuotesForAShellAndLeavesOutWhatIsInitial) {
    Settings values;
    EXPECT_EQ(command_line(command_words("render", "my model.glb", values, "out.png")),
              "facet render 'my model.glb' -o out.png");
    values.env_rotation = 30.0F;
    values.no_file_lights = true;
    values.size = {64, 32};
    values.aov = {"normal", "depth"};
    values.set = {"material.It's.base_color=1 0 0"};
    EXPECT_EQ(command_line(command_words("render", "my model.glb", values, "o.png")),
              "facet render 'my model.glb' -o o.png --size 64x32 --aov normal,depth "
              "--env-rotation 30 --no-file-lights --set 'material.It'\\''s.base_color=1 0 0'");
}

TEST(SettingsText, EverySettingThatIsSaidIsTakenBack) {
    Settings values;
    values.size = {640, 480};
    values.ev = 3.5F;
    values.samples = 4;
    values.strict = true;
    values.env = "sky:turbidity=3";
    values.light = {"point:candela=2", "spot:candela=3"};
    Settings again;
    for (const Setting& row : tables::settings)
        if (const auto texts = texts_of(values, row); !texts.empty()) {
            ASSERT_TRUE(assign(again, row.key, texts)) << row.key;
        }
    EXPECT_TRUE(again == values);
}

TEST(SettingsJson, ReadsWhatAJobFileSays) {
    const auto json = nlohmann::ordered_json::parse(R"({
        "size": [64, 32], "env_rotation": 30, "no_file_lights": true, "aov": ["D", "G"], "camera": "front",
        "light": ["point:candela=2"],
        "set": {"material.*.roughness": 0.5, "material[0].base_color": [1, 0.5, 0], "light[0].name": "key"}})");
    Settings values;
    for (const auto& [key, value] : json.items())
        ASSERT_TRUE(assign_json(values, key, value)) << key;
    EXPECT_EQ(values.size, (Extent{64, 32}));
    EXPECT_EQ(values.env_rotation, 30.0F);
    EXPECT_TRUE(values.no_file_lights);
    EXPECT_EQ(values.aov, (List{"D", "G"}));
    EXPECT_EQ(values.light, (List{"point:candela=2"}));
    EXPECT_EQ(values.set, (List{"material.*.roughness=0.5", "material[0].base_color=1 0.5 0",
                                "light[0].name=key"}));
}

TEST(SettingsJson, NamesTheKeyThatItCannotTake) {
    Settings values;
    const auto unknown = assign_json(values, "sise", 3);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, base::ErrorCode::usage);
    EXPECT_NE(unknown.error().remedy.find("size"), std::string::npos) << unknown.error().remedy;
    for (const auto& [key, value] : std::vector<std::pair<std::string, nlohmann::ordered_json>>{
             {"size", {{"w", 1}}},
             {"size", "wide"},
             {"env_rotation", true},

             {"set", {{"a.b", {{"c", 1}}}}}})
        EXPECT_FALSE(assign_json(values, key, value)) << key << value.dump();
}

}  // namespace
}  // namespace facet::tables
