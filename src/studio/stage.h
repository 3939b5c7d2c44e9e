// The picture in the viewport: a session drawn a step at a time, coarse while things move, better
// while they rest. SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "image/image.h"
#include "studio/document.h"
#include "studio/look.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facet::gl {
class Context;
}
namespace facet::render {
class Session;
struct Job;
struct Plan;
}  // namespace facet::render

namespace facet::studio {

class UiRenderer;

/// Tools that outlive the stage.
struct StageTools {
    const gl::Context& gl;
    base::ThreadPool& pool;
    base::Log& log;
    std::filesystem::path cache_folder{};  ///< render::Request's
};

/// What the viewport shall show.
struct Scenery {
    tables::Settings settings;  ///< the document's
    tables::Settings opened;    ///< for the original beside it
    Look look;
    std::optional<std::size_t> solo;  ///< the one material that keeps its colours
    math::Extent area_px;
    double budget_ms = 55.0;  ///< that a step may take while somebody waits for it
    bool moving = false;      ///< somebody drags something
    bool patient = true;      ///< nobody did anything for a while: a sample may take long
};

/// A number that the frame's own shaders gave for one pixel.
struct Probed {
    tables::Aov aov{};
    math::Vec3 value{0.0F};
};

class Stage {
public:
    explicit Stage(const StageTools& tools);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    /// Loads the document's scene. On an error the one before stays. `steady`: always at full size,
    /// for pictures that must not depend on the machine's speed.
    [[nodiscard]] base::Status open(const Document& document, bool steady);
    [[nodiscard]] bool is_steady() const { return steady_; }
    [[nodiscard]] bool is_open() const { return session_ != nullptr; }

    /// Takes over what changed and draws one step. Errors: those of the settings; the picture is
    /// then as it was.
    [[nodiscard]] base::Status step(const Scenery& scenery, UiRenderer& pictures);
    /// Nothing is left to be done for this scenery.
    [[nodiscard]] bool is_finished() const { return finished_; }

    /// It could be better, but not before the person has rested for a while.
    [[nodiscard]] bool is_waiting() const { return waiting_; }

    [[nodiscard]] const scene::Scene& scene() const;
    /// As the document has them; the scene's own are those of the view.
    [[nodiscard]] const std::vector<scene::Material>& materials() const { return materials_; }
    [[nodiscard]] const std::vector<scene::Light>& lights() const { return lights_; }
    [[nodiscard]] const render::Job& job() const;
    [[nodiscard]] const render::Plan& plan() const;
    /// Those that the session draws: the document's, but for size and view.
    [[nodiscard]] const tables::Settings& settings() const { return session_settings_; }
    [[nodiscard]] const base::Warnings& warnings() const { return warnings_; }
    [[nodiscard]] base::Status reload_shaders();
    /// Reads the environment's and the materials' files again.
    void forget() { applied_.reset(); }

    /// Every AOV at one pixel of the viewport's picture; empty where that is outside.
    [[nodiscard]] base::Result<std::vector<Probed>> probe(math::Vec2 at_px);
    /// The finished picture as it is shown; rows from the top.
    [[nodiscard]] const image::Image& shown() const { return shown_; }
    /// Counts the pictures that shown() was.
    [[nodiscard]] std::uint32_t shown_count() const { return shown_count_; }
    /// Encodes radiance from elsewhere as the finished picture is.
    [[nodiscard]] base::Result<image::Image> encode(const image::Image& radiance);

    [[nodiscard]] std::uint32_t samples() const { return drawn_; }
    [[nodiscard]] std::uint32_t samples_wanted() const;
    [[nodiscard]] double exposure() const { return exposure_; }
    [[nodiscard]] math::Extent size_px() const;
    [[nodiscard]] double last_ms() const { return last_ms_; }
    [[nodiscard]] const std::string& scene_name() const { return scene_name_; }

private:
    [[nodiscard]] tables::Settings settings_for(const Scenery& scenery, math::Extent size) const;
    [[nodiscard]] math::Extent size_for(const Scenery& scenery) const;
    /// A sample of that size makes a person wait.
    [[nodiscard]] bool is_slow(const Scenery& scenery, math::Extent size) const;
    [[nodiscard]] base::Status apply(const tables::Settings& settings);
    /// Loads the scene again where another variant of it is wanted; on an error the one before
    /// stays.
    [[nodiscard]] base::Status apply_variant(const tables::Settings& settings);
    /// What the view shows, and materials() and lights() of the document.
    [[nodiscard]] base::Status apply_scenery(const Scenery& scenery, math::Extent size);
    /// Asks for rays, and takes what they found.
    [[nodiscard]] base::Status use_rays(const Scenery& scenery, bool restart);
    [[nodiscard]] base::Status draw_sample(std::uint32_t count);
    [[nodiscard]] base::Status show(const Scenery& scenery, UiRenderer& pictures);
    [[nodiscard]] base::Status show_original(const Scenery& scenery, UiRenderer& pictures);

    StageTools tools_;
    bool steady_ = false;
    std::string scene_name_;
    std::unique_ptr<render::Session> session_;
    base::Warnings warnings_;
    std::optional<Scenery> applied_;  ///< none: everything has to be taken over
    tables::Settings session_settings_;
    std::uint32_t drawn_ = 0;
    bool is_coarse_ = false;  ///< drawn_ is one sample of one
    bool with_rays_ = false;  ///< so are the samples
    bool finished_ = false;
    bool waiting_ = false;
    bool original_shown_ = false;
    double exposure_ = 1.0;
    double ms_per_pixel_ = 8e-5;  ///< a guess, until the first frame is measured
    double last_ms_ = 0.0;
    image::Image shown_;
    std::uint32_t shown_count_ = 0;
    std::vector<scene::Material> materials_;
    std::vector<scene::Light> lights_;
};

}  // namespace facet::studio
