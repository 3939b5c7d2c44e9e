// Checks of cameras and lights: numbers that only make sense together.
// SPDX-License-Identifier: MIT
#include "math/vector.h"
#include "scene/gltf/check.h"

#include <spdlog/fmt/fmt.h>

namespace facet::scene::gltf {
namespace {

void check_planes(const Json& view, const std::string& where, Problems& problems) {
    const auto near = number_at(view, "znear");
    const auto far = number_at(view, "zfar");
    if (near && far && *far <= *near)
        problems.error("CAMERA_ZFAR_LEQUAL_ZNEAR", where, "zfar is not beyond znear",
                       fmt::format("{} and {}", *far, *near));
}

void check_orthographic(const Json& view, const std::string& where, Problems& problems) {
    for (const char* const key : {"xmag", "ymag"}) {
        const auto size = number_at(view, key);
        if (size && *size == 0)
            problems.error("CAMERA_XMAG_YMAG_ZERO", where + "/" + key, "size of the view is 0");
        else if (size && *size < 0)
            problems.note(Severity::warning, "CAMERA_XMAG_YMAG_NEGATIVE", where + "/" + key,
                          "size of the view is negative", fmt::format("{}", *size));
    }
    check_planes(view, where, problems);
}

void check_perspective(const Json& view, const std::string& where, Problems& problems) {
    const auto yfov = number_at(view, "yfov");
    if (yfov && *yfov >= static_cast<double>(math::pi))
        problems.note(Severity::warning, "CAMERA_YFOV_GEQUAL_PI", where,
                      "angle of view is not below 180 degrees", fmt::format("{} rad", *yfov));
    check_planes(view, where, problems);
}

void check_camera(const Json& camera, const std::string& where, Problems& problems) {
    const Json* const orthographic = find(camera, "orthographic");
    const Json* const perspective = find(camera, "perspective");
    const std::string type = string_at(camera, "type");
    if (orthographic != nullptr && perspective != nullptr)
        problems.error("ONE_OF_MISMATCH", where, "camera is orthographic and perspective");
    if ((type == "orthographic" && orthographic == nullptr) ||
        (type == "perspective" && perspective == nullptr))
        problems.error("UNDEFINED_PROPERTY", where,
                       fmt::format("property '{}' must be defined", type));
    if (orthographic != nullptr)
        check_orthographic(*orthographic, where + "/orthographic", problems);
    if (perspective != nullptr) check_perspective(*perspective, where + "/perspective", problems);
}

void check_light(const Json& light, const std::string& where, Problems& problems) {
    const Json* const spot = find(light, "spot");
    const std::string type = string_at(light, "type");
    if (type == "spot" && spot == nullptr)
        problems.error("UNDEFINED_PROPERTY", where, "property 'spot' must be defined");
    if (type != "spot" && spot != nullptr)
        problems.note(Severity::information, "EXTRA_PROPERTY", where + "/spot",
                      "only spot lights have a cone");
    if (type == "directional" && find(light, "range") != nullptr)
        problems.note(Severity::information, "EXTRA_PROPERTY", where + "/range",
                      "a directional light has no range");
    if (spot == nullptr) return;
    const double inner = number_at(*spot, "innerConeAngle").value_or(0.0);
    const double outer =
        number_at(*spot, "outerConeAngle").value_or(static_cast<double>(math::pi) / 4.0);
    if (outer <= inner)
        problems.error("KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", where + "/spot/outerConeAngle",
                       "outer cone is not wider than the inner",
                       fmt::format("{} and {} rad", outer, inner));
}

}  // namespace

void check_cameras(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < count_at(asset.json, "cameras"); ++i)
        check_camera(*element_at(asset.json, "cameras", i), pointer_text("cameras", i), problems);
    const Json* const extension = find_path(asset.json, "extensions/KHR_lights_punctual");
    if (extension == nullptr) return;
    for (std::size_t i = 0; i < count_at(*extension, "lights"); ++i)
        check_light(*element_at(*extension, "lights", i),
                    fmt::format("/extensions/KHR_lights_punctual/lights/{}", i), problems);
}

}  // namespace facet::scene::gltf
