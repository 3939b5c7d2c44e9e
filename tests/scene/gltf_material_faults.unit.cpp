// The glTF importer on materials that contradict themselves, and on textures that are none.
// SPDX-License-Identifier: MIT
#include "image/write.h"
#include "tables/material.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <variant>

#include "gltf_faults.h"

namespace facet::test {
namespace {

/// The triangle with coordinates, a picture, and a material of these extensions.
Document wearing(const Json& extensions, const Json& more = Json::object()) {
    Document d = triangle();
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["TANGENT"] =
        d.floats("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 1, 1, 1, 0, 0});
    primitive(d)["material"] = 0;
    const auto png = image::encode(image::Image({2, 2}, 3, image::Sample::u8), {.metadata = {}});
    EXPECT_TRUE(png);
    const std::string_view bytes(reinterpret_cast<const char*>(png->data()), png->size());
    d.json["images"] = {{{"uri", "data:image/png;base64," + base64(bytes)}}};
    d.json["textures"] = {{{"source", 0}}};
    Json material = more;
    if (!extensions.empty()) material["extensions"] = extensions;
    for (const auto& [name, value] : extensions.items()) d.json["extensionsUsed"].push_back(name);
    d.json["materials"] = {material};
    return d;
}

Json map() { return {{"index", 0}}; }

/// A material, and the one warning about it.
struct Doubt {
    const char* name;
    Json extensions;
    std::string where;  ///< below /materials/0
    std::string word;
    Json more = Json::object();
};

const Json glass{{"transmissionFactor", 1}};
const Json leaf{{"diffuseTransmissionFactor", 1}};
const Json cloud{{"multiscatterColorFactor", {0.9, 0.9, 0.9}}};

std::vector<Doubt> doubts() {
    const std::string scatter = "/extensions/KHR_materials_volume_scatter";
    return {
        {"unlit and a coat",
         {{"KHR_materials_unlit", Json::object()},
          {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}},
         "/extensions",
         "unlit"},
        {"glossiness and a coat",
         {{"KHR_materials_pbrSpecularGlossiness", Json::object()},
          {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}},
         "/extensions",
         "exclude"},
        {"glossiness and an index",
         {{"KHR_materials_pbrSpecularGlossiness", Json::object()},
          {"KHR_materials_ior", {{"ior", 1.3}}}},
         "/extensions",
         "in for ior"},
        {"a volume without an entrance",
         {{"KHR_materials_volume", {{"thicknessFactor", 1}}}},
         "/extensions/KHR_materials_volume",
         "no light enters"},
        {"dispersion without a volume",
         {{"KHR_materials_dispersion", {{"dispersion", 1}}}, {"KHR_materials_transmission", glass}},
         "/extensions/KHR_materials_dispersion",
         "without a volume"},
        {"scatter without a volume",
         {{"KHR_materials_volume_scatter", cloud}, {"KHR_materials_diffuse_transmission", leaf}},
         scatter,
         "no volume"},
        {"scatter in a thin wall",
         {{"KHR_materials_volume_scatter", cloud},
          {"KHR_materials_diffuse_transmission", leaf},
          {"KHR_materials_volume", {{"attenuationDistance", 0.1}}}},
         scatter,
         "no thickness"},
        {"scatter without a way",
         {{"KHR_materials_volume_scatter", cloud},
          {"KHR_materials_diffuse_transmission", leaf},
          {"KHR_materials_volume", {{"thicknessFactor", 1}}}},
         scatter,
         "nothing"},
        {"a film from thick to thin",
         {{"KHR_materials_iridescence",
           {{"iridescenceFactor", 1},
            {"iridescenceThicknessMinimum", 800},
            {"iridescenceThicknessMaximum", 300},
            {"iridescenceThicknessTexture", map()}}}},
         "/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum",
         "above"},
        {"normals of no coat",
         {{"KHR_materials_clearcoat", {{"clearcoatNormalTexture", map()}}}},
         "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture",
         "not seen"},
        {"colors of no fibres",
         {{"KHR_materials_sheen", {{"sheenColorFactor", {0, 0, 0}}, {"sheenColorTexture", map()}}}},
         "/extensions/KHR_materials_sheen/sheenColorTexture",
         "not seen"},
        {"strength of no emission",
         {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5}}}},
         "/extensions/KHR_materials_emissive_strength",
         "black"},
        {"a cutoff that cuts nothing",
         Json::object(),
         "/alphaCutoff",
         "MASK",
         {{"alphaCutoff", 0.4}}},
        {"an index between 0 and 1",
         {{"KHR_materials_ior", {{"ior", 0.5}}}},
         "/extensions/KHR_materials_ior/ior",
         "at least 1"},
        {"anisotropy of a scatter",
         {{"KHR_materials_volume_scatter",
           {{"multiscatterColorFactor", {0.9, 0.9, 0.9}}, {"scatterAnisotropy", 2}}},
          {"KHR_materials_diffuse_transmission", leaf},
          {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", 0.1}}}},
         scatter + "/scatterAnisotropy",
         "clamped"},
        {"a share above 1",
         {{"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 3}}}},
         "/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor",
         "clamped"},
        {"a ramp that is not there",
         Json::object(),
         "/extras/facet/fresnel_ramp/texture",
         "no such texture",
         {{"extras", {{"facet", {{"fresnel_ramp", {{"texture", {{"index", 7}}}}}}}}}}},
    };
}

/// Every number of it is within the table's range, and so no NaN.
void expect_in_range(const tables::MaterialValues& values) {
    for (const tables::MaterialParam& param : tables::material_params) {
        const auto holds = [&](float value) {
            EXPECT_TRUE(value >= static_cast<float>(param.range.low) &&
                        value <= static_cast<float>(param.range.high))
                << param.key << " " << value;
        };
        if (const auto* const number = std::get_if<float tables::MaterialValues::*>(&param.field))
            holds(values.**number);
        else
            for (int i = 0; i < 3; ++i)
                holds((values.*std::get<tables::Color tables::MaterialValues::*>(param.field))[i]);
    }
}

TEST(GltfMaterialFaults, what_is_said_in_vain_is_one_warning_at_its_place) {
    for (const Doubt& doubt : doubts()) {
        SCOPED_TRACE(doubt.name);
        const scene::Loaded loaded = loaded_or_fail(wearing(doubt.extensions, doubt.more));
        ASSERT_EQ(loaded.warnings.size(), 1U);
        EXPECT_EQ(loaded.warnings[0].where, "/materials/0" + doubt.where);
        EXPECT_NE(loaded.warnings[0].what.find(doubt.word), std::string::npos)
            << base::to_line(loaded.warnings[0]);
        expect_in_range(loaded.scene.materials[0].values);
    }
}

TEST(GltfMaterialFaults, what_goes_together_is_no_warning) {
    const Json volume{{"thicknessFactor", 1}, {"attenuationDistance", 0.1}};
    for (const Json& extensions :
         {Json{{"KHR_materials_volume", volume}, {"KHR_materials_diffuse_transmission", leaf}},
          Json{{"KHR_materials_volume", volume},
               {"KHR_materials_transmission", glass},
               {"KHR_materials_volume_scatter", cloud},
               {"KHR_materials_dispersion", {{"dispersion", 1}}}},
          // Without a texture the thickness is the greatest, whatever the default of the least.
          Json{{"KHR_materials_iridescence",
                {{"iridescenceFactor", 1}, {"iridescenceThicknessMaximum", 50}}}},
          // What exporters write of every material.
          Json{{"KHR_materials_clearcoat",
                {{"clearcoatFactor", 0}, {"clearcoatRoughnessFactor", 0.03}}}}})
        for (const base::Warning& warning : loaded_or_fail(wearing(extensions)).warnings)
            ADD_FAILURE() << base::to_line(warning);
}

TEST(GltfMaterialFaults, numbers_without_measure_leave_none_in_the_scene) {
    for (const Json& extensions :
         {Json{{"KHR_materials_ior", {{"ior", 1e300}}},
               {"KHR_materials_specular", {{"specularColorFactor", {1e38, -1, 1e300}}}}},
          Json{{"KHR_materials_volume",
                {{"thicknessFactor", 1e300},
                 {"attenuationDistance", 1e-300},
                 {"attenuationColor", {0, 2, -1}}}},
               {"KHR_materials_dispersion", {{"dispersion", 1e300}}}},
          Json{{"KHR_materials_anisotropy", {{"anisotropyRotation", -1e300}}},
               {"KHR_materials_iridescence",
                {{"iridescenceIor", 0}, {"iridescenceThicknessMaximum", 1e300}}}},
          Json{{"KHR_materials_pbrSpecularGlossiness",
                {{"diffuseFactor", {1e300, -1, 0, 5}}, {"glossinessFactor", -1e300}}}}}) {
        const scene::Loaded loaded = loaded_or_fail(wearing(extensions));
        EXPECT_FALSE(loaded.warnings.empty()) << extensions;
        expect_in_range(loaded.scene.materials[0].values);
    }
}

TEST(GltfMaterialFaults, a_number_out_of_range_is_told_once) {
    const scene::Loaded loaded = loaded_or_fail(wearing(
        Json::object(),
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {2, -1, 0, 5}}, {"metallicFactor", -1}, {"roughnessFactor", 9}}}}));
    EXPECT_EQ(loaded.warnings.size(), 5U);
    for (const base::Warning& warning : loaded.warnings)
        EXPECT_NE(warning.what.find("clamped"), std::string::npos) << base::to_line(warning);
}

