// An explanation as JSON.
// SPDX-License-Identifier: MIT
#include "explain/told.h"

#include <nlohmann/json.hpp>

namespace facet::explain {
namespace {

using Json = nlohmann::ordered_json;

Json json(const DVec3& v) { return Json::array({v.x, v.y, v.z}); }
Json json(const math::Vec4& v) { return Json::array({v.x, v.y, v.z}); }
Json json(const Contribution& c) {
    return {{"diffuse", json(c.diffuse)}, {"specular", json(c.specular)}, {"sum", json(c.sum())}};
}

Json json(const scene::Scene& scene, const shared::ExplainedLight& l) {
    const scene::Light& light = light_of(scene, l);
    return {{"name", light.name},
            {"kind", tables::light_kinds[static_cast<std::size_t>(light.kind)].key},
            {"to_light", json(l.to_light)},
            {"distance_m", l.to_light.w > 0.0F ? Json(l.to_light.w) : Json(nullptr)},
            {"illuminance_lux", json(l.illuminance_lux)},
            {"n_dot_l", l.cosines.x},
            {"n_dot_h", l.cosines.y},
            {"v_dot_h", l.cosines.z},
            {"D", l.d_g_v.x},
            {"G", l.d_g_v.y},
            {"V", l.d_g_v.z},
            {"F", json(l.f)},
            {"kd", json(l.k_d)},
            {"ks", json(l.k_s)},
            {"diffuse", json(l.diffuse)},
            {"specular", json(l.specular)},
            {"shadow", l.cosines.w},
            {"contribution", json(of_light(l))}};
}

Json json(const scene::Scene& scene, const frame::ExplainedPoint& point) {
    const shared::ExplainedSurface& s = point.surface;
    const scene::Material& material = scene.materials[s.ids.y - 1];
    Json lights = Json::array();
    for (const shared::ExplainedLight& light : point.lights) lights.push_back(json(scene, light));
    const Balance balance = balance_of(s);
    return {
        {"object", object_name(scene, s.ids.x)},
        {"material", material.name},
        {"unlit", s.ids.z != 0},
        {"opacity", s.base_color.w},
        {"position_m", json(s.position)},
        {"normal", json(s.normal)},
        {"to_eye", json(s.to_eye)},
        {"n_dot_v", s.normal.w},
        {"uv", Json::array({s.uv.x, s.uv.y})},
        {"base_color", json(s.base_color)},
        {"metallic", s.numbers.x},
        {"roughness", s.numbers.y},
        {"roughness_for_lights", s.numbers.w},
        {"ao", s.numbers.z},
        {"clearcoat", {{"strength", s.coat.x}, {"roughness", s.coat.y}, {"reflected", s.coat.z}}},
        {"sheen", {{"roughness", s.sheen.w}, {"reflected", json(s.sheen)}}},
        {"from_far_side_nit", json(s.far_nit)},
        {"emissive_nit", json(s.emissive_nit)},
        {"textures",
         {{"base_color",
           Json::array({s.base_texel.x, s.base_texel.y, s.base_texel.z, s.base_texel.w})},
          {"metallic", s.orm_texel.z},
          {"roughness", s.orm_texel.y},
          {"occlusion", s.orm_texel.x},
          {"normal", json(s.normal_texel)},
          {"bumps", s.normal_texel.w},
          {"emissive", json(s.emissive_texel)}}},
        {"lights", lights},
        {"environment",
         {{"irradiance_over_pi_nit", json(s.irradiance)},
          {"prefiltered_nit", json(s.prefiltered)},
          {"diffuse_weight", json(s.environment_diffuse)},
          {"specular_weight", json(s.environment_specular)},
          {"contribution", json(of_environment(s))}}},
        {"balance",
         {{"reflected", json(balance.reflected)},
          {"transmitted", json(balance.transmitted)},
          {"gone_through", json(balance.gone_through)},
          {"absorbed", json(balance.absorbed)}}},
        {"sum", json(shown_by(point))}};
}

Json json(const scene::Scene& scene, const frame::ExplainedPixel& sample) {
    Json out{{"offset_px", Json::array({sample.jitter_px.x, sample.jitter_px.y})},
             {"vignetting", sample.vignetting}};
    Json layers = Json::array();
    for (const frame::ExplainedPoint& layer : sample.blended) layers.push_back(json(scene, layer));
    if (sample.opaque) out["surface"] = json(scene, *sample.opaque);
    if (sample.background_nit) out["background_nit"] = json(DVec3(*sample.background_nit));
    if (!layers.empty()) out["over_it"] = layers;
    const Composite whole = composed(sample);
    out["alpha"] = whole.alpha;
    out["sum"] = json(whole.radiance);
    return out;
}

}  // namespace

std::string object_name(const scene::Scene& scene, std::uint32_t object_id) {
    for (const scene::Instance& instance : scene.instances)
        if (instance.object_id == object_id) return instance.node;
    return {};
}

const scene::Light& light_of(const scene::Scene& scene, const shared::ExplainedLight& light) {
    return scene.lights[light.which.y];
}

Json json_of(const Explained& explained, const Pixel& pixel) {
    Json samples = Json::array();
    for (const frame::ExplainedPixel& sample : pixel.samples)
        samples.push_back(json(explained.scene, sample));
    const std::size_t channels = pixel.alpha < 1.0 ? 4 : 3;
    Json code = Json::array();
    for (std::size_t c = 0; c < channels; ++c) code.push_back(pixel.code[c]);
    return {{"facet", 1},
            {"pixel", Json::array({pixel.x, pixel.y})},
            {"sum", json(pixel.sum)},
            {"alpha", pixel.alpha},
            {"exposure", explained.exposure},
            {"exposed", json(pixel.sum * explained.exposure)},
            {"white_balance_k",
             explained.white_balance_k ? Json(*explained.white_balance_k) : Json(nullptr)},
            {"tonemap", explained.tonemap},
            {"gamut", explained.gamut},
            {"bits", explained.bits},
            {"code", code},
            {"shown_sample", pixel.shown},
            {"samples", samples}};
}

}  // namespace facet::explain
