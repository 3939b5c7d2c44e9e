// Shapes of the extension objects that the Khronos validator knows, and where each may stand.
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

/// Tables that refer to the shapes of the core are made at first use.
template <std::size_t count>
Shape open_shape(std::string_view name, const std::array<Rule, count>& rules) {
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

const Shape& anisotropy() {
    static const std::array rules{unit("anisotropyStrength"),
                                  Rule{.name = "anisotropyRotation", .kind = Kind::number},
                                  map("anisotropyTexture")};
    static const Shape shape = open_shape("anisotropy", rules);
    return shape;
}
const Shape& clearcoat() {
    static const std::array rules{
        unit("clearcoatFactor"), map("clearcoatTexture"), unit("clearcoatRoughnessFactor"),
        map("clearcoatRoughnessTexture"), normal_map("clearcoatNormalTexture")};
    static const Shape shape = open_shape("clearcoat", rules);
    return shape;
}
const Shape& dispersion() {
    static const std::array rules{not_negative("dispersion")};
    static const Shape shape = open_shape("dispersion", rules);
    return shape;
}
const Shape& emissive_strength() {
    static const std::array rules{not_negative("emissiveStrength")};
    static const Shape shape = open_shape("emissiveStrength", rules);
    return shape;
}
const Shape& ior() {
    // 0 or at least 1; the gap is checked with the materials.
    static const std::array rules{not_negative("ior")};
    static const Shape shape = open_shape("ior", rules);
    return shape;
}
const Shape& iridescence() {
    static const std::array rules{unit("iridescenceFactor"),
                                  map("iridescenceTexture"),
                                  Rule{.name = "iridescenceIor", .kind = Kind::number, .low = 1},
                                  not_negative("iridescenceThicknessMinimum"),
                                  not_negative("iridescenceThicknessMaximum"),
                                  map("iridescenceThicknessTexture")};
    static const Shape shape = open_shape("iridescence", rules);
    return shape;
}
const Shape& specular_glossiness() {
    static const std::array rules{unit_color("diffuseFactor", "4"), map("diffuseTexture"),
                                  unit_color("specularFactor"), unit("glossinessFactor"),
                                  map("specularGlossinessTexture")};
    static const Shape shape = open_shape("specularGlossiness", rules);
    return shape;
}
const Shape& sheen() {
    static const std::array rules{unit_color("sheenColorFactor"), map("sheenColorTexture"),
                                  unit("sheenRoughnessFactor"), map("sheenRoughnessTexture")};
    static const Shape shape = open_shape("sheen", rules);
    return shape;
}
const Shape& specular() {
    static const std::array rules{
        unit("specularFactor"), map("specularTexture"),
        Rule{.name = "specularColorFactor", .kind = Kind::numbers, .low = 0, .lengths = "3"},
        map("specularColorTexture")};
    static const Shape shape = open_shape("specular", rules);
    return shape;
}
const Shape& transmission() {
    static const std::array rules{unit("transmissionFactor"), map("transmissionTexture")};
    static const Shape shape = open_shape("transmission", rules);
    return shape;
}
const Shape& volume() {
    static const std::array rules{
        not_negative("thicknessFactor"), map("thicknessTexture"),
        Rule{.name = "attenuationDistance", .kind = Kind::number, .low = 0, .excludes_low = true},
        unit_color("attenuationColor")};
    static const Shape shape = open_shape("volume", rules);
    return shape;
}
const Shape& empty() {
    static const Shape shape{.name = "empty", .rules = {}};
    return shape;
}

const Shape& spot() {
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
    static const Shape shape = open_shape("spot", rules);
    return shape;
}
const Shape& lights() {
    static const std::array light_rules{
        unit_color("color"), not_negative("intensity"),
        Rule{.name = "spot", .kind = Kind::object, .shape = &spot()},
        Rule{.name = "type",
             .kind = Kind::string,
             .is_required = true,
             .words = "directional|point|spot"},
        Rule{.name = "range", .kind = Kind::number, .low = 0, .excludes_low = true}};
    static const Shape light = open_shape("light", light_rules);
    static const std::array rules{
        Rule{.name = "lights", .kind = Kind::objects, .is_required = true, .shape = &light}};
    static const Shape shape = open_shape("lights", rules);
    return shape;
}
const Shape& light_use() {
    static const std::array rules{Rule{.name = "light",
                                       .kind = Kind::integer,
                                       .is_required = true,
                                       .refers_to = "extensions/KHR_lights_punctual/lights"}};
    static const Shape shape = open_shape("lightUse", rules);
    return shape;
}
const Shape& variants() {
    static const std::array variant_rules{
        Rule{.name = "name", .kind = Kind::string, .is_required = true}};
    static const Shape variant = open_shape("variant", variant_rules);
    static const std::array rules{
        Rule{.name = "variants", .kind = Kind::objects, .is_required = true, .shape = &variant}};
    static const Shape shape = open_shape("variants", rules);
    return shape;
}
const Shape& variant_use() {
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
    static const Shape mapping = open_shape("variantMapping", mapping_rules);
    static const std::array rules{
        Rule{.name = "mappings", .kind = Kind::objects, .is_required = true, .shape = &mapping}};
    static const Shape shape = open_shape("variantUse", rules);
    return shape;
}
const Shape& texture_transform() {
    static const std::array rules{Rule{.name = "offset", .kind = Kind::numbers, .lengths = "2"},
                                  Rule{.name = "rotation", .kind = Kind::number},
                                  Rule{.name = "scale", .kind = Kind::numbers, .lengths = "2"},
                                  Rule{.name = "texCoord", .kind = Kind::integer, .low = 0}};
    static const Shape shape = open_shape("textureTransform", rules);
    return shape;
}
const Shape& webp() {
    static const std::array rules{
        Rule{.name = "source", .kind = Kind::integer, .refers_to = "images"}};
    static const Shape shape = open_shape("webp", rules);
    return shape;
}
const Shape& visibility() {
    static const std::array rules{Rule{.name = "visible", .kind = Kind::boolean}};
    static const Shape shape = open_shape("visibility", rules);
    return shape;
}
const Shape& animation_pointer() {
    static const std::array rules{
        Rule{.name = "pointer", .kind = Kind::string, .is_required = true}};
    static const Shape shape = open_shape("animationPointer", rules);
    return shape;
}

}  // namespace

std::span<const ExtensionRule> extension_rules() {
    static const auto rules = std::to_array<ExtensionRule>(
        {{"KHR_materials_anisotropy", "material", &anisotropy()},
         {"KHR_materials_clearcoat", "material", &clearcoat()},
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
         {"KHR_lights_punctual", "document", &lights()},
         {"KHR_lights_punctual", "node", &light_use()},
         {"KHR_materials_variants", "document", &variants()},
         {"KHR_materials_variants", "primitive", &variant_use()},
         {"KHR_texture_transform", "textureInfo", &texture_transform()},
         {"KHR_node_visibility", "node", &visibility()},
         {"KHR_animation_pointer", "animationChannelTarget", &animation_pointer()},
         {"EXT_texture_webp", "texture", &webp()},
         {"KHR_mesh_quantization", "", nullptr}});
    return rules;
}

}  // namespace facet::scene::gltf