TEST(GltfMaterialFaults, an_index_between_0_and_1_becomes_1_and_0_stays) {
    for (const auto& [given, held] : {std::pair(0.5, 1.0F), std::pair(0.0, 0.0F)})
        EXPECT_EQ(loaded_or_fail(wearing({{"KHR_materials_ior", {{"ior", given}}}}))
                      .scene.materials[0]
                      .values.ior,
                  held);
}

TEST(GltfMaterialFaults, the_older_name_of_the_scattered_color_is_read_too) {
    const auto color_of = [](const Json& scatter) {
        return loaded_or_fail(wearing({{"KHR_materials_volume_scatter", scatter},
                                       {"KHR_materials_transmission", glass},
                                       {"KHR_materials_volume",
                                        {{"thicknessFactor", 1}, {"attenuationDistance", 1}}}}))
            .scene.materials[0]
            .values.scatter_color;
    };
    const Json color{0.5, 0.25, 0.125};
    EXPECT_EQ(color_of({{"multiscatterColor", color}}), math::Vec3(0.5F, 0.25F, 0.125F));
    EXPECT_EQ(color_of({{"multiscatterColor", {1, 1, 1}}, {"multiscatterColorFactor", color}}),
              math::Vec3(0.5F, 0.25F, 0.125F));
}

