// What the menus do: saving.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "render/job.h"
#include "render/plan.h"
#include "scene/builtin_files.h"
#include "scene/load.h"
#include "scene/material_file.h"
#include "scene/save.h"
#include "studio/commands.h"
#include "tables/settings_text.h"

#include <spdlog/fmt/fmt.h>

namespace facet::studio {

namespace fs = std::filesystem;

base::Result<Document> Commands::command_document() const {
    const Document& document = tools_.editor.document;
    if (!saved_over_) return document;
    const tables::Settings& now = document.settings;
    if (now.set != saved_over_->set || now.light != saved_over_->light ||
        now.no_file_lights != saved_over_->no_file_lights || now.material != saved_over_->material)
        return base::fail({.code = base::ErrorCode::usage,
                           .file = document.scene,
                           .what = tools_.ui.t("studio.saved_over"),
                           .remedy = tools_.ui.t("studio.saved_over.remedy")});
    // What the file was given needs no flags any more.
    Document out = document;
    out.settings.set.clear();
    out.settings.light.clear();
    out.settings.material.clear();
    out.settings.no_file_lights = false;
    return out;
}

base::Status Commands::save_to(const fs::path& path) {
    if (has_ending(path, FilePurpose::save_scene)) return save_scene(path);
    if (has_ending(path, FilePurpose::save_material)) return save_material(path);
    if (has_ending(path, FilePurpose::save_picture)) return save_picture(path);
    return base::fail({.code = base::ErrorCode::usage,
                       .file = path.string(),
                       .what = "nothing is saved under this ending",
                       .found = path.extension().string(),
                       .remedy = ".glb .gltf for the scene, .json for a material, .png .exr for a "
                                 "picture"});
}

base::Status Commands::save_picture(const fs::path& path) {
    if (child_)
        return base::fail({.code = base::ErrorCode::temporary,
                           .file = path.string(),
                           .what = "another picture is still being rendered",
                           .remedy = "wait for it"});
    if (auto writable = base::check_writable(path); !writable) return writable;
    const auto document = command_document();
    if (!document) return tl::unexpected(document.error());
    auto child = Child::start(
        tables::command_words("render", document->scene, document->settings, path.string()));
    if (!child) return tl::unexpected(child.error());
    child_ = std::move(*child);
    child_output_ = path;
    tools_.editor.say(Message::Kind::note,
                      fmt::format("{} {}", tools_.ui.t("studio.rendering"), path.string()));
    return {};
}

base::Status Commands::save_material(const fs::path& path) {
    if (tools_.stage.materials().empty())
        return base::fail(
            {.code = base::ErrorCode::usage, .what = tools_.ui.t("studio.no_materials")});
    const std::string text = scene::material_text(tools_.stage.materials()[material()]);
    auto written =
        base::write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
    if (written)
        tools_.editor.say(Message::Kind::note,
                          fmt::format("{} {}", tools_.ui.t("studio.saved"), path.string()));
    return written;
}
base::Status Commands::save_scene(const fs::path& path) {
    Editor& editor = tools_.editor;
    const render::Job& job = tools_.stage.job();
    scene::Scene original;
    original.materials = job.originals.materials;
    original.lights = job.originals.lights;
    scene::Scene edited;
    edited.materials = tools_.stage.materials();
    edited.lights = tools_.stage.lights();
    edited.images = job.scene.images;
    const tables::Settings& settings = editor.document.settings;
    scene::LoadOptions options;
    options.allowed_folders.assign(settings.allow_read.begin(), settings.allow_read.end());
    const auto saved = scene::save({.source = editor.document.scene,
                                    .original = original,
                                    .edited = edited,
                                    .target = path,
                                    .options = options},
                                   tools_.stage.plan().limits);
    if (!saved) return tl::unexpected(saved.error());
    for (const base::Warning& warning : saved->warnings)
        editor.say(Message::Kind::warning, base::to_line(warning));
    std::error_code error;
    const auto source = scene::file_of(editor.document.scene, scene::builtin_scenes);
    if (source && fs::equivalent(*source, path, error)) saved_over_ = settings;
    editor.unsaved = false;
    kept_.reset();
    recovery_.drop();
    // Our own writing is no news.
    scene_files_.set(job.reads);
    editor.say(Message::Kind::note,
               fmt::format("{} {}", tools_.ui.t("studio.saved"), path.string()));
    return {};
}

}  // namespace facet::studio
