// Shapes of the extension objects known to the checks, and where each may stand.
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

/// Tables that refer to the shapes of the core are made at first use.
template <std::size_t count>
ObjectShape open_shape(std::string_view name, const std::array<Rule, count>& rules) {
    return {.name = name, .rules = rules};
}

constexpr auto unit(std::string_view name) {
    return Rule{.name = name, .kind = Kind::number, .low = 0, .high = 1};
}
constexpr auto not_negative(std::string_view name) {
    return Rule{.name = name, .kind = Kind::number, .low = 0};
}
Rule map(std::string_view name) {
    return {.name = name, .kind = Kind::object, .shape = &texture_info_shape()};
}
Rule normal_map(std::string_view name) {
    return {.name = name, .kind = Kind::object, .shape = &normal_texture_info_shape()};
}
constexpr auto unit_color(std::string_view name, std::string_view lengths = "3") {
    return Rule{.name = name, .kind = Kind::numbers, .low = 0, .high = 1, .lengths = lengths};
}

const ObjectShape& anisotropy() {
    static const std::array rules{unit("anisotropyStrength"),
                                  Rule{.name = "anisotropyRotation", .kind = Kind::number},
                                  map("anisotropyTexture")};
    static const ObjectShape shape = open_shape("anisotropy", rules);
    return shape;
}
const ObjectShape& clearcoat() {
    static const std::array rules{
        unit("clearcoatFactor"), map("clearcoatTexture"), unit("clearcoatRoughnessFactor"),
        map("clearcoatRoughnessTexture"), normal_map("clearcoatNormalTexture")};
    static const ObjectShape shape = open_shape("clearcoat", rules);
    return shape;
}
const ObjectShape& diffuse_transmission() {
    static const std::array rules{
        unit("diffuseTransmissionFactor"), map("diffuseTransmissionTexture"),
        unit_color("diffuseTransmissionColorFactor"), map("diffuseTransmissionColorTexture")};
    static const ObjectShape shape = open_shape("diffuseTransmission", rules);
    return shape;
}
const ObjectShape& dispersion() {
    static const std::array rules{not_negative("dispersion")};
    static const ObjectShape shape = open_shape("dispersion", rules);
    return shape;
}
const ObjectShape& emissive_strength() {
    static const std::array rules{not_negative("emissiveStrength")};
    static const ObjectShape shape = open_shape("emissiveStrength", rules);
    return shape;
}
const ObjectShape& ior() {
    // 0 or at least 1; the gap is checked with the materials.
    static const std::array rules{not_negative("ior")};
    static const ObjectShape shape = open_shape("ior", rules);
    return shape;
}
const ObjectShape& iridescence() {
    static const std::array rules{unit("iridescenceFactor"),
                                  map("iridescenceTexture"),
                                  Rule{.name = "iridescenceIor", .kind = Kind::number, .low = 1},
                                  not_negative("iridescenceThicknessMinimum"),
                                  not_negative("iridescenceThicknessMaximum"),
                                  map("iridescenceThicknessTexture")};
    static const ObjectShape shape = open_shape("iridescence", rules);
    return shape;
}
const ObjectShape& specular_glossiness() {
    static const std::array rules{unit_color("diffuseFactor", "4"), map("diffuseTexture"),
                                  unit_color("specularFactor"), unit("glossinessFactor"),
                                  map("specularGlossinessTexture")};
    static const ObjectShape shape = open_shape("specularGlossiness", rules);
    return shape;
}
const ObjectShape& sheen() {
    static const std::array rules{unit_color("sheenColorFactor"), map("sheenColorTexture"),
                                  unit("sheenRoughnessFactor"), map("sheenRoughnessTexture")};
    static const ObjectShape shape = open_shape("sheen", rules);
    return shape;
}
const ObjectShape& specular() {
    static const std::array rules{
        unit("specularFactor"), map("specularTexture"),
        Rule{.name = "specularColorFactor", .kind = Kind::numbers, .low = 0, .lengths = "3"},
        map("specularColorTexture")};
    static const ObjectShape shape = open_shape("specular", rules);
    return shape;
}
const ObjectShape& transmission() {
    static const std::array rules{unit("transmissionFactor"), map("transmissionTexture")};
    static const ObjectShape shape = open_shape("transmission", rules);
    return shape;
}
const ObjectShape& volume() {
    static const std::array rules{
        not_negative("thicknessFactor"), map("thicknessTexture"),
        Rule{.name = "attenuationDistance", .kind = Kind::number, .low = 0, .excludes_low = true},
        unit_color("attenuationColor")};
    static const ObjectShape shape = open_shape("volume", rules);
    return shape;
}
const ObjectShape& volume_scatter() {
    static const std::array rules{unit_color("multiscatterColorFactor"),
                                  unit_color("multiscatterColor"),  // of older drafts
                                  Rule{.name = "scatterAnisotropy",
                                       .kind = Kind::number,
                                       .low = -1,
                                       .high = 1,
                                       .excludes_low = true,
                                       .excludes_high = true}};
    static const ObjectShape shape = open_shape("volumeScatter", rules);
    return shape;
}
const ObjectShape& empty() {
    static const ObjectShape shape{.name = "empty", .rules = {}};
    return shape;
}

