// Materials as small JSON files: presets of resources/materials, and what the studio exports.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::scene {

/// A material's numbers without its textures.
struct MaterialFile {
    std::string name;
    std::string source;  ///< where the numbers come from; may be empty
    tables::MaterialValues values;
    std::vector<std::string_view> given;  ///< keys of tables/material.def that the file has
    std::optional<AlphaMode> alpha_mode;
    std::optional<bool> double_sided;
};

/// `{"facet": 1, "name": "Gold", "source": "…", "base_color": [r, g, b], "roughness": 0.2,
/// "alpha_mode": "blend", "double_sided": true}`; numbers by the keys of tables/material.def, all
/// optional. Errors: input_invalid (not JSON, an unknown key with the nearest right ones, a value
/// out of its range), limit_reached.
[[nodiscard]] base::Result<MaterialFile> parse_material(std::string_view text,
                                                        const base::Limits& limits);
/// The file that parse_material() reads back to the same; every number, in the table's order.
[[nodiscard]] std::string material_text(const Material& material);

/// Puts the file's values into `material`. Its textures go: the numbers are the whole look.
void apply_material(const MaterialFile& file, Material& material);

/// A preset's name, or a path that ends in .json. Errors: usage (no such preset), those of reading
/// and of parse_material().
[[nodiscard]] base::Result<MaterialFile> load_material(const std::string& name,
                                                       const base::Limits& limits);
/// Names of the presets, sorted.
[[nodiscard]] std::vector<std::string> material_presets();

/// What --material says: `NAME=PRESET`, NAME as in --set: a name, `*` or `[3]`. Errors: usage, and
/// as load_material(); the scene is then as it was.
[[nodiscard]] base::Status apply_material_setting(Scene& scene, const std::string& assignment,
                                                  const base::Limits& limits);

}  // namespace facet::scene
