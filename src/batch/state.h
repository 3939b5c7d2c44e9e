// What is known of a job's items from run to run: the results files in JOB.facet/.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "batch/result.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace facet::batch {

/// The folder of a job's state, beside its file: job.json -> job.facet.
[[nodiscard]] std::filesystem::path state_folder(const Job& job);
/// `output` as results have it: relative to the job's folder where it lies in it.
[[nodiscard]] std::string recorded_path(const Job& job, const std::filesystem::path& path);
[[nodiscard]] std::filesystem::path path_of_record(const Job& job, const std::string& recorded);

/// Lines that each stand for an item, appended to one file and synced; a line that a crash tore is
/// cut off when the file is opened again.
class ResultsFile {
public:
    /// Opens `results-I-of-N.jsonl`, emptied for `restart`. Errors: input_invalid (not writable),
    /// temporary (disk full).
    [[nodiscard]] static base::Result<ResultsFile> open(const Job& job, const Shard& shard,
                                                        bool restart);
    ~ResultsFile();
    ResultsFile(ResultsFile&& other) noexcept;
    ResultsFile& operator=(ResultsFile&&) = delete;

    /// All lines in one write, then synced. Errors: temporary; nothing of them stays then.
    [[nodiscard]] base::Status append(std::span<const std::string> lines);

private:
    ResultsFile(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
    int file_ = -1;
    std::filesystem::path path_;
};

/// Calls `take` for every record of every results file of the job, a shard's own last; torn ends
/// are left out. Errors: input_invalid (another job's, a broken line, a newer version), naming the
/// file and line, with --restart as the remedy.
[[nodiscard]] base::Status read_results(const Job& job, const Shard& own,
                                        const base::Limits& limits,
                                        const std::function<void(Record)>& take);

/// The last record of each output, where it says that the item was done.
using DoneItems = std::unordered_map<std::string, Record>;
[[nodiscard]] base::Result<DoneItems> read_done(const Job& job, const Shard& own,
                                                const base::Limits& limits);

/// Whether a record still stands: made from the same input, and its files are as they were written.
[[nodiscard]] bool holds(const Job& job, const Record& record, const std::string& input);

}  // namespace facet::batch
