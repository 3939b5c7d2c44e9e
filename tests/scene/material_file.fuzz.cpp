// Material files of hostile bytes: they end, and give numbers within their ranges or an error.
// SPDX-License-Identifier: MIT
#include "scene/material_file.h"

#include <gtest/gtest.h>

#include <random>

namespace facet::scene {
namespace {

constexpr std::string_view material_seeds[] = {
    R"({"facet":1,"name":"a","base_color":[0.1,0.2,0.3],"metallic":1,"roughness":0.5})",
    R"({"facet":1,"alpha_mode":"mask","double_sided":true,"emissive_strength":1e9})",
    R"({"facet":1,"base_color":[1e400,-0,null],"opacity":[[[[]]]]})"};

TEST(MaterialFileFuzz, GivesNumbersInRangeOrAnErrorForEveryMutation) {
    std::mt19937 random(7);
    for (int round = 0; round < 20'000; ++round) {
        std::string text(material_seeds[random() % std::size(material_seeds)]);
        for (std::uint_fast32_t edits = 1 + random() % 6; edits > 0; --edits)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        const auto file = parse_material(text, {});
        if (!file) continue;
        for (const tables::MaterialParam& param : tables::material_params)
            if (const auto* field = std::get_if<float tables::MaterialValues::*>(&param.field)) {
                ASSERT_GE(file->values.**field, static_cast<float>(param.range.low));
                ASSERT_LE(file->values.**field, static_cast<float>(param.range.high));
            }
    }
}

}  // namespace
}  // namespace facet::scene
