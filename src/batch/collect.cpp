// What is known of every item of a job.
// SPDX-License-Identifier: MIT
#include "batch/collect.h"

#include "base/file.h"
#include "batch/input_hash.h"

#include <numeric>
#include <unordered_map>

namespace facet::batch {

base::Result<std::vector<Json>> collect(const Job& job, const std::vector<std::size_t>& items,
                                        const Shard& shard, bool check_outputs,
                                        const base::Limits& limits) {
    std::vector<Json> out(items.size());
    std::unordered_map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < items.size(); ++i)
        places.emplace(recorded_path(job, job.output_of(items[i])), i);
    std::vector<Record> records(items.size());
    auto read = read_results(job, shard, limits, [&](Record record) {
        const auto place = places.find(record.output);
        if (place == places.end()) return;
        record.json["item"] = items[place->second];  // the job may have been edited since
        records[place->second] = std::move(record);
    });
    if (!read) return tl::unexpected(read.error());
    InputHashes hashes(limits);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto stands = [&] {
            if (!records[i].is_done || !check_outputs) return true;
            const auto item = job.item(items[i]);
            return item && holds(job, records[i], hashes.of(job, *item));
        };
        if (stands()) out[i] = std::move(records[i].json);
    }
    return out;
}

base::Result<Merged> merge(const Job& job, const base::Limits& limits) {
    std::vector<std::size_t> items(job.item_count());
    std::iota(items.begin(), items.end(), 0);
    auto records = collect(job, items, {}, true, limits);
    if (!records) return tl::unexpected(records.error());
    Merged merged{.total = items.size(), .file = state_folder(job) / "results.jsonl"};
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        Json& record = (*records)[i];
        if (record.is_null()) {
            merged.missing.push_back(i);
            continue;
        }
        text += text_of(record) + '\n';
        if (record.value("status", "") == "done")
            ++merged.done;
        else
            merged.failed.push_back(std::move(record));
    }
    if (auto written = base::write_file_atomically(merged.file, std::as_bytes(std::span(text)));
        !written)
        return tl::unexpected(written.error());
    return merged;
}

}  // namespace facet::batch