TEST(GltfMaterialFaults, a_transform_without_measure_moves_nothing) {
    const std::string where = "/pbrMetallicRoughness/baseColorTexture";
    for (const Json& transform :
         {Json{{"offset", {3e38, 0}}}, Json{{"offset", {0, 1e300}}}, Json{{"rotation", 1e300}},
          Json{{"scale", {1e38, 1}}, {"rotation", 1e5}}}) {
        Document d = wearing(Json::object());
        d.json["extensionsUsed"] = {"KHR_texture_transform"};
        d.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
            {"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
        const scene::Loaded loaded = loaded_or_fail(d);
        ASSERT_EQ(loaded.warnings.size(), 1U) << transform;
        EXPECT_EQ(loaded.warnings[0].where,
                  "/materials/0" + where + "/extensions/KHR_texture_transform");
        const auto& texture =
            loaded.scene.materials[0].texture(tables::TextureSlot::base_color_texture);
        ASSERT_TRUE(texture.has_value());
        EXPECT_EQ(texture->uv_from_uv, math::Mat3(1.0F));
    }
}

TEST(GltfMaterialFaults, of_two_variants_of_one_name_the_second_is_told) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_variants"};
    d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "a"}}, {{"name", "a"}}};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_EQ(loaded.warnings[0].where, "/extensions/KHR_materials_variants/variants/1/name");
}

