// --list WHAT: from the tables, from resources/, or from the scene at hand.
// SPDX-License-Identifier: MIT
#include "cli/lists.h"

#include "base/text.h"
#include "base/thread_pool.h"
#include "brdf/presets.h"
#include "cli/scene_options.h"
#include "scene/builtin_files.h"
#include "scene/load.h"
#include "scene/material_file.h"
#include "tables/aovs.h"
#include "tables/brdf_terms.h"
#include "tables/environments.h"
#include "tables/lights.h"
#include "tables/tonemaps.h"
#include "teach/lesson.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

namespace facet::cli {
namespace {

using base::Result;

struct Entry {
    std::string name;
    std::string help;
};
using Entries = Result<std::vector<Entry>>;

template <class Rows>
std::vector<Entry> entries_of(const Rows& rows) {
    std::vector<Entry> entries;
    for (const auto& row : rows) entries.push_back({std::string(row.key), std::string(row.help)});
    return entries;
}

Entries list_scenes(const std::string&) {
    std::vector<Entry> entries;
    for (const std::string& name : scene::builtin_names(scene::builtin_scenes))
        entries.push_back({fmt::format("builtin:{}", name), ""});
    return entries;
}
Entries list_lamps(const std::string&) {
    std::vector<Entry> entries;
    for (const std::string& name : scene::builtin_names(scene::builtin_lamps))
        entries.push_back({fmt::format("ies:file=builtin:{}", name), ""});
    return entries;
}
Entries list_textures(const std::string&) {
    std::vector<Entry> entries;
    for (const std::string& name : scene::builtin_names(scene::builtin_textures))
        entries.push_back({fmt::format("builtin:{}", name), ""});
    return entries;
}
Entries list_environments(const std::string&) {
    std::vector<Entry> entries = entries_of(tables::environments);
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto keys = tables::environments[i].keys; !keys.empty())
            entries[i].help += fmt::format("; keys: {}", keys);
    return entries;
}
Entries list_aovs(const std::string&) { return entries_of(tables::aovs); }
Entries list_lights(const std::string&) { return entries_of(tables::light_kinds); }
Entries list_tonemaps(const std::string&) { return entries_of(tables::tonemaps); }
Entries list_brdf(const std::string&) {
    std::vector<Entry> entries;
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != slot.key || term.notes.lesson) continue;
            std::string name = fmt::format("{}={}", term.slot, term.name);
            std::ranges::replace(name, '_', '-');  // the command line writes dashes
            entries.push_back({std::move(name), std::string(term.notes.help)});
        }
    entries.push_back({"lecture", "the seed lecture's set, for lights and for the environment"});
    return entries;
}

Entries list_lessons(const std::string&) {
    const auto lessons = teach::all_lessons();
    if (!lessons) return tl::unexpected(lessons.error());
    std::vector<Entry> entries;
    for (const teach::Lesson& lesson : *lessons)
        entries.push_back({lesson.name, lesson.title("en")});
    return entries;
}
Entries list_presets(const std::string&) {
    std::vector<Entry> entries;
    for (const brdf::Preset& preset : brdf::presets()) {
        const math::Vec3& c = preset.is_metal ? preset.f0 : math::Vec3(preset.ior);
        entries.push_back(
            {std::string(preset.name),
             preset.is_metal
                 ? fmt::format("metal, F0 {:.3f} {:.3f} {:.3f}, tint at 82 degrees {:.3f} {:.3f} "
                               "{:.3f}{}; {}",
                               c.x, c.y, c.z, preset.edge_tint.x, preset.edge_tint.y,
                               preset.edge_tint.z, preset.is_clamped ? ", cut to Rec.709" : "",
                               preset.source)
                 : fmt::format("index {:g}, F0 {:.4f}; {}", preset.ior, preset.f0.x,
                               preset.source)});
    }
    return entries;
}

Result<scene::Scene> scene_of(const std::string& path, std::string_view what) {
    if (path.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--list",
                           .what = fmt::format("{} are those of a scene", what),
                           .remedy = fmt::format("facet render SCENE --list {}", what)});
    base::ThreadPool pool(1);
    auto loaded = scene::load(path, {.decode_images = false}, {}, pool);
    if (!loaded) return tl::unexpected(base::in_file(loaded.error(), path));
    return std::move(loaded->scene);
}
Entries list_material_presets() {
    std::vector<Entry> entries;
    for (const std::string& name : scene::material_presets()) {
        const auto file = scene::load_material(name, {});
        if (!file) return tl::unexpected(file.error());
        entries.push_back({name, fmt::format("{}; {}", file->name, file->source)});
    }
    return entries;
}
Entries list_cameras(const std::string& path) {
    const auto scene = scene_of(path, "cameras");
    if (!scene) return tl::unexpected(scene.error());
    std::vector<Entry> entries;
    for (const auto& camera : scene->cameras)
        entries.push_back(
            {camera.name, camera.node.empty() ? "" : fmt::format("node {}", camera.node)});
    return entries;
}
/// Those of the scene, or without one what --material can give it.
Entries list_materials(const std::string& path) {
    if (path.empty()) return list_material_presets();
    const auto scene = scene_of(path, "materials");
    if (!scene) return tl::unexpected(scene.error());
    std::vector<Entry> entries;
    for (const auto& material : scene->materials) entries.push_back({material.name, ""});
    return entries;
}

/// What can be listed. `scene` is the scene on the command line, or "".
struct Listing {
    std::string_view name;
    Entries (*entries)(const std::string& scene);
};
constexpr Listing listings[] = {{"scenes", list_scenes},   {"environments", list_environments},
                                {"cameras", list_cameras}, {"materials", list_materials},
                                {"lights", list_lights},   {"lamps", list_lamps},
                                {"aovs", list_aovs},       {"tonemaps", list_tonemaps},
                                {"brdf", list_brdf},       {"presets", list_presets},
                                {"lessons", list_lessons}, {"textures", list_textures}};

std::vector<std::string> names() {
    std::vector<std::string> out;
    for (const Listing& listing : listings) out.emplace_back(listing.name);
    return out;
}

/// What was given for the argument SCENE, if anything.
std::string scene_argument(const NamedCommand* command) {
    if (command == nullptr) return "";
    for (const Flag& flag : command->declared.flags) {
        if (flag.names != "SCENE") continue;
        if (auto* const* text = std::get_if<std::string*>(&flag.target)) return **text;
        if (auto* const* list = std::get_if<std::vector<std::string>*>(&flag.target))
            return (*list)->empty() ? "" : (*list)->front();
    }
    return "";
}

}  // namespace

std::string list_names() { return base::join(names(), " "); }

Result<Exit> print_list(const std::string& what, const NamedCommand* command, Io& io) {
    const auto* listing = std::ranges::find(listings, what, &Listing::name);
    if (listing == std::end(listings)) {
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--list",
                           .what = "no such list",
                           .found = what,
                           .remedy = base::suggestion(what, names())});
    }
    const auto entries = listing->entries(scene_argument(command));
    if (!entries) return tl::unexpected(entries.error());
    for (const Entry& entry : *entries) {
        if (io.json)
            io.print_object(nlohmann::ordered_json{{"name", entry.name}, {"help", entry.help}});
        else if (entry.help.empty())
            io.print(base::escaped(entry.name));
        else
            io.print(fmt::format("{:<28} {}", base::escaped(entry.name),
                                 base::escaped(entry.help, 400)));
    }
    return Exit::done;
}

}  // namespace facet::cli
