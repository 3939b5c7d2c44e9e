// Edits of materials and lights, written into a document.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

#include <string>

namespace facet::scene::gltf {

/// Where new pictures go: into the BIN, or into files called STEM-N.
struct PicturePlace {
    bool into_bin = false;
    std::string stem;
};

/// Numbers, textures, alpha mode and sidedness of the materials that differ. Errors: those of
/// encoding a picture.
[[nodiscard]] base::Status save_materials(Document& document, const Scene& original,
                                          const Scene& edited, const PicturePlace& place,
                                          const base::Limits& limits, base::Warnings& warnings);

/// Lights that differ, are new or are gone.
void save_lights(Document& document, const Scene& original, const Scene& edited,
                 base::Warnings& warnings);

}  // namespace facet::scene::gltf
