// facet convert-material: materials between the two workflows.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "base/thread_pool.h"
#include "cli/flags.h"
#include "cli/scene_options.h"
#include "scene/load.h"
#include "scene/save.h"
#include "scene/workflow.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <array>
#include <memory>

namespace facet::cli {
namespace {

using base::Result;
using scene::Workflow;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> workflow_names = {"metal-roughness",
                                                            "specular-glossiness"};

struct ConvertOptions {
    std::string scene;
    std::string output;
    std::string to;
    bool keep_existing = false;
    TypedSettings typed;
};

/// Left out: to metal-roughness where the scene has the other, else from it.
Result<Workflow> workflow_of(const std::string& name, const scene::Scene& scene) {
    if (name.empty())
        return has_other(scene, Workflow::metallic_roughness) ? Workflow::metallic_roughness
                                                              : Workflow::specular_glossiness;
    for (std::size_t i = 0; i < workflow_names.size(); ++i)
        if (workflow_names[i] == name) return static_cast<Workflow>(i);
    return base::fail({.code = base::ErrorCode::usage,
                       .file = "--to",
                       .what = "no such workflow",
                       .found = name,
                       .remedy = fmt::format("{} or {}", workflow_names[0], workflow_names[1])});
}

base::Status check(const ConvertOptions& options) {
    const auto refuse = [](std::string what, std::string found, std::string remedy) {
        return base::fail({.code = base::ErrorCode::usage,
                           .what = std::move(what),
                           .found = std::move(found),
                           .remedy = std::move(remedy)});
    };
    if (options.scene.empty()) return refuse("no scene given", "", "facet convert-material SCENE");
    if (options.output.empty()) return refuse("no output given", "", "-o OUT.glb or OUT.gltf");
    std::error_code error;
    if (options.keep_existing && fs::exists(options.output, error))
        return refuse("the output is there already", options.output,
                      "another name, or leave --no-clobber out");
    return {};
}

Result<Exit> run_convert(const ConvertOptions& options, Io& io) {
    if (auto s = check(options); !s) return tl::unexpected(s.error());
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    base::ThreadPool pool(settings->threads);
    scene::LoadOptions loading = load_options(*settings);
    loading.decode_images = true;
    auto loaded = scene::load(options.scene, loading, limits_of(*settings), pool);
    if (!loaded) return tl::unexpected(base::in_file(loaded.error(), options.scene));
    const auto to = workflow_of(options.to, loaded->scene);
    if (!to) return tl::unexpected(to.error());
    scene::Scene converted = loaded->scene;
    base::Warnings warnings = loaded->warnings;
    scene::convert(converted, *to, warnings);
    std::size_t count = 0;
    for (std::size_t i = 0; i < converted.materials.size(); ++i)
        if (converted.materials[i].has_glossiness != loaded->scene.materials[i].has_glossiness)
            ++count;
    const auto saved = scene::save({.source = options.scene,
                                    .original = loaded->scene,
                                    .edited = converted,
                                    .target = options.output,
                                    .options = loading},
                                   limits_of(*settings));
    if (!saved) return tl::unexpected(saved.error());
    warnings.insert(warnings.end(), saved->warnings.begin(), saved->warnings.end());
    io.warn(warnings);
    const std::string_view name = workflow_names[static_cast<std::size_t>(*to)];
    if (io.json)
        io.print_object({{"facet", 1},
                         {"output", options.output},
                         {"to", name},
                         {"converted", count},
                         {"materials", converted.materials.size()}});
    else
        io.print(fmt::format("{}  {} of {} materials to {}", base::escaped(options.output, 4096),
                             count, converted.materials.size(), name));
    return Exit::done;
}

}  // namespace

void add_convert_material(Declaration& command) {
    auto options = std::make_shared<ConvertOptions>();
    auto& flags = command.flags;
    flags.push_back({"SCENE", &options->scene, "", "", ".gltf, .glb or builtin:NAME"});
    flags.push_back({"-o,--output", &options->output, "FILE", "Output",
                     ".gltf or .glb; what is no material stays as it is"});
    flags.push_back({"--to", &options->to, "metal-roughness|specular-glossiness", "Output",
                     "workflow (the other one); textures are baked where they must be"});
    flags.push_back(
        {"--no-clobber", &options->keep_existing, "", "Output", "refuses to replace a file"});
    options->typed.declare(flags, concerns_loading);
    command.job = [options](Io& io) { return run_convert(*options, io); };
}

}  // namespace facet::cli
