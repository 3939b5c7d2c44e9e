// facet teach: lessons as pages.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "gl/context.h"
#include "teach/course.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <memory>

namespace facet::cli {
namespace {

using base::Result;

struct TeachOptions {
    std::vector<std::string> lessons;
    std::string output = "lessons";
    std::string language = "en";
    std::string skeleton;
    std::optional<double> threads;
    bool force = false;
};

Result<Exit> run_new(const TeachOptions& options, Io& io) {
    if (!options.lessons.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--new",
                           .what = "makes one lesson and teaches none",
                           .found = base::join(options.lessons, " ")});
    if (auto made = teach::make_skeleton(options.skeleton); !made)
        return tl::unexpected(made.error());
    if (io.json) {
        io.print_object(nlohmann::ordered_json{{"facet", 1}, {"lesson", options.skeleton}});
        return Exit::done;
    }
    const std::string name = base::escaped(options.skeleton, 4096);
    io.print(fmt::format("{0}  lesson.json, en.md, ru.md; facet teach ./{0} -o pages", name));
    return Exit::done;
}

Result<Exit> run_teach(const TeachOptions& options, Io& io) {
    if (!options.skeleton.empty()) return run_new(options, io);
    const auto start = std::chrono::steady_clock::now();
    gl::prepare_environment(static_cast<std::uint32_t>(options.threads.value_or(0.0)));
    base::Log log = io.log();
    const auto course = [&] {
        ProgressLine progress(io);
        return teach::make_course({.lessons = options.lessons,
                                   .output = options.output,
                                   .language = options.language,
                                   .force = options.force},
                                  log, progress.sink());
    }();
    if (!course) return tl::unexpected(course.error());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (io.json)
        io.print_object(nlohmann::ordered_json{{"facet", 1},
                                               {"output", course->index.string()},
                                               {"lessons", course->lesson_count},
                                               {"bytes", course->bytes}});
    else
        io.print(fmt::format("{}  {} lessons  {:.1f} MB  {:.1f} s",
                             base::escaped(course->index.string(), 4096), course->lesson_count,
                             static_cast<double>(course->bytes) * 1e-6, took.count()));
    return Exit::done;
}

}  // namespace

void add_teach(Declaration& command) {
    auto options = std::make_shared<TeachOptions>();
    auto& flags = command.flags;
    flags.push_back(
        {"LESSON", &options->lessons, "", "",
         "names (--list lessons) or folders of lessons of your own; none: all of Facet's"});
    flags.push_back(
        {"-o,--output", &options->output, "DIR", "Output", "folder of the pages (lessons)"});
    flags.push_back({"--force", &options->force, "", "Output",
                     "replaces pages in a folder that is not empty; other files stay"});
    flags.push_back({"--lang", &options->language, "en|ru", "Output", "language (en)"});
    flags.push_back({"--new", &options->skeleton, "DIR", "Authors",
                     "makes a lesson to begin from; facet help lessons"});
    flags.push_back({"--threads", BoundedNumber{&options->threads, {0, 1024}}, "N", "Machine",
                     "threads (0: one per core)"});
    command.job = [options](Io& io) { return run_teach(*options, io); };
}

}  // namespace facet::cli
