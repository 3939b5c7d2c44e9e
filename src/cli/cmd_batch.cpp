// facet batch: many pictures of a job file.
// SPDX-License-Identifier: MIT
#include "base/build_id.h"
#include "base/text.h"
#include "batch/collect.h"
#include "batch/job_file.h"
#include "batch/run.h"
#include "batch/schema.h"
#include "cli/batch_report.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "cli/setting_flags.h"
#include "tables/settings_text.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <csignal>
#include <memory>
#include <optional>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::Result;
using Json = nlohmann::ordered_json;

struct BatchOptions {
    std::string job;
    std::string shard;
    bool dry_run = false;
    bool restart = false;
    bool resume = false;
    bool fail_fast = false;
    bool keep_going = false;
    std::optional<double> jobs;
    std::optional<double> retries;
    std::optional<double> item_timeout_s;
    std::optional<double> wait_s;
    ReportOptions report;
    bool schema = false;
    TypedSettings typed;
};

Result<batch::Shard> shard_of(const std::string& text) {
    if (text.empty()) return batch::Shard{};
    const auto parts = base::split(text, '/');
    const long long index = base::parse_integer(parts.front()).value_or(-1);
    const long long count = parts.size() == 2 ? base::parse_integer(parts[1]).value_or(-1) : -1;
    if (count < 1 || count > 1'000'000 || index < 0 || index >= count)
        return base::fail({.code = ErrorCode::usage,
                           .file = "--shard",
                           .what = "not I/N with I from 0 to N-1",
                           .found = text,
                           .remedy = "0/4 is the first of four"});
    return batch::Shard{static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
}

/// The job, or all that is wrong with it, told.
Result<batch::Job> read(const BatchOptions& options, Io& io) {
    if (options.job.empty())
        return base::fail({.code = ErrorCode::usage,
                           .what = "no job given",
                           .remedy = "facet batch JOB.json; facet help jobs"});
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    batch::JobOptions reading{.settings = *settings};
    if (settings->max_memory > 0)
        reading.limits.memory_bytes = std::size_t{settings->max_memory} << 20U;
    batch::JobProblems problems;
    auto job = batch::read_job(options.job, reading, problems);
    io.warn(problems.warnings);
    if (job) return std::move(*job);
    // The last one is told by the caller.
    constexpr std::size_t most_told = 20;
    for (std::size_t i = 0; i + 1 < problems.errors.size() && i < most_told; ++i)
        io.complain(problems.errors[i]);
    if (problems.errors.size() > most_told + 1)
        io.note(fmt::format("... and {} more", problems.errors.size() - most_told - 1));
    return tl::unexpected(problems.errors.back());
}

Json settings_object(const tables::Settings& settings) {
    Json object = Json::object();
    for (const tables::Setting& row : tables::settings) {
        const auto texts = tables::texts_of(settings, row);
        if (texts.empty()) continue;
        if (std::holds_alternative<tables::List tables::Settings::*>(row.field))
            object[std::string(row.key)] = texts;
        else
            object[std::string(row.key)] = texts.front();
    }
    return object;
}

Result<Exit> list_items(const batch::Job& job, const batch::Shard& shard, Io& io) {
    for (const std::size_t index : batch::items_of(job, shard)) {
        const auto item = job.item(index);
        if (!item) return tl::unexpected(item.error());
        const std::string output = item->output.string();
        if (io.json)
            io.print_object(Json{{"facet", 1},
                                 {"item", index},
                                 {"scene", item->scene},
                                 {"output", output},
                                 {"settings", settings_object(item->settings)}});
        else
            io.print(fmt::format("{}  {}", index,
                                 tables::command_line(tables::command_words(
                                     "render", item->scene, item->settings, output))));
    }
    return Exit::done;
}

base::Status check_pairs(const BatchOptions& options) {
    const auto excludes = [](const char* one, const char* other) {
        return base::fail({.code = ErrorCode::usage,
                           .file = one,
                           .what = std::string("excludes ") + other,
                           .remedy = "leave one of them out"});
    };
    if (options.restart && options.resume) return excludes("--restart", "--resume");
    if (options.fail_fast && options.keep_going) return excludes("--fail-fast", "--keep-going");
    if (options.report.merge && !options.shard.empty()) return excludes("--merge", "--shard");
    if (options.report.merge && options.restart) return excludes("--merge", "--restart");
    return {};
}

batch::RunOptions run_options(const BatchOptions& options, const batch::Shard& shard,
                              std::uint32_t threads, const Io& io) {
    return {.shard = shard,
            .jobs = static_cast<std::size_t>(options.jobs.value_or(0.0)),
            .threads = threads,
            .restart = options.restart,
            .fail_fast = options.fail_fast,
            .retries = static_cast<unsigned>(options.retries.value_or(1.0)),
            .item_timeout_s = options.item_timeout_s.value_or(0.0),
            .patience = std::chrono::milliseconds(
                static_cast<long long>(options.wait_s.value_or(0.0) * 1000.0)),
            .program = FACET_VERSION " " + base::build_id(),
            .level = io.quiet ? base::LogLevel::off : io.level};
}

/// A failed item's line for people.
void tell_failure(const Json& item, Io& io) {
    const Json& error = item["error"];
    std::string where = error.value("path", "");
    if (const std::string pointer = error.value("pointer", ""); !pointer.empty())
        where += (where.empty() ? "" : ":") + pointer;
    io.note(fmt::format("facet: item {} ({}): {}{}", item["item"].get<std::size_t>(),
                        base::escaped(item.value("output", "")),
                        where.empty() ? "" : base::escaped(where) + ": ",
                        base::escaped(error.value("message", ""), 600)));
}

std::string summary(const batch::Outcome& outcome) {
    const std::size_t ended = outcome.done + outcome.failed;
    std::string line = fmt::format("{} of {} done", outcome.done + outcome.skipped, outcome.total);
    if (outcome.failed > 0) line += fmt::format(", {} failed", outcome.failed);
    if (outcome.skipped > 0) line += fmt::format(", {} were there already", outcome.skipped);
    line += fmt::format("  {:.1f} s", outcome.seconds);
    if (ended > 0)
        line += fmt::format("  {:.0f} a minute on {} workers",
                            static_cast<double>(ended) * 60.0 / outcome.seconds, outcome.workers);
    return line;
}

Exit exit_of(const batch::Outcome& outcome) {
    if (outcome.signal == SIGINT) return Exit::interrupted;
    if (outcome.signal != 0) return Exit::terminated;
    return outcome.failed > 0 ? Exit::not_held : Exit::done;
}

Result<Exit> merge_shards(const BatchOptions& options, const batch::Job& job, Io& io) {
    const auto merged = batch::merge(job, {});
    if (!merged) return tl::unexpected(merged.error());
    for (const Json& failed : merged->failed) tell_failure(failed, io);
    constexpr std::size_t most_told = 20;
    for (std::size_t i = 0; i < merged->missing.size() && i < most_told; ++i)
        io.note(fmt::format("facet: item {} is missing ({})", merged->missing[i],
                            base::escaped(job.output_of(merged->missing[i]).string(), 4096)));
    if (merged->missing.size() > most_told)
        io.note(fmt::format("... and {} more", merged->missing.size() - most_told));
    const auto holds = conclude(options.report, job, {}, io);
    if (!holds) return tl::unexpected(holds.error());
    if (io.json)
        io.print_object(Json{{"facet", 1},
                             {"output", merged->file.string()},
                             {"items", merged->total},
                             {"done", merged->done},
                             {"failed", merged->failed.size()},
                             {"missing", merged->missing}});
    else
        io.print(fmt::format("{}  {} of {} done, {} failed, {} missing",
                             base::escaped(merged->file.string(), 4096), merged->done,
                             merged->total, merged->failed.size(), merged->missing.size()));
    return *holds && merged->done == merged->total ? Exit::done : Exit::not_held;
}

Result<Exit> render_items(const BatchOptions& options, const batch::Job& job,
                          const batch::Shard& shard, Io& io) {
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    const auto outcome = [&] {
        ProgressLine progress(io);
        batch::RunOptions run = run_options(options, shard, settings->threads, io);
        run.progress = progress.sink();
        run.on_item = [&](const Json& item) {
            progress.clear();
            if (item["status"] == "failed") tell_failure(item, io);
            if (io.json) io.print_object(item);
        };
        return batch::run(job, run);
    }();
    if (!outcome) return tl::unexpected(outcome.error());
    io.warn(outcome->warnings);
    if (outcome->signal != 0)
        io.note(fmt::format("facet: interrupted after {} of {}; run again to resume",
                            outcome->done + outcome->skipped, outcome->total));
    if (io.json)
        io.print_object(Json{{"facet", 1},
                             {"items", outcome->total},
                             {"done", outcome->done},
                             {"skipped", outcome->skipped},
                             {"failed", outcome->failed},
                             {"workers", outcome->workers},
                             {"seconds", outcome->seconds}});
    else if (outcome->signal == 0)
        io.print(summary(*outcome));
    if (outcome->signal != 0) return exit_of(*outcome);
    const auto holds = conclude(options.report, job, shard, io);
    if (!holds) return tl::unexpected(holds.error());
    return *holds ? exit_of(*outcome) : Exit::not_held;
}

Result<Exit> run_batch(const BatchOptions& options, Io& io) {
    if (options.schema) {
        io.print(batch::job_schema().dump(1));
        return Exit::done;
    }
    if (auto pairs = check_pairs(options); !pairs) return tl::unexpected(pairs.error());
    const auto shard = shard_of(options.shard);
    if (!shard) return tl::unexpected(shard.error());
    const auto job = read(options, io);
    if (!job) return tl::unexpected(job.error());
    if (options.dry_run) return list_items(*job, *shard, io);
    if (auto checked = check_report(options.report); !checked)
        return tl::unexpected(checked.error());
    if (options.report.merge) return merge_shards(options, *job, io);
    return render_items(options, *job, *shard, io);
}

}  // namespace

