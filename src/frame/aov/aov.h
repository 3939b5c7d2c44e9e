// Further outputs: each AOV's expression, evaluated over the G-buffer.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/environment_maps.h"
#include "frame/gbuffer/gbuffer.h"
#include "image/image.h"
#include "tables/aovs.h"

#include <vector>

namespace facet::frame {

/// The sum of one AOV over the jittered frames; a holds the share of frames that had a surface.
struct AovTarget {
    tables::Aov aov{};
    gl::Texture sum;
    gl::Framebuffer framebuffer;  ///< shares the G-buffer's depth
};

/// What an AOV is evaluated over. Everything outlives the call.
struct AovInputs {
    const GBuffer& gbuffer;
    const EnvironmentMaps& environment;  ///< for its table of albedos
    const gl::VertexArray& empty;
};

class AovPass {
public:
    explicit AovPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Makes a cleared target; `gbuffer` outlives it.
    [[nodiscard]] static base::Result<AovTarget> make_target(const gl::Context& gl, tables::Aov aov,
                                                             const GBuffer& gbuffer);
    /// Adds this frame's values to the targets whose average is `average`, but those of light
    /// paths.
    [[nodiscard]] base::Status run(const gl::Context& gl, const AovInputs& in,
                                   tables::Average average, const std::vector<AovTarget>& targets);

private:
    struct Key {
        tables::Aov aov;
        bool specular = false;
        auto operator<=>(const Key&) const = default;
    };
    [[nodiscard]] base::Result<gl::Program> make(const gl::Context& gl, const Key& key) const;

    const gl::ShaderSources* sources_;
    Permutations<Key> programs_;
};

/// Begins the sums anew, of the targets whose average is `average`.
void clear(const gl::Context& gl, tables::Average average, const std::vector<AovTarget>& targets);

/// The AOV as f32 [height, width, channels of its row], rows from the top. Depth is +inf where no
/// surface is.
[[nodiscard]] image::Image read_aov(const gl::Context& gl, const AovTarget& target,
                                    math::Extent size, std::uint32_t frame_count);

}  // namespace facet::frame
