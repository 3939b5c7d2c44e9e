// Shadow maps as shading looks them up.
// SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"

namespace facet::frame {

/// What shade.glsl looks shadows up in.
struct ShadowTextures {
    gl::Texture atlas;  ///< D32F
    gl::Buffer views;
    gl::Texture
        views_texture;  ///< RGBA32F: a texel a light, then six a view (frame/shadow/shadow.glsl)
};

}  // namespace facet::frame
