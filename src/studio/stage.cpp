// The picture in the viewport.
// SPDX-License-Identifier: MIT
#include "studio/stage.h"

#include "render/session.h"
#include "render/stopwatch.h"
#include "render/viewable.h"
#include "scene/light_shapes.h"
#include "studio/ui_renderer.h"

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

using math::Extent;

constexpr std::uint32_t least_side_px = 16;
/// The original beside the edited picture is drawn in one go, so with few samples.
constexpr std::uint32_t original_samples = 4;

Extent scaled(Extent size, double scale) {
    const auto side = [&](std::uint32_t px) {
        return std::max(least_side_px, static_cast<std::uint32_t>(std::lround(px * scale)));
    };
    return {side(size.width), side(size.height)};
}

/// Every material white, a world that shines 1 nit from everywhere and nothing else: what does not
/// come back is lost.
void make_furnace(tables::Settings& settings) {
    settings.env = "furnace";
    settings.env_intensity = 1.0F;
    settings.background = "env";
    settings.no_file_lights = true;
    settings.light.clear();
    settings.exposure = "1";
    settings.ev = std::nullopt;
    settings.tonemap = "none";
    std::erase_if(settings.set, [](const std::string& text) { return text.starts_with("light"); });
    for (const char* text : {"base_color=1 1 1", "emissive=0 0 0", "base_color_texture=none",
                             "occlusion_texture=none", "ao_strength=0"})
        settings.set.push_back(std::string("material.*.") + text);
}

/// Mid gray plaster on every material but one.
void make_gray(tables::Settings& settings, std::size_t material_count, std::size_t but) {
    for (std::size_t i = 0; i < material_count; ++i) {
        if (i == but) continue;
        for (const char* text : {"base_color", "metallic", "roughness", "emissive"})
            clear_path(settings, material_path(i, text));
        settings.set.push_back(material_path(i, "base_color=0.4 0.4 0.4"));
        settings.set.push_back(material_path(i, "metallic=0"));
        settings.set.push_back(material_path(i, "roughness=0.8"));
        settings.set.push_back(material_path(i, "emissive=0 0 0"));
        for (const tables::MaterialTexture& row : tables::material_textures)
            settings.set.push_back(material_path(i, std::string(row.key) + "=none"));
    }
}

/// The model's: not those of lights' shapes.
std::vector<scene::Material> materials_of(const scene::Scene& scene) {
    const auto count = static_cast<std::ptrdiff_t>(scene::model_counts(scene).materials);
    return {scene.materials.begin(), scene.materials.begin() + count};
}

bool same_picture(const Scenery& a, const Scenery& b) {
    return a.settings == b.settings && a.look.view == b.look.view && a.look.solo == b.look.solo &&
           a.solo == b.solo && a.area_px == b.area_px;
}

/// Sums of AOVs, where a view has several.
image::Layer sum_of(std::vector<image::Layer>& layers) {
    image::Layer out = std::move(layers.front());
    const auto values = out.image.as<float>();
    for (std::size_t i = 1; i < layers.size(); ++i) {
        const auto more = layers[i].image.as<float>();
        for (std::size_t k = 0; k < values.size(); ++k) values[k] += more[k];
    }
    return out;
}

}  // namespace

Stage::Stage(const StageTools& tools) : tools_(tools) {}
Stage::~Stage() = default;

const scene::Scene& Stage::scene() const { return session_->scene(); }
const render::Job& Stage::job() const { return session_->job(); }
const render::Plan& Stage::plan() const { return session_->plan(); }
math::Extent Stage::size_px() const { return session_->plan().picture; }

base::Status Stage::open(const Document& document, bool steady) {
    tables::Settings settings = document.settings;
    settings.size = {64, 64};
    settings.region.clear();
    settings.reference.clear();
    settings.compare = false;
    settings.time_limit = std::nullopt;
    settings.projection.clear();
    const auto plan = render::make_plan(settings);
    if (!plan) return tl::unexpected(plan.error());
    auto job = render::load_job(
        {.scene = document.scene, .settings = settings, .cache_folder = tools_.cache_folder}, *plan,
        tools_.pool);
    if (!job) return tl::unexpected(job.error());
    base::Warnings warnings = job->warnings;
    auto session =
        render::Session::create(tools_.gl, std::move(*job), settings, *plan, tools_.pool, warnings);
    if (!session) return tl::unexpected(session.error());
    session_ = std::make_unique<render::Session>(std::move(*session));
    session_->hold_still();  // rays are asked once, for one picture of what moves
    session_settings_ = settings;
    materials_ = materials_of(scene());
    lights_ = scene().lights;
    scene_name_ = document.scene;
    warnings_ = std::move(warnings);
    steady_ = steady;
    applied_.reset();
    finished_ = false;
    return {};
}

