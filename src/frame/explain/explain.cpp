// A frame that writes down what it computes at some pixels.
// SPDX-License-Identifier: MIT
#include "frame/explain/explain.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace facet::frame {
namespace {

using shared::ExplainedLight;
using shared::ExplainedSurface;

/// As glsl/frame/explain/explain.glsl has them.
enum class Stage : std::uint32_t { gbuffer, lighting, blend, background, layers };
constexpr std::uint32_t most_surfaces = 1U << 20;
constexpr std::uint32_t most_lights = 1U << 22;

Stage stage_of(const ExplainedSurface& s) { return static_cast<Stage>(s.which.y); }

template <class Record>
std::vector<Record> read_records(const gl::Context& gl, const gl::Buffer& buffer,
                                 std::size_t count) {
    std::vector<Record> out(count);
    gl::read_buffer(gl, buffer, std::as_writable_bytes(std::span(out)));
    return out;
}

/// Where each draw comes in the order that blended surfaces are laid over each other.
std::vector<std::size_t> ranks_far_to_near(const GpuScene& scene, const shared::View& view) {
    const std::vector<std::size_t> near_first = near_to_far(scene, view);
    std::vector<std::size_t> ranks(near_first.size());
    for (std::size_t i = 0; i < near_first.size(); ++i)
        ranks[near_first[i]] = near_first.size() - i;
    return ranks;
}

ExplainedPoint point_of(const std::vector<ExplainedLight>& lights, std::size_t record,
                        const ExplainedSurface& surface) {
    ExplainedPoint out{surface, {}};
    for (const ExplainedLight& light : lights)
        if (light.which.x == record) out.lights.push_back(light);
    std::ranges::sort(out.lights, {}, [](const ExplainedLight& l) { return l.which.y; });
    return out;
}

/// What the G-buffer keeps of overlapping fragments: the nearest, of equals the first drawn.
bool is_nearer(const ExplainedSurface& a, const ExplainedSurface& b,
               const std::vector<std::size_t>& far_to_near) {
    return std::tuple(a.position.w, far_to_near.size() - far_to_near[a.which.z], a.which.w) <
           std::tuple(b.position.w, far_to_near.size() - far_to_near[b.which.z], b.which.w);
}

/// What the shading of a surface tells, with what its textures told in the G-buffer.
ExplainedSurface joined(const ExplainedSurface& fetched, const ExplainedSurface& lit) {
    ExplainedSurface out = fetched;
    out.position = {math::Vec3(lit.position), fetched.position.w};
    out.normal = lit.normal;
    out.base_color = {math::Vec3(lit.base_color), fetched.base_color.w};
    out.numbers = lit.numbers;  // as the G-buffer stored them
    out.to_eye = lit.to_eye;
    out.albedo = lit.albedo;
    out.irradiance = lit.irradiance;
    out.prefiltered = lit.prefiltered;
    out.environment_diffuse = lit.environment_diffuse;
    out.environment_specular = lit.environment_specular;
    out.radiance = lit.radiance;
    return out;
}

}  // namespace

base::Result<Explainer> Explainer::create(const gl::Context& gl, const gl::ShaderSources& sources,
                                          const FrameSpec& spec) {
    auto own = std::make_unique<gl::ShaderSources>(sources);
    own->defines += "#define FACET_EXPLAIN 1\n";
    FrameSpec plain = spec;
    plain.aovs.clear();
    auto frame = Frame::create(gl, *own, plain);
    if (!frame) return tl::unexpected(frame.error());
    return Explainer(std::move(own), std::move(*frame));
}

base::Result<Explainer::Records> Explainer::record(const gl::Context& gl, const FrameInputs& in,
                                                   std::span<const PixelPlace> pixels,
                                                   std::uint32_t index, std::uint32_t count) {
    const math::Extent size = frame_.size();
    constexpr std::size_t head = 8;  // explain_size, explain_count
    std::vector<std::uint32_t> asked(head + static_cast<std::size_t>(size.pixels()), 0);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t row = size.height - 1 - pixels[i].y;
        asked[head + row * size.width + pixels[i].x] = static_cast<std::uint32_t>(i + 1);
    }
    if (index == 0 || in.has_moved) {
        // Surfaces at the pixels' middles are none that a sample shows.
        asked_ = gl::make_buffer(gl, std::vector<std::byte>(asked.size() * sizeof(asked[0])));
        gl.api().BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, asked_.name());
        if (auto found = frame_.find_indirect(gl, in); !found) return tl::unexpected(found.error());
    }
    for (;;) {
        asked[0] = size.width;
        asked[2] = room_.surfaces;
        asked[3] = room_.lights;
        asked_ = gl::make_buffer(gl, std::as_bytes(std::span(asked)), GL_DYNAMIC_COPY);
        surfaces_ = gl::make_buffer(
            gl, std::vector<std::byte>(room_.surfaces * sizeof(ExplainedSurface)), GL_DYNAMIC_COPY);
        lights_ = gl::make_buffer(gl, std::vector<std::byte>(room_.lights * sizeof(ExplainedLight)),
                                  GL_DYNAMIC_COPY);
        for (const auto& [place, buffer] :
             {std::pair{0U, &asked_}, std::pair{1U, &surfaces_}, std::pair{2U, &lights_}})
            gl.api().BindBufferBase(GL_SHADER_STORAGE_BUFFER, place, buffer->name());
        if (auto drawn = frame_.draw(gl, in, index, count); !drawn)
            return tl::unexpected(drawn.error());
        gl.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        const auto counts = read_records<std::uint32_t>(gl, asked_, head);
        const std::uint32_t surfaces = counts[4];
        const std::uint32_t lights = counts[5];
        if (surfaces <= room_.surfaces && lights <= room_.lights)
            return Records{read_records<ExplainedSurface>(gl, surfaces_, surfaces),
                           read_records<ExplainedLight>(gl, lights_, lights)};
        if (surfaces > most_surfaces || lights > most_lights)
            return base::fail({.code = base::ErrorCode::limit_reached,
                               .what = "too many surfaces or lights at the pixels asked for",
                               .remedy = "ask for fewer pixels"});
        // Lights of surfaces without room went unseen: they are as many again, at most.
        room_ = {std::max(room_.surfaces, surfaces + surfaces / 8),
                 std::min(most_lights, std::max(room_.lights * 2, lights * 2))};
    }
}

