// An AOV as a picture that a person can look at.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/read.h"

namespace facet::render {

/// u8 RGB of a layer named after a row of tables/aovs.def, as that row says.
[[nodiscard]] image::Image viewable(const image::Layer& layer, float exposure = 1.0F);

}  // namespace facet::render
