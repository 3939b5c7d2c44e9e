// A scene on the GL, ready to be drawn as often as wanted: what render(), the benchmark and the
// studio share. SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/thread_pool.h"
#include "frame/frame.h"
#include "render/job.h"
#include "render/plan.h"

#include <optional>
#include <string>

namespace facet::render {

class Session {
public:
    /// Loads while the context comes up, then uploads. Fills the times, counts and warnings of
    /// `out`. `plan`, `pool` and `log` outlive the session. Errors: as render().
    [[nodiscard]] static base::Result<Session> create(const Request& request, const Plan& plan,
                                                      base::ThreadPool& pool, base::Log& log,
                                                      Rendered& out);

    [[nodiscard]] base::Status draw(std::uint32_t index, std::uint32_t count,
                                    frame::PassTimes* times = nullptr);
    [[nodiscard]] base::Status draw_centered_aovs();
    /// The contract's automatic exposure of the `count` frames drawn.
    [[nodiscard]] double measure_exposure(std::uint32_t count);
    /// Encodes for a screen, on the GL; read_display() fetches the picture.
    [[nodiscard]] base::Status display(double exposure, std::uint32_t count);
    [[nodiscard]] image::Image read_display() const { return frame_->read_display(*gl_); }
    [[nodiscard]] const scene::Scene& scene() const { return job_.scene; }
    [[nodiscard]] const Job& job() const { return job_; }
    /// Replaces the scene's lights from the next frame on.
    void set_lights(std::span<const scene::Light> lights);
    /// display() of a picture that comes from elsewhere: f32 [height, width, 4], nit, associated
    /// coverage.
    [[nodiscard]] base::Status display_picture(const image::Image& radiance, double exposure);
    /// Lays radiance over the background colour, where one is named.
    void lay_over_background(image::Image& radiance, double exposure) const;
    /// Beauty as radiance in nit, over the background colour where one is named.
    [[nodiscard]] image::Layer read_beauty(double exposure, std::uint32_t count) const;
    /// Likewise `background` among AOVs, where `radiance` is what the picture is of itself.
    void lay_over_background(std::vector<image::Layer>& aovs, const image::Image& radiance,
                             double exposure) const;
    [[nodiscard]] std::vector<image::Layer> read_aovs(double exposure, std::uint32_t count) const;

    /// Changes which further outputs there are, from the next frame on, which is sample 0. Nothing
    /// that is compiled is compiled again. draw() gives those that are averaged,
    /// draw_centered_aovs() the others.
    [[nodiscard]] base::Status set_aovs(std::vector<tables::Aov> aovs);
    /// One of them as frame.h has it, or read back; none where it was not asked for.
    [[nodiscard]] const gl::Texture* aov_texture(tables::Aov aov) const {
        return frame_->aov_texture(aov);
    }
    [[nodiscard]] std::optional<image::Layer> read_aov(tables::Aov aov, std::uint32_t count) const {
        return frame_->read_aov(*gl_, aov, count);
    }
    /// Returns when every pixel drawn so far is complete.
    void finish() const { gl_->finish(); }

private:
    Session(const Plan& plan, base::ThreadPool& pool) : plan_(&plan), pool_(&pool) {}
    [[nodiscard]] frame::DisplaySettings display_settings(double exposure,
                                                          std::uint32_t count) const;
    /// Beauty as radiance in nit, of itself: with its coverage.
    [[nodiscard]] image::Image read_mean(std::uint32_t count) const;
    [[nodiscard]] base::Status upload(const tables::Settings& settings, base::Warnings& warnings);

    const Plan* plan_;
    base::ThreadPool* pool_;
    // Declared first, so that it dies last: every GL object below needs it.
    std::optional<gl::Context> gl_;
    Job job_;
    std::unique_ptr<gl::ShaderSources> sources_;  // passes keep its address
    frame::GpuScene scene_;
    frame::EnvironmentMaps environment_;
    std::unique_ptr<frame::PackedLights> lights_;
    std::optional<frame::Frame> frame_;
    std::vector<tables::Aov> aovs_;
    scene::KeyLight key_light_;

    [[nodiscard]] frame::FrameInputs inputs() const {
        return {scene_, environment_, *lights_, job_.camera, plan_->background, key_light_};
    }
};

}  // namespace facet::render
