// Cameras and lights at the nodes they hang on; scale has no part in either.
// SPDX-License-Identifier: MIT
#include "scene/gltf/placed.h"

#include "scene/animate.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace facet::scene::gltf {

void place_camera(Import& import, std::uint32_t node_index, const Mat4& world_from_node) {
    const tinygltf::Node& node = import.model.nodes[node_index];
    const tinygltf::Camera& from = import.model.cameras[static_cast<std::size_t>(node.camera)];
    Camera to;
    to.node = node.name;
    to.name = !from.name.empty()   ? from.name
              : !node.name.empty() ? node.name
                                   : fmt::format("camera {}", node.camera);
    to.source_node = node_index;
    place(to, world_from_node);
    if (from.type == "orthographic") {
        to.projection = Projection::orthographic;
        to.ymag_m = static_cast<float>(std::fabs(from.orthographic.ymag));
        to.near_m = static_cast<float>(from.orthographic.znear);
        to.far_m = static_cast<float>(from.orthographic.zfar);
    } else {
        to.yfov_rad = static_cast<float>(from.perspective.yfov);
        to.near_m = static_cast<float>(from.perspective.znear);
        to.far_m = static_cast<float>(from.perspective.zfar);
    }
    import.scene.cameras.push_back(std::move(to));
}

void place_light(Import& import, std::uint32_t node_index, const Mat4& world_from_node) {
    const Json& json = *element_at(import.asset.json, "nodes", node_index);
    const Json* const use = find_path(json, "extensions/KHR_lights_punctual");
    const auto index = use != nullptr ? index_at(*use, "light") : std::nullopt;
    if (!index || *index >= import.model.lights.size()) return;
    const tinygltf::Light& from = import.model.lights[*index];
    Light to{.source_node = node_index};
    if (from.type == "directional")
        to.kind = tables::LightKind::directional;
    else if (from.type == "spot")
        to.kind = tables::LightKind::spot;
    else if (from.type == "point")
        to.kind = tables::LightKind::point;
    else
        return import.warn(fmt::format("/extensions/KHR_lights_punctual/lights/{}/type", *index),
                           "unknown kind of light is ignored", from.type);
    const std::string& node_name = import.model.nodes[node_index].name;
    to.name = !from.name.empty()   ? from.name
              : !node_name.empty() ? node_name
                                   : fmt::format("light {}", *index);
    if (from.color.size() == 3)
        to.color = Vec3(static_cast<float>(from.color[0]), static_cast<float>(from.color[1]),
                        static_cast<float>(from.color[2]));
    to.intensity = static_cast<float>(from.intensity);
    if (const Json* const lights =
            find_path(import.asset.json, "extensions/KHR_lights_punctual/lights");
        lights != nullptr && *index < lights->size()) {
        const Json* const stands_in = find_path((*lights)[*index], "extras/facet/stands_in");
        to.stands_in = stands_in != nullptr && *stands_in == true;
    }
    place(to, world_from_node);
    to.range_m = static_cast<float>(from.range);
    to.inner_cone_rad = static_cast<float>(from.spot.innerConeAngle);
    to.outer_cone_rad = static_cast<float>(from.spot.outerConeAngle);
    import.scene.lights.push_back(std::move(to));
}

}  // namespace facet::scene::gltf
