// Pictures of the presets.
// SPDX-License-Identifier: MIT
#include "studio/thumbnails.h"

#include "render/session.h"
#include "scene/material_file.h"

namespace facet::studio {
namespace {

constexpr math::Extent size_px{112, 112};
constexpr std::uint32_t thumbnail_samples = 4;

tables::Settings settings_of(const std::string& preset) {
    tables::Settings settings;
    settings.size = size_px;
    settings.samples = thumbnail_samples;
    settings.background = "none";
    settings.exposure = "1";
    settings.camera = "orbit:azimuth=30,elevation=20";
    settings.material = {"*=" + preset};
    return settings;
}

}  // namespace

Thumbnails::Thumbnails(const StageTools& tools)
    : tools_(tools), names_(scene::material_presets()) {}
Thumbnails::~Thumbnails() = default;

base::Status Thumbnails::open() {
    const tables::Settings settings = settings_of(names_.front());
    const auto plan = render::make_plan(settings);
    if (!plan) return tl::unexpected(plan.error());
    auto job = render::load_job(
        {.scene = "builtin:furnace", .settings = settings, .cache_folder = tools_.cache_folder},
        *plan, tools_.pool);
    if (!job) return tl::unexpected(job.error());
    // Of the scene's balls one is enough.
    job->scene.instances.resize(1);
    if (auto s = render::aim_camera(settings, *job); !s) return s;
    base::Warnings warnings;
    auto session =
        render::Session::create(tools_.gl, std::move(*job), settings, *plan, tools_.pool, warnings);
    if (!session) return tl::unexpected(session.error());
    session_ = std::make_unique<render::Session>(std::move(*session));
    return {};
}

base::Status Thumbnails::step(UiRenderer& pictures) {
    if (is_finished()) return {};
    const std::size_t preset = next_++;
    if (!session_)
        if (auto s = open(); !s) return s;
    const tables::Settings settings = settings_of(names_[preset]);
    const auto plan = render::make_plan(settings);
    if (!plan) return tl::unexpected(plan.error());
    base::Warnings warnings;
    if (auto s = session_->update(settings, *plan, warnings); !s) return s;
    for (std::uint32_t i = 0; i < thumbnail_samples; ++i)
        if (auto s = session_->draw(i, thumbnail_samples); !s) return s;
    if (auto s = session_->display(1.0, thumbnail_samples); !s) return s;
    auto s = pictures.upload(tools_.gl, slot_of(preset), session_->read_display());
    if (is_finished()) session_.reset();
    return s;
}

}  // namespace facet::studio
