// A frame: the one place that knows the order of the passes.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/aov/aov.h"
#include "frame/background/background.h"
#include "frame/background/ground.h"
#include "frame/environment/environment_maps.h"
#include "frame/forward/forward.h"
#include "frame/gbuffer/gbuffer.h"
#include "frame/lighting/light_paths.h"
#include "frame/lighting/lighting.h"
#include "frame/occlusion/occlusion.h"
#include "frame/output/output.h"
#include "frame/rays/rays.h"
#include "frame/shadow/shadow_maps.h"
#include "frame/upload/gpu_scene.h"
#include "frame/view.h"
#include "image/read.h"
#include "scene/key_light.h"

#include <optional>
#include <vector>

namespace facet::frame {

/// What a picture consists of, apart from its scene.
struct FrameSpec {
    math::Extent picture;
    Region region;
    bool emissive = false;  ///< some material emits
    bool specular = false;  ///< some reflects as no plain dielectric does
    bool rays = false;      ///< FrameInputs::rays may be there
    bool maps = false;      ///< shadow maps and ambient visibility, where they are not
    std::vector<tables::Aov> aovs;
};

/// What is drawn. Everything outlives the call.
struct FrameInputs {
    const GpuScene& scene;
    const EnvironmentMaps& environment;
    const PackedLights& lights;
    const scene::Camera& camera;
    const Background& background;
    scene::KeyLight key_light{};             ///< for AOVs that are terms of the BRDF
    const EnvironmentMaps* probe = nullptr;  ///< lights in the environment's place
    Rays* rays = nullptr;  ///< finds what is visible, where the frame is made for that
    const scene::Ground* ground = nullptr;  ///< catches shadows, where rays find them
    /// Of blended surfaces, which rays do not know of; null: `lights`.
    const PackedLights* open_lights = nullptr;
    bool has_moved = false;  ///< since the sample before: shadow maps are of another scene

    /// All the same without rays.
    [[nodiscard]] FrameInputs in_the_open() const {
        return {scene,  environment, open_lights == nullptr ? lights : *open_lights,
                camera, background,  key_light,
                probe};
    }
};

/// Milliseconds a pass took, each waited for; asked for by benchmarks only.
struct PassTimes {
    double gbuffer = 0.0;
    double lighting = 0.0;  ///< light lists, lighting, background and blended surfaces
    double post = 0.0;
};

class Frame {
public:
    /// `sources` outlives the frame. Errors: limit_reached (size), internal (shaders).
    [[nodiscard]] static base::Result<Frame> create(const gl::Context& gl,
                                                    const gl::ShaderSources& sources,
                                                    const FrameSpec& spec);

    /// Other targets of another size; programs stay, AOV targets and sums are empty again. Errors:
    /// limit_reached.
    [[nodiscard]] base::Status resize(const gl::Context& gl, const FrameSpec& spec);
    /// Changes which further outputs there are, from the next frame on, which is sample 0; no row
    /// twice. Programs are kept, and targets that stay. Errors: internal.
    [[nodiscard]] base::Status set_aovs(const gl::Context& gl, std::vector<tables::Aov> aovs);

    /// Forgets what was drawn before, so that a picture's bytes cannot depend on it.
    void begin_picture(const gl::Context& gl) const { clear(gl, gbuffer_); }
    /// Asks the rays, where there are some, for the indirect light at the middles of the pixels; it
    /// lights the frames drawn from now on.
    [[nodiscard]] base::Status find_indirect(const gl::Context& gl, const FrameInputs& in);
    /// The two halves of that, between which somebody asks the rays.
    [[nodiscard]] base::Result<ReadSurfaces> read_middles(const gl::Context& gl,
                                                          const FrameInputs& in);
    [[nodiscard]] base::Status set_indirect(const gl::Context& gl, const IndirectLight& light) {
        return update_indirect(gl, light, rays_);
    }
    /// Draws sample `index` of `count` and adds it, unless it is the only one. Sample 0 begins all
    /// sums anew.
    [[nodiscard]] base::Status draw(const gl::Context& gl, const FrameInputs& in,
                                    std::uint32_t index, std::uint32_t count,
                                    PassTimes* times = nullptr);
    /// AOVs that are not averaged: one more G-buffer through the centres of the pixels.
    [[nodiscard]] base::Status draw_centered_aovs(const gl::Context& gl, const FrameInputs& in);

