// An AOV as a picture that a person can look at: PNG side files and the studio's views.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/read.h"
#include "tables/aovs.h"

namespace facet::render {

/// RGB u8 of the layer's size, by the row's PngCode; what is a colour is encoded as sRGB, numbers
/// are codes as they are. Range codes take the layer's own finite ends, so two pictures of one AOV
/// need not agree. Radiance is multiplied with `exposure` first, as the picture is.
[[nodiscard]] image::Image viewable(tables::Aov aov, const image::Layer& layer, double exposure);

}  // namespace facet::render
