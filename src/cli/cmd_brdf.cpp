// facet brdf: the BRDF itself, as numbers and plots, without a scene.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "cli/brdf_options.h"

#include <memory>

namespace facet::cli {
namespace {

using base::Result;

/// What follows `facet brdf`.
struct Action {
    std::string_view name;
    Result<Exit> (*run)(const BrdfOptions&, Io&);
};
constexpr Action actions[] = {{"eval", brdf_eval},
                              {"sample", brdf_sample},
                              {"albedo", brdf_albedo},
                              {"furnace", brdf_furnace},
                              {"plot", brdf_plot}};

Result<Exit> run_brdf(const BrdfOptions& options, Io& io) {
    std::vector<std::string> names;
    for (const Action& action : actions) {
        names.emplace_back(action.name);
        if (action.name != options.action) continue;
        if (options.via == "cpu" || options.via == "gl") return action.run(options, io);
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--via",
                           .what = "is one of cpu, gl",
                           .found = options.via});
    }
    return base::fail(
        {.code = base::ErrorCode::usage,
         .what = options.action.empty() ? "nothing to do given" : "facet brdf does no such thing",
         .found = options.action,
         .remedy = base::suggestion(options.action, names)});
}

}  // namespace

void add_brdf(Declaration& command) {
    auto options = std::make_shared<BrdfOptions>();
    auto& flags = command.flags;
    const auto number = [&](const char* name, std::optional<double>& target, tables::Range range,
                            const char* value, const char* help) {
        flags.push_back({name, BoundedNumber{&target, range}, value, "Surface", help});
    };
    flags.push_back({"ACTION", &options->action, "", "",
                     "eval, sample, albedo, furnace or plot; facet help brdf-terms"});
    flags.push_back({"--brdf", &options->brdf, "slot=term,…|lecture", "Model",
                     "terms, --list brdf; lecture-literal and distribution=blinn-phong too; plot "
                     "takes several"});
    flags.push_back({"--via", &options->via, "cpu|gl", "Model",
                     "which compilation of the one source answers (cpu)"});
    flags.push_back({"--roughness", &options->roughness, "LIST", "Surface",
                     "perceptual, not clamped; commas between"});
    flags.push_back({"--metallic", &options->metallic, "LIST", "Surface", "0 to 1"});
    flags.push_back({"--n-dot-v", &options->n_dot_v, "LIST", "Surface", "cosines of the view"});
    number("--f0", options->f0, {0.0, 1.0}, "X",
           "reflectance at normal incidence of the dielectric (0.04)");
    number("--base-color", options->base_color, {0.0, 1.0}, "X", "albedo and metal's F0 (1)");
    flags.push_back(
        {"--balance", &options->balance, "", "Tables",
         "albedo: reflected at the surface, transmitted into it and out again, absorbed"});
    flags.push_back({"--input", &options->input, "FILE|-", "Tables", "eval: questions as CSV"});
    flags.push_back({"--count", BoundedNumber{&options->count, {1.0, 1e7}}, "N", "Tables",
                     "sample: directions (16)"});
    flags.push_back({"--seed", BoundedNumber{&options->seed, {0.0, 4294967295.0}}, "N", "Tables",
                     "sample: (0)"});
    flags.push_back({"-o,--output", &options->output, "FILE", "Plot", "plot: .svg (lobe.svg)"});
    flags.push_back(
        {"--mkdirs", &options->rules.make_folders, "", "Plot", "makes the folder of the output"});
    flags.push_back(
        {"--no-clobber", &options->rules.keep_existing, "", "Plot", "refuses to replace a file"});
    command.job = [options](Io& io) { return run_brdf(*options, io); };
}

}  // namespace facet::cli
