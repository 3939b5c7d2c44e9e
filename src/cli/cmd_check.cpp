// facet check: every problem of a scene file, with its JSON pointer.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "cli/capabilities.h"
#include "cli/flags.h"
#include "cli/scene_options.h"
#include "scene/load.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <memory>

namespace facet::cli {
namespace {

using base::Result;
using scene::Finding;

struct CheckOptions {
    std::vector<std::string> paths;
    bool capabilities = false;
    TypedSettings typed;
};

std::string_view name_of(Finding::Severity severity) {
    constexpr std::string_view names[] = {"error", "warning", "information", "hint"};
    return names[static_cast<std::size_t>(severity)];
}

void print_finding(const std::string& path, const Finding& finding, Io& io) {
    const std::string_view severity = name_of(finding.severity);
    if (io.json) {
        io.print_object(nlohmann::ordered_json{{"path", path},
                                               {"severity", severity},
                                               {"code", finding.code},
                                               {"pointer", finding.pointer},
                                               {"message", finding.message}});
        return;
    }
    io.print(fmt::format("{}:{}: {}: {} [{}]", base::escaped(path), base::escaped(finding.pointer),
                         severity, base::escaped(finding.message, 400),
                         base::escaped(finding.code)));
}

/// The worst of two: unreadable over errors over clean.
Exit worse(Exit a, Exit b) { return std::max(a, b); }

Exit check_one(const std::string& path, const scene::LoadOptions& load, const base::Limits& limits,
               bool strict, Io& io) {
    const auto findings = scene::check(path, load, limits);
    if (!findings) {
        io.complain(base::in_file(findings.error(), path));
        // After a successful read even a limit is a finding; before, the file's own story is
        // "unreadable".
        return Exit::input_invalid;
    }
    std::size_t errors = 0;
    std::size_t warnings = 0;
    for (const Finding& finding : *findings) {
        errors += finding.severity == Finding::Severity::error ? 1 : 0;
        warnings += finding.severity == Finding::Severity::warning ? 1 : 0;
        print_finding(path, finding, io);
    }
    if (!io.json && !io.quiet)
        io.print(fmt::format("{}: {} error{}, {} warning{}", base::escaped(path), errors,
                             errors == 1 ? "" : "s", warnings, warnings == 1 ? "" : "s"));
    return errors > 0 || (strict && warnings > 0) ? Exit::not_held : Exit::done;
}

Result<Exit> run_check(const CheckOptions& options, Io& io) {
    if (options.capabilities) return print_capabilities(io), Exit::done;
    if (options.paths.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .what = "no scene given",
                           .remedy = "facet check SCENE..., or --capabilities"});
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    Exit exit = Exit::done;
    for (const std::string& path : options.paths)
        exit = worse(exit, check_one(path, load_options(*settings), limits_of(*settings),
                                     settings->strict, io));
    return exit;
}

}  // namespace

void add_check(Declaration& command) {
    auto options = std::make_shared<CheckOptions>();
    command.flags.push_back({"SCENE", &options->paths, "", "", ".gltf or .glb, several"});
    command.flags.push_back({"--capabilities", &options->capabilities, "", "Check",
                             "prints what is supported, reads nothing"});
    options->typed.declare(command.flags, concerns_loading);
    command.job = [options](Io& io) { return run_check(*options, io); };
}

}  // namespace facet::cli
