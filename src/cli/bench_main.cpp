// facet-bench: prints how long a frame takes, one JSON line a measurement.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "base/log.h"
#include "base/resources.h"
#include "base/text.h"
#include "gl/context.h"
#include "render/bench.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace {

using facet::base::Error;
using facet::base::ErrorCode;
using facet::base::Result;
using facet::base::Status;
using facet::render::BenchRequest;

constexpr std::size_t max_suite_bytes = 1 << 20;

struct Options {
    std::string scene = "builtin:showcase";
    std::string size = "1280x720";
    std::uint32_t lights = 0;
    std::string kinds = "point";
    std::string env = "studio";
    std::string quality = "standard";
    std::string shadows = "off";
    std::string backend = "auto";
    std::string camera = "auto";
    std::string reference;
    std::uint32_t frames = 30;
    std::uint32_t threads = 0;
    bool passes = false;
    bool suite = false;
};

tl::unexpected<Error> usage(const char* option, const std::string& found, const char* remedy) {
    return facet::base::fail({.code = ErrorCode::usage,
                              .file = option,
                              .what = "not understood",
                              .found = found,
                              .remedy = remedy});
}

Result<BenchRequest> request_of(const Options& options) {
    BenchRequest request{.scene = options.scene,
                         .lights = options.lights,
                         .kinds = {},
                         .frames = options.frames,
                         .passes = options.passes};
    const auto sides = facet::base::split(options.size, 'x');
    const auto width = facet::base::parse_integer(sides.front());
    const auto height = facet::base::parse_integer(sides.back());
    if (sides.size() != 2 || !width || !height || *width < 1 || *height < 1 || *width > 16384 ||
        *height > 16384)
        return usage("--size", options.size, "WxH");
    request.settings.size = {static_cast<std::uint32_t>(*width),
                             static_cast<std::uint32_t>(*height)};
    for (const std::string_view name : facet::base::split(options.kinds, ',')) {
        std::size_t kind = 0;
        while (kind < facet::tables::light_kinds.size() &&
               facet::tables::light_kinds[kind].key != name)
            ++kind;
        if (kind == facet::tables::light_kinds.size())
            return usage("--light-kinds", options.kinds, "point, spot");
        request.kinds.push_back(static_cast<facet::tables::LightKind>(kind));
    }
    request.settings.env = options.env;
    request.settings.quality = options.quality;
    request.settings.shadows = options.shadows;
    request.settings.backend = options.backend;
    request.settings.camera = options.camera;
    request.settings.reference = options.reference;
    request.settings.threads = options.threads;
    return request;
}

Status measure_reference(const Options& options, const BenchRequest& request) {
    const auto r = facet::render::bench_reference(request);
    if (!r) return tl::unexpected(r.error());
    const nlohmann::ordered_json line = {{"facet", 1},
                                         {"scene", options.scene},
                                         {"width", r->size.width},
                                         {"height", r->size.height},
                                         {"lights", options.lights},
                                         {"reference", r->samples},
                                         {"threads", r->threads},
                                         {"frames", options.frames},
                                         {"s", r->median_s},
                                         {"build_s", r->build_s},
                                         {"paths_per_s", r->paths_per_s},
                                         {"rays_per_path", r->rays_per_path},
                                         {"covered", r->covered},
                                         {"peak_rss_mb", r->peak_rss_mb}};
    std::puts(line.dump().c_str());
    return {};
}

Status measure(const Options& options, facet::base::Log& log) {
    const auto request = request_of(options);
    if (!request) return tl::unexpected(request.error());
    if (!options.reference.empty()) return measure_reference(options, *request);
    const auto r = facet::render::bench(*request, log);
    if (!r) return tl::unexpected(r.error());
    nlohmann::ordered_json line = {
        {"facet", 1},
        {"scene", options.scene},
        {"width", r->size.width},
        {"height", r->size.height},
        {"lights", options.lights},
        {"backend", r->backend},
        {"threads", r->threads},
        {"frames", options.frames},
        {"ms", {{"median", r->median_ms}, {"p5", r->p5_ms}, {"p95", r->p95_ms}}}};
    if (options.passes)
        line["passes"] = {
            {"gbuffer", r->gbuffer_ms}, {"lighting", r->lighting_ms}, {"post", r->post_ms}};
    if (options.lights > 0) line["lights_per_point"] = r->reach;
    line["first_frame_ms"] = r->first_frame_ms;
    line["peak_rss_mb"] = r->peak_rss_mb;
    std::puts(line.dump().c_str());
    return {};
}

Status measure_suite(Options options, facet::base::Log& log) {
    const auto folder = facet::base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    const auto file = *folder / "tests/bench/suite.json";
    const auto text = facet::base::read_file(file, max_suite_bytes);
    if (!text) return tl::unexpected(text.error());
    const auto suite = nlohmann::json::parse(
        reinterpret_cast<const char*>(text->data()),
        reinterpret_cast<const char*>(text->data()) + text->size(), nullptr, false);
    if (!suite.is_array())
        return facet::base::fail(
            {.code = ErrorCode::input_invalid, .file = file.string(), .what = "not a list"});
    const std::uint32_t frames = options.frames;
    for (const auto& entry : suite) {
        options.scene = entry.value("scene", "builtin:showcase");
        options.size = entry.value("size", "1280x720");
        options.lights = entry.value("lights", 0U);
        options.camera = entry.value("camera", "auto");
        options.reference = entry.value("reference", "");
        options.frames = entry.value("frames", frames);
        if (auto measured = measure(options, log); !measured) return measured;
    }
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "facet-bench: frame times as JSON lines.\nExample: facet-bench --lights 256 --frames 60");
    app.add_option("--scene", options.scene, "scene file or builtin:NAME")->capture_default_str();
    app.add_option("--size", options.size, "WxH")->capture_default_str();
    app.add_option("--lights", options.lights, "local lights")->check(CLI::Range(0, 4096));
    app.add_option("--light-kinds", options.kinds, "comma list of kinds of lights with a place")
        ->capture_default_str();
    app.add_option("--camera", options.camera, "as facet render's")->capture_default_str();
    app.add_option("--reference", options.reference,
                   "samples per pixel of the path tracer: paths a second");
    app.add_option("--env", options.env, "environment")->capture_default_str();
    app.add_option("--shadows", options.shadows,
                   "off: the frame alone; traced: with the rays of --quality")
        ->capture_default_str();
    app.add_option("--quality", options.quality, "draft, standard or final")->capture_default_str();
    app.add_option("--frames", options.frames, "frames measured")->check(CLI::Range(1, 100000));
    app.add_option("--backend", options.backend, "auto, egl or osmesa")->capture_default_str();
    app.add_option("--threads", options.threads, "threads (0: one per core)");
    app.add_flag("--passes", options.passes, "time each pass, each waited for");
    app.add_flag("--suite", options.suite, "the fixed set of tests/bench/suite.json");
    CLI11_PARSE(app, argc, argv);
    facet::gl::prepare_environment(options.threads);
    facet::base::Log log;
    const Status done = options.suite ? measure_suite(options, log) : measure(options, log);
    if (done) return 0;
    std::fprintf(stderr, "facet-bench: %s\n", facet::base::to_line(done.error()).c_str());
    return facet::base::exit_code(done.error().code);
}
