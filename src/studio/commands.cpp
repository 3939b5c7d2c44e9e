// What the menus do.
// SPDX-License-Identifier: MIT
#include "studio/commands.h"

#include "base/resources.h"
#include "base/text.h"
#include "render/job.h"
#include "scene/load.h"
#include "tables/settings_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::studio {
namespace {

namespace fs = std::filesystem;

constexpr auto look_every = std::chrono::seconds(1);

}  // namespace

Commands::Commands(const CommandTools& tools, fs::path recovery_folder)
    : tools_(tools), recovery_(std::move(recovery_folder)) {
    if (!tools_.steady) recovered_ = recovery_.find();
    if (const auto folder = base::data_folder()) shader_files_.set_folder(*folder / "glsl");
}

std::size_t Commands::material() const {
    const std::size_t count = tools_.stage.materials().size();
    return count == 0 ? 0 : std::min(tools_.editor.material.value_or(0), count - 1);
}

base::Status Commands::open_scene(const Document& document) {
    if (auto s = tools_.stage.open(document, tools_.steady); !s) return s;
    // Textures of the scene before are gone.
    for (const Slot slot : {Slot::viewport, Slot::original, Slot::reference, Slot::difference})
        tools_.ui.pictures.hide(slot);
    Editor& editor = tools_.editor;
    editor.document = document;
    editor.opened = document.settings;
    editor.history.clear();
    editor.unsaved = false;
    editor.material = std::nullopt;
    editor.light = std::nullopt;
    editor.orbit = std::nullopt;
    saved_over_.reset();
    kept_.reset();
    recovery_.drop();
    for (const base::Warning& warning : tools_.stage.warnings())
        editor.say(Message::Kind::warning, base::to_line(warning));
    scene_files_.set(tools_.stage.job().reads);
    if (!document.scene.starts_with(scene::builtin_prefix)) tools_.config.remember(document.scene);
    return {};
}

fs::path Commands::scene_folder() const {
    const std::string& scene = tools_.editor.document.scene;
    std::error_code error;
    return scene.starts_with(scene::builtin_prefix) ? fs::current_path(error)
                                                    : fs::absolute(scene, error).parent_path();
}

void Commands::act(Action action) {
    const std::string_view menu = actions[static_cast<std::size_t>(action)].menu;
    if (menu == "file") return act_file(action);
    if (menu == "edit") return act_edit(action);
    if (action == Action::keys)
        shows_keys_ = !shows_keys_;
    else
        act_view(action);
}

void Commands::choose_file(FilePurpose purpose, const std::string& name) {
    dialog_.open(purpose, scene_folder() / name);
}

void Commands::act_file(Action action) {
    Editor& editor = tools_.editor;
    const std::string& scene = editor.document.scene;
    const bool is_builtin = scene.starts_with(scene::builtin_prefix);
    const std::string stem = scene::stem_of(scene);
    if (action == Action::open) choose_file(FilePurpose::open_scene, "");
    if (action == Action::open_environment) choose_file(FilePurpose::open_environment, "");
    if (action == Action::save && !is_builtin) {
        if (auto s = save_to(scene); !s) editor.complain(s.error());
    } else if (action == Action::save || action == Action::save_as) {
        choose_file(FilePurpose::save_scene,
                    is_builtin ? stem + ".glb" : fs::path(scene).filename().string());
    }
    if (action == Action::save_material && !tools_.stage.materials().empty())
        choose_file(FilePurpose::save_material,
                    tools_.stage.materials()[material()].name + ".json");
    if (action == Action::save_picture) choose_file(FilePurpose::save_picture, stem + ".png");
    if (action == Action::quit) editor.wanted.quit = true;
    if (action != Action::copy_command) return;
    const auto document = command_document();
    if (!document) return editor.complain(document.error());
    ImGui::SetClipboardText(
        tables::command_line(
            tables::command_words("render", document->scene, document->settings, stem + ".png"))
            .c_str());
    editor.say(Message::Kind::note, tools_.ui.t("studio.command_copied"));
}

