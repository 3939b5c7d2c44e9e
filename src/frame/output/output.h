// The end of a frame: summing jittered frames, and from radiance to what a screen shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/gbuffer/gbuffer.h"
#include "frame/permutations.h"
#include "image/image.h"
#include "tables/gamuts.h"
#include "tables/tonemaps.h"

#include <optional>

namespace facet::frame {

/// An RGBA32F picture that frames are added to.
struct Accumulator {
    math::Extent size;
    gl::Texture sum;
    gl::Framebuffer framebuffer;
    [[nodiscard]] static base::Result<Accumulator> create(const gl::Context& gl, math::Extent size);
    void clear(const gl::Context& gl) const;
};

class AccumulatePass {
public:
    [[nodiscard]] static base::Result<AccumulatePass> create(const gl::Context& gl,
                                                             const gl::ShaderSources& sources);
    void run(const gl::Context& gl, const gl::Texture& radiance, const gl::VertexArray& empty,
             const gl::Framebuffer& sum, math::Extent size) const;

private:
    gl::Program program_;
};

/// How radiance becomes codes.
struct DisplaySettings {
    tables::Tonemap tonemap = tables::Tonemap::pbr_neutral;
    double exposure = 1.0;
    std::uint32_t frame_count = 1;
    image::Sample sample = image::Sample::u8;  ///< u8 or u16
    bool dither = false;
    tables::Gamut gamut = tables::Gamut::srgb;
    math::Mat3 balance{1.0F};              ///< of linear Rec.709, before the tone curve
    std::optional<math::Vec3> background;  ///< display-linear colour under the picture
};

class DisplayPass {
public:
    explicit DisplayPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Encodes the summed radiance `sum` into the pass's own target.
    [[nodiscard]] base::Status run(const gl::Context& gl, const gl::Texture& sum, math::Extent size,
                                   const DisplaySettings& settings, const gl::VertexArray& empty);
    /// What run() drew last: RGBA, in codes of the gamut, straight alpha, rows from the top.
    [[nodiscard]] image::Image read(const gl::Context& gl) const;
    [[nodiscard]] const gl::Texture& texture() const { return target_.color; }

private:
    struct Target {
        math::Extent size;
        image::Sample sample = image::Sample::u8;
        gl::Texture color;
        gl::Framebuffer framebuffer;
    };
    [[nodiscard]] base::Status make_target(const gl::Context& gl, math::Extent size,
                                           image::Sample sample);

    const gl::ShaderSources* sources_;
    Permutations<tables::Tonemap> programs_;
    gl::Buffer block_;
    Target target_;
};

/// Reads an attachment as RGBA f32 [height, width, 4], rows from the top.
[[nodiscard]] image::Image read_radiance(const gl::Context& gl, const gl::Framebuffer& framebuffer,
                                         math::Extent size);
/// Turns rows from the bottom into rows from the top.
void flip_rows(image::Image& image);

}  // namespace facet::frame
