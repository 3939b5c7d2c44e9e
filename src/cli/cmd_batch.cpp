// facet batch: many pictures of a job file.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "batch/job_file.h"
#include "cli/flags.h"
#include "cli/setting_flags.h"
#include "tables/settings_text.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <memory>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::Result;
using Json = nlohmann::ordered_json;

struct BatchOptions {
    std::string job;
    std::string shard;
    bool dry_run = false;
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
                           .remedy = "facet batch JOB.json; facet help batch"});
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

Result<Exit> run_batch(const BatchOptions& options, Io& io) {
    const auto shard = shard_of(options.shard);
    if (!shard) return tl::unexpected(shard.error());
    const auto job = read(options, io);
    if (!job) return tl::unexpected(job.error());
    if (options.dry_run) return list_items(*job, *shard, io);
    return Exit::done;
}

}  // namespace

void add_batch(Declaration& command) {
    auto options = std::make_shared<BatchOptions>();
    auto& flags = command.flags;
    flags.push_back({"JOB", &options->job, "", "", "the job file; facet help batch"});
    flags.push_back({"--dry-run", &options->dry_run, "", "Work",
                     "lists the items as facet render commands, and renders nothing"});
    flags.push_back({"--shard", &options->shard, "I/N", "Work",
                     "only part I (from 0) of N; the parts can run anywhere"});
    options->typed.declare(flags, [](const tables::Setting& row) {
        return row.group == "Machine" && row.key != "base";
    });
    command.job = [options](Io& io) { return run_batch(*options, io); };
}

}  // namespace facet::cli
