// What shows where no surface is.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"

namespace facet::frame {

/// `color` and `none` leave the pixels empty; the display pass lays the picture over the colour.
enum class BackgroundKind { environment, color, none };

struct Background {
    BackgroundKind kind = BackgroundKind::environment;
    math::Vec3 color{0.0F};  ///< color: display-linear Rec.709
    float blur = 0.0F;       ///< environment: 0 sharp .. 1, a roughness
};

class BackgroundPass {
public:
    explicit BackgroundPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Writes the pixels of `out` whose depth is the far plane.
    [[nodiscard]] base::Status run(const gl::Context& gl, const EnvironmentMaps& environment,
                                   const gl::VertexArray& empty, const DrawTarget& out);

private:
    const gl::ShaderSources* sources_;
    gl::Program program_;
};

}  // namespace facet::frame
