// Surfaces that are shaded as they are drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/lighting/lighting.h"

namespace facet::frame {

class ForwardPass {
public:
    explicit ForwardPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Lays the blended instances among `order` (far to near) over `out`. A double-sided one shows
    /// its back faces first, so that a convex shell needs no sorting of triangles.
    [[nodiscard]] base::Status run_blended(const gl::Context& gl, const GpuScene& scene,
                                           const std::vector<std::size_t>& order,
                                           const ShadeInputs& in, const DrawTarget& out);
    /// Draws the instances whose layers the G-buffer does not hold over what LightingPass made of
    /// them; `out` has the G-buffer's depth.
    [[nodiscard]] base::Status run_layered(const gl::Context& gl, const GpuScene& scene,
                                           const ShadeInputs& in, const DrawTarget& out);

private:
    struct Key {
        MaterialKey material;
        ShadeKey shade;
        bool blend = false;
        auto operator<=>(const Key&) const = default;
    };
    [[nodiscard]] base::Result<gl::Program> make(const gl::Context& gl, const Key& key) const;
    [[nodiscard]] base::Status begin(const gl::Context& gl, const GpuScene& scene, const Key& key,
                                     const gl::Pipeline& pipeline, const ShadeInputs& in,
                                     const DrawTarget& out);

    const gl::ShaderSources* sources_;
    Permutations<Key> programs_;
};

}  // namespace facet::frame