base::Result<std::vector<ExplainedPixel>> Explainer::draw(const gl::Context& gl,
                                                          const FrameInputs& in,
                                                          std::span<const PixelPlace> pixels,
                                                          std::uint32_t index,
                                                          std::uint32_t count) {
    // No two explanations may share a pixel's place.
    auto records = record(gl, in, pixels, index, count);
    if (!records) return tl::unexpected(records.error());
    for (ExplainedLight& light : records->lights)
        light.which.y = static_cast<std::uint32_t>(in.lights.order[light.which.y]);
    const math::Vec2 jitter = jitter_px(index, count);
    const FrameSpec& spec = frame_.spec();
    const shared::View view = sample_view(in.camera, spec.picture, spec.region, index, count);
    const std::vector<std::size_t> ranks = ranks_far_to_near(in.scene, view);
    std::vector<ExplainedPixel> out(pixels.size());
    struct Found {
        const ExplainedSurface* fetched = nullptr;
        std::optional<std::size_t> lit;
        std::vector<std::size_t> blended;
        std::vector<std::size_t> layered;
        const ExplainedSurface* background = nullptr;
    };
    std::vector<Found> found(pixels.size());
    for (std::size_t i = 0; i < records->surfaces.size(); ++i) {
        const ExplainedSurface& s = records->surfaces[i];
        Found& at = found[s.which.x];
        if (stage_of(s) == Stage::lighting) at.lit = i;
        if (stage_of(s) == Stage::background) at.background = &s;
        if (stage_of(s) == Stage::blend) at.blended.push_back(i);
        if (stage_of(s) == Stage::layers) at.layered.push_back(i);
        if (stage_of(s) == Stage::gbuffer &&
            (at.fetched == nullptr || is_nearer(s, *at.fetched, ranks)))
            at.fetched = &s;
    }
    const image::Image radiance = read_radiance(gl, frame_.frame_framebuffer(), frame_.size());
    const auto values = radiance.as<float>();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        ExplainedPixel& pixel = out[i];
        Found& at = found[i];
        pixel.jitter_px = jitter;
        pixel.vignetting = vignetting(view, pixels[i].x, pixels[i].y);
        const std::size_t place =
            (std::size_t{pixels[i].y} * frame_.size().width + pixels[i].x) * 4;
        for (int c = 0; c < 4; ++c) pixel.radiance[c] = values[place + static_cast<std::size_t>(c)];
        float depth = 1.0F;
        if (at.fetched != nullptr && at.lit) {
            depth = at.fetched->position.w;
            pixel.opaque =
                point_of(records->lights, *at.lit, joined(*at.fetched, records->surfaces[*at.lit]));
            for (const std::size_t k : at.layered) {  // what is seen of them was shaded anew
                const ExplainedSurface& s = records->surfaces[k];
                if (s.which.z == at.fetched->which.z && s.which.w == at.fetched->which.w)
                    pixel.opaque = point_of(records->lights, k, s);
            }
        } else if (at.background != nullptr) {
            pixel.background_nit = math::Vec3(at.background->radiance);
        }
        const auto order = [&](std::size_t k) {
            const ExplainedSurface& s = records->surfaces[k];
            return std::tuple(ranks[s.which.z], s.ids.w, s.which.w);  // backs before fronts
        };
        std::ranges::sort(at.blended, {}, order);
        for (const std::size_t k : at.blended)
            if (records->surfaces[k].position.w <= depth)
                pixel.blended.push_back(point_of(records->lights, k, records->surfaces[k]));
    }
    return out;
}

}  // namespace facet::frame