void add_batch(Declaration& command) {
    auto options = std::make_shared<BatchOptions>();
    auto& flags = command.flags;
    flags.push_back({"JOB", &options->job, "", "", "the job file; facet help jobs"});
    flags.push_back({"--dry-run", &options->dry_run, "", "Work",
                     "lists the items as facet render commands, and renders nothing"});
    flags.push_back({"--schema", &options->schema, "", "Work",
                     "prints the JSON Schema of job files, for editors"});
    flags.push_back({"--shard", &options->shard, "I/N", "Work",
                     "only part I (from 0) of N; the parts can run anywhere"});
    flags.push_back({"--merge", &options->report.merge, "", "Work",
                     "renders nothing; joins the results of all parts, and says what is missing"});
    flags.push_back({"--jobs", BoundedNumber{&options->jobs, {1, 1e6}}, "N", "Work",
                     "worker processes (one per core)"});
    flags.push_back({"--resume", &options->resume, "", "Work",
                     "skips items that are done and still hold (so by default)"});
    flags.push_back({"--restart", &options->restart, "", "Work",
                     "forgets what was done, and renders every item"});
    flags.push_back({"--wait", BoundedNumber{&options->wait_s, {0, 1e7}}, "S", "Work",
                     "seconds to wait for another run of the job to end (0)"});
    flags.push_back({"--keep-going", &options->keep_going, "", "Faults",
                     "a failed item stops no other (so by default)"});
    flags.push_back(
        {"--fail-fast", &options->fail_fast, "", "Faults", "ends after the first failure"});
    flags.push_back({"--retries", BoundedNumber{&options->retries, {0, 100}}, "N", "Faults",
                     "of an item whose worker died or that may do better later (1)"});
    flags.push_back({"--item-timeout", BoundedNumber{&options->item_timeout_s, {0.001, 1e7}}, "S",
                     "Faults", "seconds that an item may take"});
    flags.push_back({"--report", &options->report.report, "FILE", "Report",
                     "a contact sheet: one HTML page with every picture, time and error"});
    flags.push_back({"--baseline", &options->report.baseline, "DIR", "Report",
                     "compares with earlier pictures, at the same paths in DIR (FLIP)"});
    flags.push_back({"--max-flip", BoundedNumber{&options->report.max_flip, {0, 1}}, "X", "Report",
                     "exit 1 where a picture differs by more (0)"});
    options->typed.declare(flags, [](const tables::Setting& row) {
        return row.group == "Machine" && row.key != "base";
    });
    command.job = [options](Io& io) { return run_batch(*options, io); };
}

}  // namespace facet::cli