void Commands::act_edit(Action action) {
    Editor& editor = tools_.editor;
    if (action == Action::undo) editor.history.undo(editor.document.settings);
    if (action == Action::redo) editor.history.redo(editor.document.settings);
    if (action == Action::copy) editor.wanted.copy_material = true;
    if (action == Action::paste) editor.paste_material(material());
    if (action == Action::reset) editor.clear(material_path(material(), ""));
    if (action == Action::reset_all) {
        editor.history.seal();
        const std::string camera = editor.document.settings.camera;
        editor.edit("reset all", [&](tables::Settings& settings) {
            settings = editor.opened;
            settings.camera = camera;
        });
    }
}

void Commands::frame_selected() {
    Editor& editor = tools_.editor;
    const scene::Scene& scene = tools_.stage.scene();
    math::Bounds bounds;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh.index];
        if (editor.material && mesh.material.index != *editor.material) continue;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const math::Bounds& b = mesh.bounds_m;
            const math::Vec3 at((corner & 1U) != 0 ? b.high.x : b.low.x,
                                (corner & 2U) != 0 ? b.high.y : b.low.y,
                                (corner & 4U) != 0 ? b.high.z : b.low.z);
            bounds.add(math::Vec3(instance.world_from_object * math::Vec4(at, 1.0F)));
        }
    }
    const scene::Camera& camera = tools_.stage.job().camera;
    const math::Extent size = tools_.stage.size_px();
    Orbit orbit = orbit_of(camera, scene.bounds_m());
    frame(orbit, bounds, camera.yfov_rad,
          static_cast<float>(size.width) / static_cast<float>(std::max(1U, size.height)));
    editor.look_from(orbit, camera.yfov_rad);
}

void Commands::act_view(Action action) {
    Editor& editor = tools_.editor;
    Look& look = editor.look;
    const auto beside = [&](Beside what) {
        look.beside = look.beside == what ? Beside::nothing : what;
    };
    const auto from = [&](float azimuth_deg, float elevation_deg) {
        Orbit orbit = orbit_of(tools_.stage.job().camera, tools_.stage.scene().bounds_m());
        orbit.azimuth_deg = azimuth_deg;
        orbit.elevation_deg = elevation_deg;
        orbit.target_m = tools_.stage.scene().bounds_m().center();
        editor.look_from(orbit, tools_.stage.job().camera.yfov_rad);
    };
    if (action == Action::frame_selected) frame_selected();
    if (action == Action::view_home) {
        editor.document.settings.camera = editor.opened.camera;
        editor.document.settings.fov = editor.opened.fov;  // look_from() kept another camera's
    }
    if (action == Action::view_front) from(0.0F, 0.0F);
    if (action == Action::view_right) from(90.0F, 0.0F);
    if (action == Action::view_top) from(0.0F, 90.0F);
    if (action == Action::beside_original) beside(Beside::original);
    if (action == Action::beside_reference) beside(Beside::reference);
    if (action == Action::beside_difference) beside(Beside::difference);
    if (action == Action::toggle_solo) look.solo = !look.solo;
    if (action == Action::toggle_clipping) look.clipping = !look.clipping;
    if (action == Action::next_view) {
        const auto now = static_cast<std::size_t>(&view_by_key(look.view) - views().data());
        look.view = views()[(now + 1) % views().size()].key;
    }
    if (action == Action::toggle_theme)
        tools_.config.theme = tools_.config.theme == Theme::dark ? Theme::light : Theme::dark;
    if (action == Action::toggle_language)
        tools_.config.language = tools_.ui.t.language() == "ru" ? "en" : "ru";
}

void Commands::take_file(FilePurpose purpose, const fs::path& path) {
    Editor& editor = tools_.editor;
    base::Status done;
    if (purpose == FilePurpose::open_scene) {
        Document document{path.string(), editor.document.settings};
        // What was said of the old scene says nothing of the new one.
        document.settings.set.clear();
        document.settings.light.clear();
        document.settings.camera = "auto";
        document.settings.fov = 0.0F;
        document.settings.material.clear();
        done = open_scene(document);
    } else if (purpose == FilePurpose::open_environment) {
        editor.history.seal();
        editor.edit("env", [&](tables::Settings& settings) { settings.env = path.string(); });
    } else if (purpose == FilePurpose::open_texture && texture_slot_) {
        editor.history.seal();
        const std::string_view key = tables::material_textures[*texture_slot_].key;
        editor.set(material_path(material(), key), path.string());
    } else {
        done = save_to(path);
    }
    if (!done) editor.complain(done.error());
}