TEST(GltfMaterialFaults, what_cannot_be_meant_is_an_error_at_its_place) {
    const auto with = [](const Json& extensions) {
        return [extensions](Document& d) { d = wearing(extensions); };
    };
    const auto mapped = [](const Json& mapping) {
        return [mapping](Document& d) {
            d.json["extensionsUsed"] = {"KHR_materials_variants"};
            d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "a"}}};
            d.json["materials"] = {Json::object()};
            primitive(d)["extensions"]["KHR_materials_variants"]["mappings"] = {mapping};
        };
    };
    const std::string leaf_path = "/materials/0/extensions/KHR_materials_diffuse_transmission";
    const std::string use = "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0";
    const std::vector<Fault> faults{
        {"an extension that is a number", with({{"KHR_materials_clearcoat", 5}}), invalid,
         "/materials/0/extensions/KHR_materials_clearcoat"},
        {"a share that is a text",
         with({{"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", "x"}}}}),
         invalid, leaf_path + "/diffuseTransmissionFactor"},
        {"a color of two parts",
         with({{"KHR_materials_diffuse_transmission",
                {{"diffuseTransmissionColorFactor", {1, 1}}}}}),
         invalid, leaf_path + "/diffuseTransmissionColorFactor"},
        {"a texture that is not there",
         with({{"KHR_materials_diffuse_transmission",
                {{"diffuseTransmissionTexture", {{"index", 7}}}}}}),
         invalid, leaf_path + "/diffuseTransmissionTexture/index"},
        {"a texture without an index",
         with({{"KHR_materials_diffuse_transmission",
                {{"diffuseTransmissionTexture", Json::object()}}}}),
         invalid, leaf_path + "/diffuseTransmissionTexture"},
        {"a scatter that is a text",
         with({{"KHR_materials_volume_scatter", {{"multiscatterColorFactor", "x"}}}}), invalid,
         "/materials/0/extensions/KHR_materials_volume_scatter/multiscatterColorFactor"},
        {"a variant's material that is not there", mapped({{"material", 3}, {"variants", {0}}}),
         invalid, use + "/material"},
        {"a variant that is not there", mapped({{"material", 0}, {"variants", {4}}}), invalid,
         use + "/variants/0"},
    };
    for (const Fault& fault : faults) expect_fault(fault);
}

/// A PNG of these sides without any pixels.
std::string png_of(std::uint32_t width, std::uint32_t height) {
    std::string out("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16);
    for (const std::uint32_t side : {width, height})
        for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>(side >> shift);
    out += std::string("\x08\x02\0\0\0", 5);
    const uLong check = crc32(0, reinterpret_cast<const Bytef*>(out.data()) + 12, 17);
    for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>(check >> shift);
    return out + std::string("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
}

TEST(GltfMaterialFaults, pictures_that_are_none_are_white_or_no_normals_with_a_warning) {
    for (const char* const slot : {"baseColorTexture", "normalTexture"})
        for (const std::string& bytes :
             {std::string(), std::string("no picture"), png_of(0, 0), png_of(4, 0), png_of(64, 64),
              std::string("\xFF\xD8\xFF\xE0"), std::string("RIFF\4\0\0\0WEBP", 12)}) {
            Document d = wearing(Json::object());
            d.json["images"][0]["uri"] = "data:image/png;base64," + base64(bytes);
            Json& material = d.json["materials"][0];
            const bool is_normal = std::string_view(slot) == "normalTexture";
            (is_normal ? material : material["pbrMetallicRoughness"])[slot] = map();
            const scene::Loaded loaded = loaded_or_fail(d);
            ASSERT_EQ(loaded.warnings.size(), 1U) << bytes;
            EXPECT_EQ(loaded.warnings[0].where, "/images/0");
            EXPECT_EQ(loaded.scene.images[0].pixels, nullptr);
            EXPECT_EQ(
                loaded.scene.materials[0].texture(tables::TextureSlot::normal_texture).has_value(),
                false);
        }
}

TEST(GltfMaterialFaults, a_picture_of_huge_sides_is_a_limit_before_anything_is_allocated) {
    Document d = wearing(Json::object());
    d.json["images"][0]["uri"] = "data:image/png;base64," + base64(png_of(100'000, 100'000));
    d.json["materials"][0]["normalTexture"] = map();
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::limit_reached);
    EXPECT_EQ(loaded.error().where, "/images/0");
}

}  // namespace
}  // namespace facet::test
