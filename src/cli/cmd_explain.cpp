// facet explain: the rendering equation at one pixel, number by number.
// SPDX-License-Identifier: MIT
#include "base/cache_folder.h"
#include "base/text.h"
#include "base/texts.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "cli/setting_flags.h"
#include "explain/told.h"
#include "gl/context.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace facet::cli {
namespace {

using base::Result;

constexpr std::size_t most_pixels = 4096;

struct ExplainOptions {
    std::string scene;
    std::vector<std::string> pixels;
    std::string language = "en";
    bool tree = false;
    bool show_reads = false;
    TypedSettings typed;
};

tl::unexpected<base::Error> refuse(std::string what, const std::string& found) {
    return base::fail({.code = base::ErrorCode::usage,
                       .file = "--pixel",
                       .what = std::move(what),
                       .found = found,
                       .remedy = "for example --pixel 640,360; 0,0 is top left"});
}

Result<std::vector<explain::PixelRequest>> pixels_of(const std::vector<std::string>& texts) {
    if (texts.empty()) return refuse("which pixel?", "");
    if (texts.size() > most_pixels)
        return refuse("4096 pixels at most", std::to_string(texts.size()));
    std::vector<explain::PixelRequest> out;
    for (const std::string& text : texts) {
        const auto parts = base::split(text, ',');
        const auto x =
            parts.size() == 2 ? base::parse_integer(base::trimmed(parts[0])) : std::nullopt;
        const auto y =
            parts.size() == 2 ? base::parse_integer(base::trimmed(parts[1])) : std::nullopt;
        if (!x || !y) return refuse("is not X,Y", text);
        constexpr long long most = 1'000'000'000;
        if (*x < 0 || *y < 0 || *x > most || *y > most)
            return refuse("is outside every picture", text);
        out.push_back({static_cast<std::uint32_t>(*x), static_cast<std::uint32_t>(*y)});
    }
    return out;
}

Result<Exit> run_explain(const ExplainOptions& options, Io& io) {
    if (options.scene.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .what = "no scene given",
                           .remedy = "facet explain SCENE --pixel X,Y"});
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    const auto pixels = pixels_of(options.pixels);
    if (!pixels) return tl::unexpected(pixels.error());
    const auto texts = base::Texts::load(options.language);
    if (!texts) return tl::unexpected(texts.error());
    gl::prepare_environment(settings->threads);
    base::Log log = io.log();
    const auto explained = [&] {
        ProgressLine progress(io);
        return explain::explain(
            {.scene = options.scene, .settings = *settings, .cache_folder = base::cache_folder()},
            *pixels, log, progress.sink());
    }();
    if (!explained) return tl::unexpected(explained.error());
    io.warn(explained->warnings, settings->strict);
    if (options.show_reads)
        for (const auto& path : explained->reads)
            io.note("reads " + base::escaped(path.string(), 4096));
    for (const explain::Pixel& pixel : explained->pixels) {
        if (io.json) {
            io.print_object(explain::json_of(*explained, pixel));
            continue;
        }
        std::string tree = explain::tree_of(*explained, pixel, *texts);
        tree.pop_back();
        io.print(tree);
    }
    return Exit::done;
}

}  // namespace

void add_explain(Declaration& command) {
    auto options = std::make_shared<ExplainOptions>();
    auto& flags = command.flags;
    flags.push_back(
        {"SCENE", &options->scene, "", "", ".gltf, .glb, - or builtin:NAME; --list scenes"});
    flags.push_back({"--pixel", &options->pixels, "X,Y", "Explain",
                     "which pixel, 0,0 is top left; again for more"});
    flags.push_back({"--tree", &options->tree, "", "Explain",
                     "as a tree of lines (the default); --json for programs"});
    flags.push_back({"--lang", &options->language, "en|ru", "Explain", "language (en)"});
    flags.push_back(
        {"--show-reads", &options->show_reads, "", "Explain", "tells every file that was opened"});
    options->typed.declare(flags);
    command.job = [options](Io& io) { return run_explain(*options, io); };
}

}  // namespace facet::cli