tables::Settings Stage::settings_for(const Scenery& scenery, Extent size) const {
    tables::Settings settings = scenery.settings;
    settings.size = size;
    settings.region.clear();
    settings.reference.clear();
    settings.time_limit = std::nullopt;
    settings.compare = false;
    settings.depth.clear();
    // A viewport is flat, and shows what a screen does.
    settings.distortion = 0.0F;
    settings.aberration = 0.0F;
    settings.gamut = "srgb";
    if (settings.projection == "panorama") settings.projection.clear();
    const View& view = view_by_key(scenery.look.view);
    settings.aov.clear();
    for (const tables::Aov aov : view.aovs) settings.aov.emplace_back(tables::row(aov).key);
    if (view.furnace && !scene().materials.empty()) make_furnace(settings);
    if (scenery.look.solo && scenery.solo) make_gray(settings, materials_.size(), *scenery.solo);
    return settings;
}

Extent Stage::size_for(const Scenery& scenery) const {
    const Extent full = scenery.area_px;
    if (steady_) return full;
    const double expected_ms = ms_per_pixel_ * static_cast<double>(full.pixels());
    if (expected_ms <= scenery.budget_ms) return full;
    // Steps, so that the targets are not made anew for every frame of a drag.
    for (const double scale : {0.75, 0.5, 0.375, 0.25})
        if (expected_ms * scale * scale <= scenery.budget_ms) return scaled(full, scale);
    return scaled(full, 0.1875);
}

bool Stage::is_slow(const Scenery& scenery, Extent size) const {
    return !steady_ && ms_per_pixel_ * static_cast<double>(size.pixels()) > 2.0 * scenery.budget_ms;
}

base::Status Stage::apply(const tables::Settings& settings) {
    const auto plan = render::make_plan(settings);
    if (!plan) return tl::unexpected(plan.error());
    warnings_.clear();
    if (auto s = session_->update(settings, *plan, warnings_); !s) return s;
    session_settings_ = settings;
    return {};
}

base::Status Stage::apply_variant(const tables::Settings& settings) {
    if (settings.variant == session_settings_.variant) return {};
    const auto plan = render::make_plan(settings);
    if (!plan) return tl::unexpected(plan.error());
    auto job = render::load_job({scene_name_, settings}, *plan, tools_.pool);
    if (!job) return tl::unexpected(job.error());
    warnings_ = job->warnings;
    if (auto s = session_->enter(std::move(*job), settings, *plan, warnings_); !s) return s;
    session_settings_ = settings;
    return {};
}

base::Status Stage::apply_scenery(const Scenery& scenery, Extent size) {
    Scenery plain = scenery;
    plain.look.solo = false;
    if (view_by_key(plain.look.view).furnace) plain.look.view = "beauty";
    const tables::Settings settings = settings_for(scenery, size);
    const tables::Settings plain_settings = settings_for(plain, size);
    if (auto s = apply_variant(plain_settings); !s) return s;
    if (auto s = apply(plain_settings); !s) return s;
    materials_ = materials_of(scene());
    lights_ = scene().lights;
    return settings == plain_settings ? base::Status{} : apply(settings);
}

std::uint32_t Stage::samples_wanted() const { return session_->plan().sample_count; }

base::Status Stage::step(const Scenery& scenery, UiRenderer& pictures) {
    const bool is_new = !applied_ || !same_picture(*applied_, scenery);
    const bool hurry = scenery.moving || !scenery.patient;
    const Extent size = is_new ? (hurry ? size_for(scenery) : scenery.area_px)
                               : (hurry ? size_px() : scenery.area_px);
    const bool restart = is_new || size != size_px();
    const bool look_changed = applied_ && !(applied_->look == scenery.look);
    if (restart) {
        if (auto s = apply_scenery(scenery, size); !s) return s;
        drawn_ = 0;
        original_shown_ = false;
    } else if (finished_ && !look_changed) {
        applied_->moving = scenery.moving;
        return {};
    }
    finished_ = false;
    const bool coarse = scenery.moving;
    const std::uint32_t wanted = coarse ? 1 : samples_wanted();
    // One sample of one is the pixel's centre, and is in no sum.
    if (!coarse && is_coarse_) drawn_ = 0;
    is_coarse_ = coarse;
    if (auto s = use_rays(scenery, restart); !s) return s;
    waiting_ = !restart && !look_changed && (drawn_ >= wanted || (hurry && is_slow(scenery, size)));
    if (waiting_) {
        applied_ = scenery;
        return {};
    }
    if (drawn_ < wanted)
        if (auto s = draw_sample(wanted); !s) return s;
    applied_ = scenery;
    finished_ = !coarse && drawn_ >= wanted && size == scenery.area_px &&
                (with_rays_ || !session_->plan().rays.any());
    return show(scenery, pictures);
}

base::Status Stage::use_rays(const Scenery& scenery, bool restart) {
    // They take long: somebody who waits gets them a while later, the rest of the samples with
    // them.
    if (restart) with_rays_ = steady_;
    if (with_rays_ || !session_->plan().rays.any()) return {};
    using Asked = render::Session::Asked;
    switch (session_->asked()) {
        case Asked::running:
            return {};
        case Asked::no:
            return scenery.patient && !scenery.moving ? session_->ask_rays() : base::Status{};
        case Asked::done:
            break;
    }
    with_rays_ = true;
    drawn_ = 0;
    return session_->take_rays();
}

