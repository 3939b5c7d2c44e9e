// facet diff: two pictures compared by number and as a heat map.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "cli/flags.h"
#include "cli/output_gate.h"
#include "image/compare.h"
#include "image/read.h"
#include "image/write.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <memory>
#include <optional>

namespace facet::cli {
namespace {

using base::Result;

struct DiffOptions {
    std::string a;
    std::string b;
    std::string layer;
    std::string output;
    OutputRules rules;
    bool mask = false;
    std::optional<double> max_rmse;
    std::optional<double> max_error;
    std::optional<double> max_flip;
    std::optional<double> max_rel_mse;
    std::string heat = "flip";
    std::optional<double> min_psnr;
};

Result<image::Picture> read(const std::string& path) {
    const base::Limits limits;
    const auto bytes = base::read_file(path, limits.file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto picture = image::decode_picture(*bytes, limits);
    if (!picture) return tl::unexpected(base::in_file(picture.error(), path));
    return picture;
}

/// One number of the comparison, and whether it keeps within the bound asked for.
struct Metric {
    const char* name;
    std::optional<double> value;
    std::optional<double> bound;
    bool at_most = true;

    [[nodiscard]] bool holds() const {
        if (!bound || !value) return true;
        return at_most ? *value <= *bound : *value >= *bound;  // false for NaN
    }
};

std::vector<Metric> metrics(const image::Difference& d, const DiffOptions& o) {
    return {
        {"rmse", d.rmse, o.max_rmse},
        {"psnr", d.psnr_db, o.min_psnr, false},
        {"max", d.max_error, o.max_error},
        {"rel_mse", o.layer.empty() ? std::optional(d.relative_mse) : std::nullopt, o.max_rel_mse},
        {"flip", d.flip, o.max_flip}};
}

void print(const DiffOptions& options, const image::Difference& difference, bool held, Io& io) {
    nlohmann::ordered_json object{{"facet", 1}, {"a", options.a}, {"b", options.b}};
    for (const Metric& metric : metrics(difference, options)) {
        // JSON has no infinity: the PSNR of equal pictures is null.
        object[metric.name] = metric.value && std::isfinite(*metric.value)
                                  ? nlohmann::ordered_json(*metric.value)
                                  : nullptr;
        if (!io.json && metric.value)
            io.print(fmt::format("{:<7} {:.6f}{}", metric.name, *metric.value,
                                 metric.holds() ? "" : fmt::format("  beyond {}", *metric.bound)));
    }
    if (difference.flip) object["flip_kind"] = difference.flip_is_hdr ? "hdr" : "ldr";
    object["pixels"] = difference.pixel_count;
    object["holds"] = held;
    if (io.json) io.print_object(object);
}

base::Status write_heat(const DiffOptions& options, const image::Image& heat) {
    const auto bytes = image::encode(heat, {.format = *format_of(options.output), .metadata = {}});
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), options.output));
    return base::write_file_atomically(options.output, *bytes);
}

/// Everything wrong with the request that can be known before a picture is read.
base::Status check(const DiffOptions& options) {
    if (options.b.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .what = "two pictures are compared",
                           .remedy = "facet diff A B"});
    if (options.max_flip && (options.mask || !options.layer.empty()))
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--max-flip",
                           .what = "excludes --mask and --layer",
                           .remedy = "FLIP looks at whole pictures"});
    if (options.heat != "flip" && options.heat != "error")
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--heat",
                           .what = "is one of flip, error",
                           .found = options.heat});
    if (options.output.empty()) return {};
    if (auto writable =
            check_output(options.output, options.rules, std::vector{options.a, options.b});
        !writable)
        return writable;
    if (tables::row(*format_of(options.output)).scene_linear)
        return base::fail({.code = base::ErrorCode::usage,
                           .file = options.output,
                           .what = "a heat map is no radiance",
                           .remedy = "give it the ending .png"});
    return {};
}

Result<Exit> run_diff(const DiffOptions& options, Io& io) {
    if (auto checked = check(options); !checked) return tl::unexpected(checked.error());
    const auto a = read(options.a);
    if (!a) return tl::unexpected(a.error());
    const auto b = read(options.b);
    if (!b) return tl::unexpected(b.error());
    const auto pixels = options.mask ? image::Pixels::covered : image::Pixels::all;
    const auto difference =
        image::compare(*a, *b,
                       {.pixels = pixels,
                        .layer = options.layer,
                        .heat = options.heat == "flip" ? image::Heat::flip : image::Heat::error});
    if (!difference) return tl::unexpected(base::in_file(difference.error(), options.b));
    if (!options.output.empty())
        if (auto written = write_heat(options, difference->heat); !written)
            return tl::unexpected(written.error());
    bool held = true;
    for (const Metric& metric : metrics(*difference, options)) held = held && metric.holds();
    print(options, *difference, held, io);
    return held ? Exit::done : Exit::not_held;
}

}  // namespace

void add_diff(Declaration& command) {
    auto options = std::make_shared<DiffOptions>();
    auto& flags = command.flags;
    const auto bound = [&](const char* name, std::optional<double>& target, double high,
                           const char* help) {
        flags.push_back(
            {name, BoundedNumber{&target, {0.0, high}}, "X", "Bounds (exit 1 beyond)", help});
    };
    flags.push_back(
        {"A", &options->a, "", "", "a picture: the reference, where that matters (FLIP, rel_mse)"});
    flags.push_back({"B", &options->b, "", "", "another of the same size"});
    flags.push_back({"-o,--output", &options->output, "FILE", "Diff",
                     "a heat map: dark where equal, light where not"});
    flags.push_back(
        {"--heat", &options->heat, "flip|error", "Diff",
         "what it shows: FLIP (with --mask or --layer: error), or the largest channel's error"});
    flags.push_back(
        {"--mkdirs", &options->rules.make_folders, "", "Diff", "makes the folder of the output"});
    flags.push_back(
        {"--no-clobber", &options->rules.keep_existing, "", "Diff", "refuses to replace a file"});
    flags.push_back(
        {"--mask", &options->mask, "", "Diff", "only pixels that both pictures cover (alpha)"});
    flags.push_back(
        {"--layer", &options->layer, "NAME", "Diff", "a layer of two EXRs, by its values"});
    bound("--max-rmse", options->max_rmse, 1e9,
          "largest root of the mean square, display values 0..1");
    bound("--max-error", options->max_error, 1e9, "largest error of any pixel");
    bound("--max-flip", options->max_flip, 1.0,
          "largest mean FLIP at 67 pixels per degree; of two .exr or .hdr it is HDR-FLIP");
    bound("--max-rel-mse", options->max_rel_mse, 1e9,
          "largest mean of (a - b)^2 / (a^2 + 0.01), linear light");
    bound("--min-psnr", options->min_psnr, 1e9, "smallest PSNR in dB");
    command.job = [options](Io& io) { return run_diff(*options, io); };
}

}  // namespace facet::cli
