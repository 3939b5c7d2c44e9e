// What follows a batch.
// SPDX-License-Identifier: MIT
#include "cli/batch_report.h"

#include "base/file.h"
#include "base/text.h"
#include "batch/collect.h"
#include "batch/data_set.h"
#include "batch/report.h"
#include "cli/progress.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <filesystem>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::Result;
using Json = nlohmann::ordered_json;

/// Compares with the baseline and writes the page; whether every picture is as it was.
Result<bool> report(const ReportOptions& options, const batch::Job& job,
                    const std::vector<std::size_t>& items, std::vector<Json> results, Io& io) {
    base::ThreadPool pool;
    batch::CardOptions wanted{.with_pictures = !options.report.empty()};
    if (!options.baseline.empty()) wanted.baseline = options.baseline;
    const auto cards = [&] {
        ProgressLine progress(io);
        wanted.progress = progress.sink();
        return batch::make_cards(job, items, std::move(results), wanted, pool);
    }();
    const double bound = options.max_flip.value_or(0.0);
    if (!options.report.empty())
        if (auto written = batch::write_report(job, cards,
                                               {.file = options.report,
                                                .max_flip = bound,
                                                .has_baseline = !options.baseline.empty()});
            !written)
            return tl::unexpected(written.error());
    bool holds = true;
    std::size_t new_count = 0;
    for (const batch::Card& card : cards) {
        const bool is_changed = card.flip && *card.flip > bound;
        holds = holds && !is_changed;
        if (is_changed && !io.json)
            io.print(fmt::format("changed  {}  FLIP {:.4f}",
                                 base::escaped(job.output_of(card.item).string(), 4096),
                                 *card.flip));
        if (wanted.baseline && card.earlier.empty() && !card.result.is_null())
            new_count += card.result.value("status", "") == "done" ? 1 : 0;
        if (io.json && card.flip)
            io.print_object(
                Json{{"item", card.item}, {"flip", *card.flip}, {"holds", !is_changed}});
    }
    if (new_count > 0)
        io.note(fmt::format("facet: {} of {} pictures are not in the baseline", new_count,
                            cards.size()));
    if (!options.report.empty() && !io.json) io.print(base::escaped(options.report, 4096));
    return holds;
}

}  // namespace

base::Status check_report(const ReportOptions& options) {
    std::error_code error;
    if (!options.baseline.empty() && !std::filesystem::is_directory(options.baseline, error))
        return base::fail(
            {.code = ErrorCode::usage,
             .file = "--baseline",
             .what = "no such folder",
             .found = options.baseline,
             .remedy = "the folder of the job as it was when its pictures were good"});
    if (options.max_flip && options.baseline.empty())
        return base::fail({.code = ErrorCode::usage,
                           .file = "--max-flip",
                           .what = "is for a comparison",
                           .remedy = "add --baseline DIR"});
    return options.report.empty() ? base::Status{} : base::check_writable(options.report);
}

Result<bool> conclude(const ReportOptions& options, const batch::Job& job,
                      const batch::Shard& shard, Io& io) {
    const bool is_whole = shard.count == 1 || options.merge;
    const bool has_tables = job.data_set && is_whole;
    if (options.report.empty() && options.baseline.empty() && !has_tables) return true;
    const auto items = batch::items_of(job, options.merge ? batch::Shard{} : shard);
    auto results = batch::collect(job, items, shard, false, {});
    if (!results) return tl::unexpected(results.error());
    if (has_tables) {
        base::ThreadPool pool;
        if (auto written = batch::write_data_set(job, *results, {}, pool); !written)
            return tl::unexpected(written.error());
    }
    if (options.report.empty() && options.baseline.empty()) return true;
    return report(options, job, items, std::move(*results), io);
}

}  // namespace facet::cli