const ObjectShape& spot() {
    static constexpr double half_pi = 1.5707963267948966;
    static const std::array rules{Rule{.name = "innerConeAngle",
                                       .kind = Kind::number,
                                       .low = 0,
                                       .high = half_pi,
                                       .excludes_high = true},
                                  Rule{.name = "outerConeAngle",
                                       .kind = Kind::number,
                                       .low = 0,
                                       .high = half_pi,
                                       .excludes_low = true}};
    static const ObjectShape shape = open_shape("spot", rules);
    return shape;
}
const ObjectShape& lights() {
    static const std::array light_rules{
        unit_color("color"), not_negative("intensity"),
        Rule{.name = "spot", .kind = Kind::object, .shape = &spot()},
        Rule{.name = "type",
             .kind = Kind::string,
             .is_required = true,
             .words = "directional|point|spot"},
        Rule{.name = "range", .kind = Kind::number, .low = 0, .excludes_low = true}};
    static const ObjectShape light = open_shape("light", light_rules);
    static const std::array rules{
        Rule{.name = "lights", .kind = Kind::objects, .is_required = true, .shape = &light}};
    static const ObjectShape shape = open_shape("lights", rules);
    return shape;
}
const ObjectShape& light_use() {
    static const std::array rules{Rule{.name = "light",
                                       .kind = Kind::integer,
                                       .is_required = true,
                                       .refers_to = "extensions/KHR_lights_punctual/lights"}};
    static const ObjectShape shape = open_shape("lightUse", rules);
    return shape;
}
const ObjectShape& variants() {
    static const std::array variant_rules{
        Rule{.name = "name", .kind = Kind::string, .is_required = true}};
    static const ObjectShape variant = open_shape("variant", variant_rules);
    static const std::array rules{
        Rule{.name = "variants", .kind = Kind::objects, .is_required = true, .shape = &variant}};
    static const ObjectShape shape = open_shape("variants", rules);
    return shape;
}
const ObjectShape& variant_use() {
    static const std::array mapping_rules{
        Rule{.name = "variants",
             .kind = Kind::integers,
             .is_required = true,
             .is_unique = true,
             .refers_to = "extensions/KHR_materials_variants/variants"},
        Rule{.name = "material",
             .kind = Kind::integer,
             .is_required = true,
             .refers_to = "materials"}};
    static const ObjectShape mapping = open_shape("variantMapping", mapping_rules);
    static const std::array rules{
        Rule{.name = "mappings", .kind = Kind::objects, .is_required = true, .shape = &mapping}};
    static const ObjectShape shape = open_shape("variantUse", rules);
    return shape;
}
const ObjectShape& texture_transform() {
    static const std::array rules{Rule{.name = "offset", .kind = Kind::numbers, .lengths = "2"},
                                  Rule{.name = "rotation", .kind = Kind::number},
                                  Rule{.name = "scale", .kind = Kind::numbers, .lengths = "2"},
                                  Rule{.name = "texCoord", .kind = Kind::integer, .low = 0}};
    static const ObjectShape shape = open_shape("textureTransform", rules);
    return shape;
}
const ObjectShape& webp() {
    static const std::array rules{
        Rule{.name = "source", .kind = Kind::integer, .refers_to = "images"}};
    static const ObjectShape shape = open_shape("webp", rules);
    return shape;
}
const ObjectShape& visibility() {
    static const std::array rules{Rule{.name = "visible", .kind = Kind::boolean}};
    static const ObjectShape shape = open_shape("visibility", rules);
    return shape;
}
const ObjectShape& animation_pointer() {
    static const std::array rules{
        Rule{.name = "pointer", .kind = Kind::string, .is_required = true}};
    static const ObjectShape shape = open_shape("animationPointer", rules);
    return shape;
}

}  // namespace

std::span<const ExtensionRule> extension_rules() {
    static const auto rules = std::to_array<ExtensionRule>(
        {{"KHR_materials_anisotropy", "material", &anisotropy()},
         {"KHR_materials_clearcoat", "material", &clearcoat()},
         {"KHR_materials_diffuse_transmission", "material", &diffuse_transmission()},
         {"KHR_materials_dispersion", "material", &dispersion()},
         {"KHR_materials_emissive_strength", "material", &emissive_strength()},
         {"KHR_materials_ior", "material", &ior()},
         {"KHR_materials_iridescence", "material", &iridescence()},
         {"KHR_materials_pbrSpecularGlossiness", "material", &specular_glossiness()},
         {"KHR_materials_sheen", "material", &sheen()},
         {"KHR_materials_specular", "material", &specular()},
         {"KHR_materials_transmission", "material", &transmission()},
         {"KHR_materials_unlit", "material", &empty()},
         {"KHR_materials_volume", "material", &volume()},
         {"KHR_materials_volume_scatter", "material", &volume_scatter()},
         {"KHR_lights_punctual", "document", &lights()},
         {"KHR_lights_punctual", "node", &light_use()},
         {"KHR_materials_variants", "document", &variants()},
         {"KHR_materials_variants", "primitive", &variant_use()},
         {"KHR_texture_transform", "textureInfo", &texture_transform()},
         {"KHR_node_visibility", "node", &visibility()},
         {"KHR_animation_pointer", "animationChannelTarget", &animation_pointer()},
         {"EXT_texture_webp", "texture", &webp()},
         {"KHR_draco_mesh_compression", "primitive", &draco_primitive_shape()},
         {"EXT_meshopt_compression", "buffer", &meshopt_buffer_shape()},
         {"EXT_meshopt_compression", "bufferView", &ext_meshopt_view_shape()},
         {"KHR_meshopt_compression", "buffer", &meshopt_buffer_shape()},
         {"KHR_meshopt_compression", "bufferView", &khr_meshopt_view_shape()},
         {"KHR_mesh_quantization", "", nullptr}});
    return rules;
}

}  // namespace facet::scene::gltf
