// The BRDF of a choice as GLSL: the needed term files, the slots, and the model.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/brdf_terms.h"

#include <string>

namespace facet::brdf {

/// Shading alone, or with brdf_sample and brdf_pdf of glsl/brdf/model/sampling.glsl.
enum class Parts { shading, sampling };

/// Text made of `#include "brdf/…"` lines (from the glsl folder) and one-line slot functions.
/// Defines FACET_BRDF_NEEDS_E_L: 1 where brdf_light reads its e_l.
[[nodiscard]] base::Result<std::string> glsl_text(const tables::BrdfChoice& choice,
                                                  Parts parts = Parts::shading);

/// The text for every choice at once, with its sampling: `uniform int chosen_SLOT` for each slot of
/// tables::brdf_slots holds the index of its value. Lessons in a browser switch terms by it.
[[nodiscard]] base::Result<std::string> glsl_text_of_all();

}  // namespace facet::brdf
