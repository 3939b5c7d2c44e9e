// Alpha-blended surfaces, after the opaque ones, far to near.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"

namespace facet::frame {

class BlendPass {
public:
    explicit BlendPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Lays the blended instances among `order` (far to near) over `out`. A double-sided one shows
    /// its back faces first, so that a convex shell needs no sorting of triangles.
    [[nodiscard]] base::Status run(const gl::Context& gl, const GpuScene& scene,
                                   const std::vector<std::size_t>& order, const ShadeInputs& in,
                                   const DrawTarget& out);

private:
    struct Key {
        MaterialKey material;
        ShadeKey shade;
        auto operator<=>(const Key&) const = default;
    };
    [[nodiscard]] base::Result<gl::Program> make(const gl::Context& gl, const Key& key) const;

    const gl::ShaderSources* sources_;
    Permutations<Key> programs_;
};

}  // namespace facet::frame
