// A scene on the GL, ready to be drawn as often as wanted: what render(), the benchmark and the
// studio share. SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/thread_pool.h"
#include "frame/explain/explain.h"
#include "render/job.h"
#include "render/plan.h"

#include <memory>
#include <optional>

namespace facet::trace {
class Tracer;
}

namespace facet::render {

class TracedRays;
struct AskedRays;

/// A GL context and what to draw with it.
struct Opened {
    gl::Context gl;
    Job job;
};
/// Loads while the context comes up. Fills the times, counts and warnings of `out`. Errors: as
/// render().
[[nodiscard]] base::Result<Opened> open(const Request& request, const Plan& plan,
                                        base::ThreadPool& pool, base::Log& log, Rendered& out);

[[nodiscard]] frame::Filtering filtering_of(const Plan& plan);

class Session {
public:
    /// Uploads. `gl` and `pool` outlive the session. Errors: as render().
    [[nodiscard]] static base::Result<Session> create(const gl::Context& gl, Job job,
                                                      const tables::Settings& settings,
                                                      const Plan& plan, base::ThreadPool& pool,
                                                      base::Warnings& warnings);
    /// Draws another scene from now on, and keeps what it shares with the one before: programs,
    /// targets, environments. After an error only enter() is left to call.
    [[nodiscard]] base::Status enter(Job job, const tables::Settings& settings, const Plan& plan,
                                     base::Warnings& warnings);
    /// Where update() looks for environments that are read already; outlives the session.
    void use(Assets& assets) { assets_ = &assets; }
    /// Draws what other settings say from now on, doing again only what they change; `plan` is made
    /// from them. The scene's file stays. On an error the session draws what it drew before, but
    /// for a lack of memory.
    [[nodiscard]] base::Status update(const tables::Settings& settings, const Plan& plan,
                                      base::Warnings& warnings);
    /// Compiles every shader from its file again. On an error those of before go on.
    [[nodiscard]] base::Status reload_shaders();

    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// Before the first sample of a picture whose bytes must not depend on what was drawn before.
    void begin_picture() { frame_->begin_picture(*gl_); }
    /// `with_rays`: with those that the plan has. Sample 0 asks them for the indirect light of all,
    /// unless take_rays() has it.
    [[nodiscard]] base::Status draw(std::uint32_t index, std::uint32_t count,
                                    frame::PassTimes* times = nullptr, bool with_rays = true);
    /// Asks the rays on a thread of their own; meanwhile only draw() without them may be called,
    /// and what changes the picture, which gives them up.
    [[nodiscard]] base::Status ask_rays();
    enum class Asked : std::uint8_t { no, running, done };
    [[nodiscard]] Asked asked() const;
    /// What they found, for the samples from the next 0 on, until the picture changes.
    [[nodiscard]] base::Status take_rays();
    /// Through the middles of the pixels, in the middle of the shutter's time.
    [[nodiscard]] base::Status draw_centered_aovs();
    /// Draws what an animation moves where it is in the middle of the shutter's time, from now on.
    void hold_still() { holds_still_ = true; }
    /// Another view of the scene from the next sample 0 on: a region of a picture, the whole unless
    /// told.
    [[nodiscard]] base::Status look(const scene::Camera& camera, const frame::Region& region,
                                    math::Extent picture = {});
    /// The contract's automatic exposure of the `count` frames drawn.
    [[nodiscard]] double measure_exposure(std::uint32_t count);
    /// Encodes for a screen, on the GL; read_display() fetches the picture.
    [[nodiscard]] base::Status display(double exposure, std::uint32_t count);
    [[nodiscard]] image::Image read_display() const { return frame_->read_display(*gl_); }
    /// What display() drew: rows from the bottom.
    [[nodiscard]] const gl::Texture& display_texture() const { return frame_->display_texture(); }
    /// The AOVs of a part of the picture, through the centres of its pixels; the frames drawn stay.
    [[nodiscard]] base::Result<std::vector<image::Layer>> probe(
        const frame::Region& region, const std::vector<tables::Aov>& aovs);
    /// What sample `index` of `count` makes of some pixels of the region, number by number.
    [[nodiscard]] base::Result<std::vector<frame::ExplainedPixel>> explain(
        std::span<const frame::PixelPlace> pixels, std::uint32_t index, std::uint32_t count);
    [[nodiscard]] const scene::Scene& scene() const { return job_->scene; }
    [[nodiscard]] const Job& job() const { return *job_; }
    [[nodiscard]] const Plan& plan() const { return plan_; }
    /// What shines as the sun of the environment, apart from the rest of it.
    [[nodiscard]] const std::optional<scene::Light>& sun() const { return baked_.front().maps.sun; }
    /// Replaces the scene's lights from the next frame on; the shapes of visible ones stay as they
    /// are.
    void set_lights(std::span<const scene::Light> lights);
    /// display() of a picture that comes from elsewhere: f32 [height, width, 4], nit, associated
    /// coverage.
    [[nodiscard]] base::Status display_picture(const image::Image& radiance, double exposure);
    /// Lays radiance over the background colour, where one is named.
    void lay_over_background(image::Image& radiance, double exposure) const;
    /// Beauty as radiance in nit, of itself: with its coverage, rows from the top.
    [[nodiscard]] image::Image read_mean(std::uint32_t count) const;
    /// Window depth of the last frame, rows from the bottom.
    [[nodiscard]] std::vector<float> read_depth() const;
    /// Likewise `background` among AOVs, where `radiance` is what the picture is of itself.
    void lay_over_background(std::vector<image::Layer>& aovs, const image::Image& radiance,
                             double exposure) const;
    [[nodiscard]] std::vector<image::Layer> read_aovs(double exposure, std::uint32_t count) const;

