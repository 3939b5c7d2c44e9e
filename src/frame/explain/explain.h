// A frame that writes down what it computes at some pixels: the same passes, compiled with
// FACET_EXPLAIN. SPDX-License-Identifier: MIT
#pragma once

#include "frame/explain/explained.h"
#include "frame/frame.h"

#include <memory>
#include <span>
#include <vector>

namespace facet::frame {

class Explainer {
public:
    /// As Frame::create; `sources` are those of the frame that is explained.
    [[nodiscard]] static base::Result<Explainer> create(const gl::Context& gl,
                                                        const gl::ShaderSources& sources,
                                                        const FrameSpec& spec);

    /// Draws sample `index` of `count` and gives what it made of `pixels`, in their order. Errors:
    /// limit_reached (more surfaces behind the pixels than there is memory for), internal.
    [[nodiscard]] base::Result<std::vector<ExplainedPixel>> draw(const gl::Context& gl,
                                                                 const FrameInputs& in,
                                                                 std::span<const PixelPlace> pixels,
                                                                 std::uint32_t index,
                                                                 std::uint32_t count);

private:
    struct Room {
        std::uint32_t surfaces = 1024;
        std::uint32_t lights = 4096;
    };
    struct Records {
        std::vector<shared::ExplainedSurface> surfaces;
        std::vector<shared::ExplainedLight> lights;
    };
    Explainer(std::unique_ptr<gl::ShaderSources> sources, Frame frame)
        : sources_(std::move(sources)), frame_(std::move(frame)) {}
    [[nodiscard]] base::Result<Records> record(const gl::Context& gl, const FrameInputs& in,
                                               std::span<const PixelPlace> pixels,
                                               std::uint32_t index, std::uint32_t count);

    std::unique_ptr<gl::ShaderSources> sources_;  // passes keep its address
    Frame frame_;
    gl::Buffer asked_, surfaces_, lights_;
    Room room_;
};

}  // namespace facet::frame
