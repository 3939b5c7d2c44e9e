// facet render: one picture of a scene.
// SPDX-License-Identifier: MIT
#include "base/cache_folder.h"
#include "base/text.h"
#include "cli/flags.h"
#include "cli/output_gate.h"
#include "cli/progress.h"
#include "cli/setting_flags.h"
#include "gl/context.h"
#include "render/picture_file.h"
#include "render/render.h"
#include "scene/load.h"
#include "tables/message_json.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::fail;
using base::Result;
using Clock = std::chrono::steady_clock;

struct RenderOptions {
    std::string scene;
    std::string output;
    OutputRules rules;
    bool show_reads = false;
    TypedSettings typed;
};

base::Status check_standard_input() {
    const int mode = ::fcntl(STDIN_FILENO, F_GETFL);
    if (mode < 0 || (mode & O_ACCMODE) == O_WRONLY)
        return fail({.code = ErrorCode::usage,
                     .file = "-",
                     .what = "standard input is closed",
                     .remedy = "give a file"});
    if (::isatty(STDIN_FILENO) == 1)
        return fail({.code = ErrorCode::usage,
                     .file = "-",
                     .what = "standard input is a terminal",
                     .remedy = "give a file"});
    return {};
}

/// Everything that is wrong with the request and can be known before it is begun.
base::Status check(const RenderOptions& options, const tables::Settings& settings, const Io& io) {
    if (options.scene.empty())
        return fail({.code = ErrorCode::usage,
                     .what = "no scene given",
                     .remedy = "facet render SCENE, for example builtin:showcase"});
    if (options.scene == "-")
        if (auto input = check_standard_input(); !input) return input;
    if (options.output != "-")
        return check_output(options.output, options.rules,
                            std::vector{options.scene, settings.env});
    if (io.json)
        return fail({.code = ErrorCode::usage,
                     .file = "--json",
                     .what = "excludes -o -",
                     .remedy = "standard output can hold the picture or the result, not both"});
    if (!settings.aov.empty())
        return fail({.code = ErrorCode::usage,
                     .file = "--aov",
                     .what = "excludes -o -",
                     .remedy = "give a file"});
    if (io.out_is_terminal())
        return fail({.code = ErrorCode::usage,
                     .file = "-",
                     .what = "standard output is a terminal",
                     .remedy = "send it to a file or a pipe"});
    return {};
}

nlohmann::ordered_json result_object(const std::string& output, const render::Rendered& r) {
    nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
    for (const base::Warning& warning : r.warnings)
        warnings.push_back(tables::message_object(warning));
    nlohmann::ordered_json object = {{"facet", 1},
                                     {"output", output},
                                     {"width", r.size.width},
                                     {"height", r.size.height},
                                     {"exposure", r.exposure},
                                     {"ms",
                                      {{"load", r.ms.load},
                                       {"upload", r.ms.upload},
                                       {"render", r.ms.render},
                                       {"write", r.ms.write}}},
                                     {"backend", r.backend},
                                     {"triangles", r.triangles},
                                     {"materials", r.materials},
                                     {"warnings", warnings}};
    if (r.reference)
        object["reference"] = {{"samples", r.reference->samples},
                               {"noise", r.reference->noise},
                               {"paths", r.reference->paths},
                               {"rays", r.reference->rays},
                               {"stopped_by_time", r.reference->stopped_by_time},
                               {"build_s", r.reference->build_s},
                               {"trace_s", r.reference->trace_s}};
    if (r.compared)
        object["compared"] = {{"rmse", r.compared->rmse},
                              {"psnr", std::isfinite(r.compared->psnr_db)
                                           ? nlohmann::ordered_json(r.compared->psnr_db)
                                           : nlohmann::ordered_json(nullptr)},
                              {"max", r.compared->max_error},
                              {"flip", r.compared->flip},
                              {"pixels", r.compared->pixels}};
    return object;
}

std::string result_line(const std::string& output, const render::Rendered& r, double took_s) {
    std::string line =
        fmt::format("{}  {}x{}", base::escaped(output, 4096), r.size.width, r.size.height);
    if (r.reference)
        line +=
            fmt::format("  {:.4g} samples  noise {:.2g}", r.reference->samples, r.reference->noise);
    if (r.compared)
        line += fmt::format("  rmse {:.4f}  flip {:.4f}", r.compared->rmse, r.compared->flip);
    return line + fmt::format("  {:.2f} s", took_s);
}

Result<render::Rendered> render_to_stdout(const render::Request& request, base::Log& log, Io& io,
                                          const base::Progress& progress) {
    const auto file = render::plan_file(request.settings, "standard output.png");
    if (!file) return tl::unexpected(file.error());
    auto rendered = render::render(request, log, progress);
    if (!rendered) return rendered;
    const auto png = render::encode_picture(*file, request, *rendered);
    if (!png) return tl::unexpected(png.error());
    io.print_bytes(*png);
    return rendered;
}

Result<Exit> run_render(const RenderOptions& options, Io& io) {
    const auto start = Clock::now();
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    if (auto checked = check(options, *settings, io); !checked)
        return tl::unexpected(checked.error());
    render::Request request{
        .scene = options.scene, .settings = *settings, .cache_folder = base::cache_folder()};
    gl::prepare_environment(settings->threads);
    io.warn(base::missing_cache_folder(), false);
    base::Log log = io.log();
    const bool to_stdout = options.output == "-";
    const auto rendered = [&] {
        ProgressLine progress(io);
        return to_stdout ? render_to_stdout(request, log, io, progress.sink())
                         : render::render_to_file(request, options.output, log, progress.sink());
    }();
    if (!rendered) return tl::unexpected(rendered.error());
    io.warn(rendered->warnings, false);
    if (options.show_reads)
        for (const fs::path& path : rendered->reads)
            io.note("reads " + base::escaped(path.string(), 4096));
    if (to_stdout) return Exit::done;
    const std::chrono::duration<double> took = Clock::now() - start;
    if (io.json)
        io.print_object(result_object(options.output, *rendered));
    else
        io.print(result_line(options.output, *rendered, took.count()));
    return Exit::done;
}

}  // namespace

void add_render(Declaration& command) {
    auto options = std::make_shared<RenderOptions>();
    auto& flags = command.flags;
    flags.push_back({"SCENE", &options->scene, "", "",
                     ".gltf, .glb, - (GLB on standard input) or builtin:NAME; --list scenes"});
    flags.push_back({"-o,--output", &options->output, "FILE", "Output",
                     ".png .exr .hdr .jpg .webp .tiff; - is PNG on standard output (SCENE.png)"});
    flags.push_back(
        {"--mkdirs", &options->rules.make_folders, "", "Output", "makes the folder of the output"});
    flags.push_back(
        {"--no-clobber", &options->rules.keep_existing, "", "Output", "refuses to replace a file"});
    flags.push_back(
        {"--show-reads", &options->show_reads, "", "Output", "tells every file that was opened"});
    options->typed.declare(flags);
    command.job = [options](Io& io) {
        if (options->output.empty()) options->output = scene::stem_of(options->scene) + ".png";
        return run_render(*options, io);
    };
}

}  // namespace facet::cli