    /// The sum of the frames drawn: RGBA f32, rows from the bottom; and its window depth of the
    /// last frame.
    [[nodiscard]] const gl::Framebuffer& sum_framebuffer() const;
    /// The last frame alone, likewise.
    [[nodiscard]] const gl::Framebuffer& frame_framebuffer() const { return radiance_.framebuffer; }
    [[nodiscard]] const gl::Texture& sum_texture() const;
    [[nodiscard]] const gl::Framebuffer& depth_framebuffer() const { return gbuffer_.framebuffer; }
    /// Encodes the frames drawn for a screen, on the GL; read_display() fetches it.
    [[nodiscard]] base::Status display(const gl::Context& gl, const DisplaySettings& settings);
    /// Likewise a picture that comes from elsewhere: f32 [height, width, 4], rows from the top.
    [[nodiscard]] base::Status display_picture(const gl::Context& gl, const image::Image& radiance,
                                               const DisplaySettings& settings);
    [[nodiscard]] image::Image read_display(const gl::Context& gl) const {
        return display_pass_.read(gl);
    }
    [[nodiscard]] std::vector<image::Layer> read_aovs(const gl::Context& gl,
                                                      std::uint32_t count) const;
    /// What display() drew last: RGBA, rows from the bottom.
    [[nodiscard]] const gl::Texture& display_texture() const { return display_pass_.texture(); }
    [[nodiscard]] const FrameSpec& spec() const { return spec_; }
    /// One of them; none where it was not asked for.
    [[nodiscard]] std::optional<image::Layer> read_aov(const gl::Context& gl, tables::Aov aov,
                                                       std::uint32_t count) const;
    /// Its sum over the frames drawn, of draw_centered_aovs() alone where it is not averaged: RGBA
    /// f32, rows from the bottom; a: how many of them had a surface. Null where not asked for; dies
    /// with the next set_aovs().
    [[nodiscard]] const gl::Texture* aov_texture(tables::Aov aov) const;
    [[nodiscard]] math::Extent size() const { return spec_.region.size; }

private:
    Frame(const gl::ShaderSources& sources, FrameSpec spec)
        : spec_(std::move(spec)),
          gbuffer_pass_(sources),
          lighting_pass_(sources),
          background_pass_(sources),
          ground_pass_(sources),
          shadow_pass_(sources),
          occlusion_pass_(sources),
          forward_pass_(sources),
          aov_pass_(sources),
          display_pass_(sources) {}

    /// The G-buffer, and what shares its depth: as the AOVs need them.
    [[nodiscard]] base::Status make_targets(const gl::Context& gl);
    [[nodiscard]] base::Status make_light_paths(const gl::Context& gl);
    [[nodiscard]] const AovTarget* aov_target(tables::Aov aov) const;
    /// Adds the averaged AOVs of the frame just drawn to their sums.
    [[nodiscard]] base::Status add_aovs(const gl::Context& gl, const FrameInputs& in,
                                        std::uint32_t index);
    /// Whether this frame has shadow maps and ambient visibility.
    [[nodiscard]] bool has_maps(const FrameInputs& in) const {
        return spec_.maps && in.rays == nullptr;
    }
    void set_view(const gl::Context& gl, const FrameInputs& in, const shared::View& camera_view);
    [[nodiscard]] ShadeKey upload_lights(const gl::Context& gl, const FrameInputs& in);
    /// `opaque`: for the surfaces of the G-buffer, whose depth leaves out lights.
    [[nodiscard]] LightLists update_light_lists(const gl::Context& gl, const FrameInputs& in,
                                                const shared::View& view, bool opaque);
    /// Which sample of the picture is drawn.
    struct SampleView {
        const shared::View& view;
        std::uint32_t index;
    };
    /// Asks the rays what they find at the G-buffer's surfaces; `key` says what that is.
    [[nodiscard]] base::Status ask_rays(const gl::Context& gl, const FrameInputs& in,
                                        const SampleView& sample, const LightLists* lists,
                                        ShadeKey& key);
    /// Surfaces of the G-buffer into `out`, and into `background` what shows beside them, unless it
    /// is null.
    [[nodiscard]] base::Status draw_opaque(const gl::Context& gl, const FrameInputs& in,
                                           const ShadeInputs& shade, const DrawTarget& out,
                                           const gl::Framebuffer* background);
    /// Blended surfaces over all that; `shade` lit them.
    [[nodiscard]] base::Status draw_blended(const gl::Context& gl, const FrameInputs& in,
                                            const SampleView& sample, ShadeInputs shade,
                                            const std::vector<std::size_t>& far_to_near);
    [[nodiscard]] base::Status draw_light(const gl::Context& gl, const FrameInputs& in,
                                          const SampleView& sample,
                                          const std::vector<std::size_t>& far_to_near);

    FrameSpec spec_;
    GBufferPass gbuffer_pass_;
    LightingPass lighting_pass_;
    BackgroundPass background_pass_;
    GroundPass ground_pass_;
    ShadowPass shadow_pass_;
    OcclusionPass occlusion_pass_;
    ForwardPass forward_pass_;
    AovPass aov_pass_;
    DisplayPass display_pass_;
    AccumulatePass accumulate_pass_;
    GBuffer gbuffer_;
    RadianceTarget radiance_;
    std::optional<Accumulator> accumulator_;
    bool has_sum_ = false;  ///< the frames drawn are in it; else the only one is not weighed
    std::vector<AovTarget> aov_targets_;
    std::optional<LightPathTarget> light_paths_;  ///< where AOVs ask for one
    LightBuffers light_buffers_;
    RayTextures rays_;
    gl::Buffer view_block_;
    gl::VertexArray empty_;
};

}  // namespace facet::frame
