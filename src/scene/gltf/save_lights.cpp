// Edits of lights, written into a document.
// SPDX-License-Identifier: MIT
#include "scene/gltf/save_materials.h"
#include "tables/lights.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::scene::gltf {
namespace {

constexpr const char* lights_extension = "KHR_lights_punctual";

/// KHR_lights_punctual, section "Defining Lights".
OrderedJson definition_of(const Light& light) {
    const auto& row = tables::light_kinds[static_cast<std::size_t>(light.kind)];
    OrderedJson out = {{"name", light.name}, {"type", row.key}};
    if (light.color != Vec3(1.0F)) out["color"] = shortest(light.color);
    out["intensity"] = shortest(light.intensity);
    if (light.range_m > 0.0F) out["range"] = shortest(light.range_m);
    if (light.kind == tables::LightKind::spot)
        out["spot"] = {{"innerConeAngle", shortest(light.inner_cone_rad)},
                       {"outerConeAngle", shortest(light.outer_cone_rad)}};
    return out;
}

/// Turns -z to where the light shines.
math::Quat rotation_of(const Light& light) {
    const Vec3 from(0.0F, 0.0F, -1.0F);
    const float cosine = math::dot(from, light.direction);
    if (cosine > 0.999999F) return math::Quat(1.0F, 0.0F, 0.0F, 0.0F);
    if (cosine < -0.999999F) return math::Quat(0.0F, 0.0F, 1.0F, 0.0F);
    const Vec3 axis = math::cross(from, light.direction);
    const math::Quat q(1.0F + cosine, axis.x, axis.y, axis.z);
    return glm::normalize(q);
}

bool same_pose(const Light& a, const Light& b) {
    return a.position_m == b.position_m && a.direction == b.direction;
}
bool same_definition(const Light& a, const Light& b) {
    return a.name == b.name && a.color == b.color && a.intensity == b.intensity &&
           a.range_m == b.range_m && a.inner_cone_rad == b.inner_cone_rad &&
           a.outer_cone_rad == b.outer_cone_rad;
}

OrderedJson& lights_of(OrderedJson& json) {
    use_extension(json, lights_extension);
    OrderedJson& extensions = json["extensions"];
    if (!extensions.is_object()) extensions = OrderedJson::object();
    OrderedJson& own = extensions[lights_extension];
    if (!own.is_object()) own = OrderedJson::object();
    return array_at(own, "lights");
}

/// A node of its own for the light, in the scene that is shown.
void add_node(OrderedJson& json, const Light& light, std::size_t definition) {
    OrderedJson node = {{"name", light.name}};
    if (light.position_m != Vec3(0.0F)) node["translation"] = shortest(light.position_m);
    const math::Quat q = rotation_of(light);
    if (light.kind != tables::LightKind::point)
        node["rotation"] =
            OrderedJson::array({shortest(q.x), shortest(q.y), shortest(q.z), shortest(q.w)});
    node["extensions"][lights_extension]["light"] = definition;
    OrderedJson& nodes = array_at(json, "nodes");
    nodes.push_back(std::move(node));
    OrderedJson& scenes = array_at(json, "scenes");
    if (scenes.empty()) scenes.push_back(OrderedJson::object());
    const std::size_t shown = std::min(json.value("scene", std::size_t{0}), scenes.size() - 1);
    array_at(scenes[shown], "nodes").push_back(nodes.size() - 1);
}

void detach(OrderedJson& json, std::uint32_t node_index) {
    OrderedJson& node = json["nodes"][node_index];
    node["extensions"].erase(lights_extension);
    if (node["extensions"].empty()) node.erase("extensions");
}

void save_changed(OrderedJson& json, const Light& before, const Light& after) {
    const std::uint32_t node = *before.source_node;
    OrderedJson& lights = lights_of(json);
    auto definition =
        json["nodes"][node]["extensions"][lights_extension]["light"].get<std::size_t>();
    if (!same_definition(before, after)) {
        // Others may share it: a changed light gets a definition of its own, with the old one's
        // extras.
        OrderedJson own = definition_of(after);
        const OrderedJson old = lights[definition];
        for (const auto& [key, value] : old.items())
            if (key == "extras" || key == "extensions") own[key] = value;
        if (std::count_if(json["nodes"].begin(), json["nodes"].end(), [&](const OrderedJson& n) {
                return n.contains("extensions") && n["extensions"].contains(lights_extension) &&
                       n["extensions"][lights_extension].value("light", lights.size()) ==
                           definition;
            }) > 1) {
            lights.push_back(std::move(own));
            definition = lights.size() - 1;
        } else {
            lights[definition] = std::move(own);
        }
        json["nodes"][node]["extensions"][lights_extension]["light"] = definition;
    }
    if (same_pose(before, after)) return;
    detach(json, node);
    add_node(json, after, definition);
}

}  // namespace

void save_lights(Document& document, const Scene& original, const Scene& edited,
                 base::Warnings& warnings) {
    OrderedJson& json = document.json;
    const auto kept = [&](const Light& light) {
        return std::find_if(edited.lights.begin(), edited.lights.end(), [&](const Light& other) {
            return other.source_node == light.source_node;
        });
    };
    for (const Light& before : original.lights) {
        if (!before.source_node) continue;
        const auto after = kept(before);
        if (after == edited.lights.end())
            detach(json, *before.source_node);
        else if (!same_pose(before, *after) || !same_definition(before, *after))
            save_changed(json, before, *after);
    }
    for (const Light& light : edited.lights) {
        if (light.source_node) continue;
        if (area_m2(light) > 0.0F) {
            warnings.push_back(
                {.where = light.name, .what = "glTF has no lights with a size: left out"});
            continue;
        }
        if (light.kind == tables::LightKind::ies) {
            warnings.push_back(
                {.where = light.name, .what = "glTF has no light profiles: left out"});
            continue;
        }
        if (light.angle_rad > 0.0F)
            warnings.push_back(
                {.where = light.name, .what = "glTF has no width of a light in the sky: left out"});
        OrderedJson& lights = lights_of(json);
        lights.push_back(definition_of(light));
        add_node(json, light, lights.size() - 1);
    }
}

}  // namespace facet::scene::gltf
