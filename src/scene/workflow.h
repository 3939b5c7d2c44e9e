// The two workflows of the lecture: colour-metal-roughness, and diffuse-specular-glossiness.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"

namespace facet::scene {

enum class Workflow : std::uint8_t { metallic_roughness, specular_glossiness };

/// Whether a material of the file is in the other workflow, so that convert() changes something.
[[nodiscard]] bool has_other(const Scene& scene, Workflow to);

/// Changes every material to that workflow. From glossiness nothing is lost: a dielectric of index
/// 0, tinted (KHR_materials_ior, KHR_materials_specular), whose roughness is 1 - glossiness. To
/// glossiness specular = mix(F0, base, metallic), and diffuse = base (1 - metallic) times what
/// keeps the diffuse light as it is, seen straight on; where textures have a say they are baked
/// into new pictures, 8 bits a channel, as large as the largest. Vertex colours tint the diffuse
/// colour alone there. Warnings: materials that stay, as their textures lie differently or lack
/// their pictures.
void convert(Scene& scene, Workflow to, base::Warnings& warnings);

}  // namespace facet::scene
