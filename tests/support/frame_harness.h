// Draws a scene value with the frame's own passes and gives its radiance.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "brdf/albedo.h"
#include "brdf/glsl_text.h"
#include "frame/frame.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace facet::test {

/// One picture to draw.
struct Shot {
    scene::Scene scene;
    std::shared_ptr<const image::Image> latlong = constant_environment(math::Vec3(0.0F));
    scene::Camera camera = camera_on_z(4.0F, 1.0F);
    math::Extent size{64, 64};
    std::uint32_t samples = 1;
    tables::BrdfChoice brdf{};
    frame::Background background{.kind = frame::BackgroundKind::none};
    gl::Backend backend = gl::Backend::automatic;
    unsigned threads = 0;
    std::vector<tables::Aov> aovs;
    std::optional<std::vector<tables::Aov>>
        earlier_aovs;  ///< the frame's first: it is drawn with these, and then they change
    scene::KeyLight key_light{};
};

struct Picture {
    image::Image radiance;  ///< RGBA f32, associated alpha, mean of the samples, rows from the top
    std::vector<image::Layer> aovs;

    [[nodiscard]] math::Vec4 at(std::uint32_t x, std::uint32_t y) const {
        const auto v = radiance.as<float>();
        const std::size_t i = (std::size_t{y} * radiance.size.width + x) * 4;
        return {v[i], v[i + 1], v[i + 2], v[i + 3]};
    }
    [[nodiscard]] math::Vec4 center() const {
        return at(radiance.size.width / 2, radiance.size.height / 2);
    }
};

/// A context and what is drawn with it; several shots may share one, and its compiled shaders.
class Harness {
public:
    explicit Harness(gl::Backend backend = gl::Backend::automatic)
        : gl_(gl::Context::create(backend, log_)) {}

    base::Result<Picture> draw(const Shot& shot) {
        if (!gl_) return tl::unexpected(gl_.error());
        base::ThreadPool pool(shot.threads);
        const auto text = brdf::glsl_text(shot.brdf);
        if (!text) return tl::unexpected(text.error());
        const gl::ShaderSources sources{FACET_SOURCE_DIR "/glsl", {{"generated/brdf.glsl", *text}}};
        auto scene = frame::upload_scene(*gl_, shot.scene, frame::Filtering{}, pool);
        if (!scene) return tl::unexpected(scene.error());
        const brdf::AlbedoTable table = brdf::albedo_table(shot.brdf);
        base::Warnings warnings;
        auto environment =
            frame::upload_environment(*gl_, {.name = "test", .latlong = shot.latlong}, {},
                                      table.texels, table.size, pool, warnings);
        if (!environment) return tl::unexpected(environment.error());
        auto frame = frame::Frame::create(*gl_, sources,
                                          {.picture = shot.size,
                                           .region = {0, 0, shot.size},
                                           .emissive = scene->emits,
                                           .specular = scene->has_specular,
                                           .aovs = shot.earlier_aovs.value_or(shot.aovs)});
        if (!frame) return tl::unexpected(frame.error());
        const frame::PackedLights lights = frame::pack_lights(shot.scene.lights, false);
        const frame::FrameInputs in{*scene,      *environment,    lights,
                                    shot.camera, shot.background, shot.key_light};
        if (shot.earlier_aovs) {
            if (auto drawn = draw_all(*frame, in, shot.samples); !drawn)
                return tl::unexpected(drawn.error());
            if (auto set = frame->set_aovs(*gl_, shot.aovs); !set)
                return tl::unexpected(set.error());
        }
        if (auto drawn = draw_all(*frame, in, shot.samples); !drawn)
            return tl::unexpected(drawn.error());
        Picture out{.radiance = frame::read_radiance(*gl_, frame->sum_framebuffer(), shot.size),
                    .aovs = {}};
        for (float& value : out.radiance.as<float>()) value /= static_cast<float>(shot.samples);
        out.aovs = frame->read_aovs(*gl_, shot.samples);
        return out;
    }

private:
    base::Status draw_all(frame::Frame& frame, const frame::FrameInputs& in,
                          std::uint32_t samples) {
        for (std::uint32_t i = 0; i < samples; ++i)
            if (auto drawn = frame.draw(*gl_, in, i, samples); !drawn) return drawn;
        return frame.draw_centered_aovs(*gl_, in);
    }

    base::Log log_;
    base::Result<gl::Context> gl_;
};

}  // namespace facet::test
