// The BRDF as the shader compiler sees it, asked without a scene.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/query.h"
#include "gl/context.h"

#include <filesystem>
#include <span>
#include <vector>

namespace facet::frame {

/// Answers in the order of the questions, float32, with the table that the rasteriser looks its
/// albedo up in. Lights and environment are masked alike, by `choice.masking`. `glsl`: the folder
/// of the shaders. Errors: those of the driver.
[[nodiscard]] base::Result<std::vector<float>> evaluate(const gl::Context& gl,
                                                        const std::filesystem::path& glsl,
                                                        const tables::BrdfChoice& choice,
                                                        std::span<const brdf::Question> questions);

}  // namespace facet::frame