base::Status Stage::draw_sample(std::uint32_t count) {
    render::Stopwatch watch;
    if (auto s = session_->draw(drawn_, count, nullptr, with_rays_); !s) return s;
    ++drawn_;
    session_->finish();
    last_ms_ = watch.lap_ms();
    const double each = last_ms_ / static_cast<double>(size_px().pixels());
    // A shader's first use compiles it: one slow frame says little, several do.
    if (!with_rays_)
        ms_per_pixel_ += (each - ms_per_pixel_) * (each > 4.0 * ms_per_pixel_ ? 0.1 : 0.4);
    if (session_->plan().exposure)
        exposure_ = *session_->plan().exposure;
    else if (drawn_ == 1 || drawn_ == count)
        exposure_ = session_->measure_exposure(drawn_);
    return {};
}

base::Status Stage::show(const Scenery& scenery, UiRenderer& pictures) {
    const View& view = view_by_key(scenery.look.view);
    if (finished_ && !view.aovs.empty())
        if (auto s = session_->draw_centered_aovs(); !s) return s;
    if (finished_ && scenery.look.beside == Beside::original && !original_shown_)
        if (auto s = show_original(scenery, pictures); !s) return s;
    if (auto s = session_->display(exposure_, drawn_); !s) return s;
    if (finished_) {
        shown_ = session_->read_display();
        ++shown_count_;
    }
    if (view.aovs.empty()) {
        pictures.hide(Slot::viewport);
        pictures.show(Slot::viewport, session_->display_texture());
        return {};
    }
    auto layers = session_->read_aovs(exposure_, drawn_);
    const image::Layer sum = sum_of(layers);
    pictures.hide(Slot::viewport);
    return pictures.upload(tools_.gl, Slot::viewport,
                           render::viewable(view.aovs.front(), sum, exposure_));
}

base::Status Stage::show_original(const Scenery& scenery, UiRenderer& pictures) {
    Scenery original = scenery;
    original.settings = scenery.opened;
    original.settings.camera = scenery.settings.camera;
    original.settings.fov = scenery.settings.fov;
    original.settings.variant = scenery.settings.variant;
    original.settings.animation = scenery.settings.animation;
    original.settings.time = scenery.settings.time;
    original.settings.samples = original_samples;
    const tables::Settings edited = session_settings_;
    const std::uint32_t drawn = drawn_;
    if (auto s = apply(settings_for(original, size_px())); !s) return s;
    for (std::uint32_t i = 0; i < original_samples; ++i)
        if (auto s = session_->draw(i, original_samples, nullptr, with_rays_); !s) return s;
    if (auto s = session_->display(exposure_, original_samples); !s) return s;
    if (auto s = pictures.upload(tools_.gl, Slot::original, session_->read_display()); !s) return s;
    // The edited picture again, all of it: its sum was drawn over.
    if (auto s = apply(edited); !s) return s;
    for (std::uint32_t i = 0; i < drawn; ++i)
        if (auto s = session_->draw(i, samples_wanted(), nullptr, with_rays_); !s) return s;
    original_shown_ = true;
    return {};
}

base::Status Stage::reload_shaders() {
    auto made = session_->reload_shaders();
    if (made) applied_.reset();
    return made;
}

base::Result<image::Image> Stage::encode(const image::Image& radiance) {
    if (auto s = session_->display_picture(radiance, exposure_); !s)
        return tl::unexpected(s.error());
    image::Image out = session_->read_display();
    if (auto s = session_->display(exposure_, drawn_); !s) return tl::unexpected(s.error());
    return out;
}

base::Result<std::vector<Probed>> Stage::probe(math::Vec2 at_px) {
    const Extent size = size_px();
    if (at_px.x < 0.0F || at_px.y < 0.0F || at_px.x >= static_cast<float>(size.width) ||
        at_px.y >= static_cast<float>(size.height))
        return std::vector<Probed>{};
    std::vector<tables::Aov> aovs;
    for (std::size_t i = 0; i < tables::aovs.size(); ++i)
        aovs.push_back(static_cast<tables::Aov>(i));
    const frame::Region region{
        static_cast<std::uint32_t>(at_px.x), static_cast<std::uint32_t>(at_px.y), {1, 1}};
    const auto layers = session_->probe(region, aovs);
    if (!layers) return tl::unexpected(layers.error());
    std::vector<Probed> out;
    for (std::size_t i = 0; i < aovs.size(); ++i) {
        const image::Image& image = (*layers)[i].image;
        const auto values = image.as<float>();
        math::Vec3 value(values[0]);
        if (image.channels >= 3) value = {values[0], values[1], values[2]};
        out.push_back({aovs[i], value});
    }
    return out;
}

}  // namespace facet::studio
