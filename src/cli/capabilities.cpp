// What this build supports, said by the tables.
// SPDX-License-Identifier: MIT
#include "cli/capabilities.h"

#include "base/text.h"
#include "tables/aovs.h"
#include "tables/gltf_features.h"
#include "tables/image_formats.h"
#include "tables/lights.h"
#include "tables/material.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <string>
#include <vector>

namespace facet::cli {
namespace {

using Names = std::vector<std::string>;

template <class Rows>
Names keys(const Rows& rows) {
    Names names;
    for (const auto& row : rows) names.emplace_back(row.key);
    return names;
}

Names formats(bool tables::ImageFormatRow::*can) {
    Names names;
    for (const auto& row : tables::image_formats)
        if (row.*can) names.emplace_back(row.key);
    return names;
}

void print_features(Io& io) {
    io.print("\n| glTF | loaded | raster | reference | studio | test |");
    io.print("| --- | --- | --- | --- | --- | --- |");
    for (const tables::GltfFeature& row : tables::gltf_features())
        io.print(fmt::format("| {} | {} | {} | {} | {} | {} |", row.name, name_of(row.loaded),
                             name_of(row.raster), name_of(row.reference), name_of(row.studio),
                             row.test));
}

nlohmann::ordered_json features_json() {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const tables::GltfFeature& row : tables::gltf_features())
        rows.push_back({{"name", row.name},
                        {"loaded", name_of(row.loaded)},
                        {"raster", name_of(row.raster)},
                        {"reference", name_of(row.reference)},
                        {"studio", name_of(row.studio)},
                        {"test", row.test}});
    return rows;
}

}  // namespace

void print_capabilities(Io& io) {
    const std::vector<std::pair<std::string, Names>> lists = {
        {"scenes", {"gltf 2.0", "glb 2.0"}},
        {"pictures_read", formats(&tables::ImageFormatRow::reads)},
        {"pictures_written", formats(&tables::ImageFormatRow::writes)},
        {"lights", keys(tables::light_kinds)},
        {"materials", keys(tables::material_params)},
        {"textures", keys(tables::material_textures)},
        {"aovs", keys(tables::aovs)},
    };
    nlohmann::ordered_json object{{"facet", 1}};
    for (const auto& [name, names] : lists) {
        object[name] = names;
        if (!io.json) io.print(fmt::format("{:<17} {}", name, base::join(names, ", ")));
    }
    if (!io.json) return print_features(io);
    object["gltf"] = features_json();
    io.print_object(object);
}

}  // namespace facet::cli
