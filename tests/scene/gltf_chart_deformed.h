// The tiles of meshes that are bent in the chart of glTF features (gltf_chart.h).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gltf_chart_geometry.h"

namespace facet::test {

/// Both bring a green square from behind a red one to its front.
inline std::vector<Tile> deformed_tiles() {
    return {
        {"morph target",
         [](Chart& c, Shown s) {
             c.red_behind();
             Json primitive = c.primitive(c.green);
             primitive["targets"] = {
                 {{"POSITION", c.d.positions({0, 0, 0.3F, 0, 0, 0.3F, 0, 0, 0.3F, 0, 0, 0.3F})}}};
             c.place(primitive, -0.2);
             c.d.json["meshes"].back()["weights"] = {s == Shown::with ? 1 : 0};
         }},
        {"skin",
         [](Chart& c, Shown s) {
             c.red_behind();
             Json primitive = c.primitive(c.green);
             Json& attributes = primitive["attributes"];
             attributes["JOINTS_0"] =
                 c.d.accessor("VEC4", 5121, 4, std::vector<std::uint8_t>(16, 0));
             attributes["WEIGHTS_0"] =
                 c.d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
             Json& node = c.place(primitive, -0.2);
             if (s == Shown::without) return;
             // A skin leaves out its mesh's own place.
             Json joint{{"translation", node["translation"]}};
             joint["translation"][2] = 0.1;
             Json& nodes = c.d.json["nodes"];
             node["skin"] = c.d.json["skins"].size();
             c.d.json["skins"].push_back({{"joints", {nodes.size()}}});
             c.d.json["scenes"][0]["nodes"].push_back(nodes.size());
             nodes.push_back(joint);
         }},
    };
}

}  // namespace facet::test