    /// Returns when every pixel drawn so far is complete.
    void finish() const { gl_->finish(); }

private:
    Session(const gl::Context& gl, base::ThreadPool& pool);
    [[nodiscard]] frame::DisplaySettings display_settings(double exposure,
                                                          std::uint32_t count) const;
    [[nodiscard]] frame::FrameSpec frame_spec() const;
    /// The parts of the upload; each from job_, settings_ and plan_.
    /// `cache_folder`: where what is baked is kept; empty: nowhere.
    [[nodiscard]] base::Status upload_environment(const std::filesystem::path& cache_folder,
                                                  base::Warnings& warnings);
    void pack_lights();
    /// Light of the scene at the plan's probe: `probe_maps_`.
    [[nodiscard]] base::Status capture_probe();
    [[nodiscard]] base::Status make_frame();
    /// Sorts the triangles for rays, where the plan wants some and that is not done.
    [[nodiscard]] base::Status make_rays();
    /// Gives up what is asked, and the indirect light that was found.
    void forget_indirect();
    /// And the scene that rays see.
    void forget_rays();
    [[nodiscard]] base::Status change(const tables::Settings& settings, const Plan& plan,
                                      base::Warnings& warnings);
    [[nodiscard]] base::Status change_scene(const tables::Settings& settings, const Plan& plan);
    /// Plays what the settings say from now on; edits are made again.
    [[nodiscard]] base::Status change_time(const tables::Settings& settings, const Plan& plan,
                                           base::Warnings& warnings);
    /// Moves everything to where it is at `part` of the shutter's time.
    [[nodiscard]] base::Status move_to(float part);

    /// An environment on the GL, and what it was made from.
    struct Baked {
        std::shared_ptr<const image::Image> latlong;
        std::shared_ptr<const scene::Environment> rest;  ///< without the sun, which `maps` names
        tables::BrdfChoice brdf;
        float rotation_deg = 0.0F;
        float intensity = 1.0F;
        frame::EnvironmentMaps maps;
        base::Warnings warnings;
    };
    static constexpr std::size_t most_baked = 8;  // 4 MB each

    const gl::Context* gl_;
    base::ThreadPool* pool_;
    Assets* assets_ = nullptr;
    std::unique_ptr<Job> job_;  // what is traced keeps its address
    tables::Settings settings_;
    Plan plan_;
    std::unique_ptr<gl::ShaderSources> sources_;  // passes keep its address
    frame::GpuScene scene_;
    std::vector<Baked> baked_;                         ///< the one in use first, then by last use
    std::unique_ptr<frame::PackedLights> lights_;      ///< of pictures without rays, and
    std::unique_ptr<frame::PackedLights> ray_lights_;  ///< with them
    std::unique_ptr<trace::Tracer> tracer_;            ///< made at first need
    std::unique_ptr<TracedRays> rays_;                 ///< likewise
    std::unique_ptr<AskedRays> asked_;                 ///< running, or done and not taken
    bool has_indirect_ = false;                        ///< taken
    std::unique_ptr<frame::EnvironmentMaps>
        probe_maps_;                  ///< captured at need, until the scene changes
    tables::Settings clip_settings_;  ///< that the job's clip was chosen by
    bool holds_still_ = false;
    float part_ = shutter_middle;                ///< of the shutter's time, where everything is
    bool has_moved_ = false;                     ///< since the sample before
    std::optional<scene::Camera> moved_camera_;  ///< where a node carries it to, at `part_`
    std::optional<frame::Frame> frame_;
    std::optional<frame::Frame> probe_;          ///< made at first need
    std::optional<frame::Explainer> explainer_;  ///< likewise
    std::optional<scene::KeyLight> key_light_;   ///< found at first need

    [[nodiscard]] scene::KeyLight key_light_for(const std::vector<tables::Aov>& aovs);
    /// `key` outlives the result.
    [[nodiscard]] frame::FrameInputs inputs(const scene::KeyLight& key,
                                            bool with_rays = true) const;
};

}  // namespace facet::render