void Commands::drop_files(const Input& input) {
    if (input.dropped.empty()) return;
    const fs::path& path = input.dropped.front();
    if (has_ending(path, FilePurpose::open_scene)) return take_file(FilePurpose::open_scene, path);
    // Onto a texture's row it is a texture, elsewhere an environment.
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot) {
        const auto row = tools_.ui.widgets.find(tables::material_textures[slot].key);
        if (row == tools_.ui.widgets.end()) continue;
        const Widget& w = row->second;
        const math::Vec2 at = input.mouse_px;
        if (at.x < w.low_px.x || at.x > w.high_px.x || at.y < w.low_px.y || at.y > w.high_px.y)
            continue;
        texture_slot_ = slot;
        return take_file(FilePurpose::open_texture, path);
    }
    if (has_ending(path, FilePurpose::open_environment))
        return take_file(FilePurpose::open_environment, path);
    tools_.editor.say(Message::Kind::warning, tools_.ui.t("studio.drop_help"));
}

void Commands::keep_work() {
    Editor& editor = tools_.editor;
    if (editor.plays) return;  // every frame has a time of its own
    if (!editor.unsaved || kept_ == editor.document.settings || ImGui::IsAnyItemActive()) return;
    if (auto s = recovery_.keep(editor.document); !s)
        editor.say(Message::Kind::warning, base::to_line(s.error()));
    kept_ = editor.document.settings;
}

bool Commands::sees_changes() {
    const auto now = std::chrono::steady_clock::now();
    if (!tools_.steady && now - looked_ >= look_every) {
        looked_ = now;
        shaders_changed_ = shader_files_.has_changed() || shaders_changed_;
        scene_changed_ = scene_files_.has_changed() || scene_changed_;
    }
    return shaders_changed_ || scene_changed_;
}

void Commands::look_at_files() {
    if (!sees_changes()) return;
    if (std::exchange(shaders_changed_, false)) {
        if (auto s = tools_.stage.reload_shaders(); !s)
            tools_.editor.complain(s.error());
        else
            tools_.editor.say(Message::Kind::note, tools_.ui.t("studio.shaders_reloaded"));
    }
    if (!std::exchange(scene_changed_, false)) return;
    // The document stays: edits are laid over what the file says now.
    if (auto s = tools_.stage.open(tools_.editor.document, tools_.steady); !s)
        return tools_.editor.complain(s.error());
    tools_.ui.pictures.hide(Slot::viewport);
    scene_files_.set(tools_.stage.job().reads);
    tools_.editor.say(Message::Kind::note, tools_.ui.t("studio.scene_reloaded"));
}

void Commands::take_child() {
    if (!child_) return;
    const auto end = child_->poll();
    if (!end) return;
    child_.reset();
    if (end->status == 0)
        tools_.editor.say(Message::Kind::note, fmt::format("{} {}", tools_.ui.t("studio.saved"),
                                                           child_output_.string()));
    else
        tools_.editor.say(Message::Kind::error, end->message);
}

void Commands::update() {
    if (const auto path = dialog_.draw(tools_.ui)) take_file(dialog_.purpose(), *path);
    Wanted& wanted = tools_.editor.wanted;
    if (const auto slot = std::exchange(wanted.texture, std::nullopt)) {
        texture_slot_ = slot;
        choose_file(FilePurpose::open_texture, "");
    }
    keep_work();
    take_child();
    look_at_files();
}

bool Commands::may_close() {
    if (!tools_.editor.unsaved || closing_ == Closing::yes) return true;
    closing_ = Closing::asked;
    return false;
}

}  // namespace facet::studio
