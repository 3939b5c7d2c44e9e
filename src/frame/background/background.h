// What shows where no surface is.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"

namespace facet::frame {

/// `color` and `none` leave the pixels empty; the display pass lays the picture over the colour.
enum class BackgroundKind { sharp, blurred, color, none };

struct Background {
    BackgroundKind kind = BackgroundKind::sharp;
    math::Vec3 color{0.0F};  ///< color: display-linear Rec.709
    float blur = 0.0F;       ///< blurred: 0..1, a roughness
};

class BackgroundPass {
public:
    explicit BackgroundPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Writes the pixels of `out` whose depth is the far plane.
    [[nodiscard]] base::Status run(const gl::Context& gl, BackgroundKind kind,
                                   const EnvironmentMaps& environment, const gl::VertexArray& empty,
                                   const RadianceTarget& out);

private:
    const gl::ShaderSources* sources_;
    Permutations<BackgroundKind> programs_;
};

}  // namespace facet::frame
