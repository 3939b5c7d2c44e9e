// What is known of a job's items from run to run.
// SPDX-License-Identifier: MIT
#include "batch/state.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/text.h"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unordered_set>
#include <utility>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

std::string file_name(const Shard& shard) {
    return fmt::format("results-{}-of-{}.jsonl", shard.index, shard.count);
}

tl::unexpected<base::Error> cannot_write(const fs::path& path) {
    const bool later = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
    return base::fail({.code = later ? ErrorCode::temporary : ErrorCode::input_invalid,
                       .file = path.string(),
                       .what = std::string("cannot write: ") + std::strerror(errno),
                       .remedy = "free some space or move the job"});
}

std::string header_of(const Job& job, const Shard& shard) {
    return text_of({{"facet", 1},
                    {"job", job.file.filename().string()},
                    {"hash", job.text_hash},
                    {"shard", shard.index},
                    {"of", shard.count}});
}

tl::unexpected<base::Error> mismatch(const fs::path& file, std::size_t line, std::string what,
                                     std::string found) {
    return base::fail({.code = ErrorCode::input_invalid,
                       .file = file.string(),
                       .where = line > 0 ? fmt::format("line {}", line) : "",
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = "--restart begins anew"});
}

/// Results files of the state folder, the own one last.
std::vector<fs::path> results_files(const Job& job, const Shard& own) {
    std::vector<fs::path> files;
    std::error_code error;
    const fs::path folder = state_folder(job);
    for (auto entry = fs::directory_iterator(folder, error);
         !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with("results-") && name.ends_with(".jsonl") && name != file_name(own))
            files.push_back(entry->path());
    }
    std::ranges::sort(files);
    if (fs::exists(folder / file_name(own), error)) files.push_back(folder / file_name(own));
    return files;
}

/// Errors: as read_results(). Whether the header names this very job file.
base::Result<bool> check_header(const Job& job, const fs::path& file, std::string_view line,
                                const base::Limits& limits) {
    const auto header = base::parse_json<Json>(line, limits);
    const auto version = header ? header->find("facet") : Json::const_iterator();
    if (!header || version == header->end())
        return mismatch(file, 1, "no results of a job", std::string(line.substr(0, 60)));
    if (*version != 1) return mismatch(file, 1, "is of a newer version", version->dump());
    const auto hash = header->find("hash");
    return hash != header->end() && *hash == job.text_hash;
}

/// Whether some of the outputs are the job's: the file is an edited one, and not another.
bool is_of_job(const Job& job, const std::unordered_set<std::string>& outputs) {
    if (outputs.empty()) return true;
    for (std::size_t i = 0; i < job.item_count(); ++i)
        if (outputs.contains(recorded_path(job, job.output_of(i)))) return true;
    return false;
}

base::Status read_file_of_results(const Job& job, const fs::path& file, const base::Limits& limits,
                                  const std::function<void(Record)>& take) {
    const auto text = base::read_text_file(file, limits.file_bytes);
    if (!text) return tl::unexpected(text.error());
    std::string_view rest = *text;
    std::unordered_set<std::string> outputs;
    bool is_same = true;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) break;  // torn
        const std::string_view one = rest.substr(0, end);
        rest.remove_prefix(end + 1);
        if (line == 1) {
            const auto same = check_header(job, file, one, limits);
            if (!same) return tl::unexpected(same.error());
            is_same = *same;
            continue;
        }
        auto record = parse_record(one, limits);
        if (!record) return mismatch(file, line, record.error().what, record.error().found);
        if (!is_same) outputs.insert(record->output);
        take(std::move(*record));
    }
    if (!is_same && !is_of_job(job, outputs))
        return mismatch(file, 0, "results do not match this job",
                        fmt::format("hash {}", job.text_hash.substr(0, 12)));
    return {};
}

}  // namespace

fs::path state_folder(const Job& job) {
    fs::path folder = job.file;
    return folder.replace_extension(".facet");
}

std::string recorded_path(const Job& job, const fs::path& path) {
    const fs::path folder = job.folder.empty() ? fs::path(".") : job.folder.lexically_normal();
    const fs::path relative = path.lexically_normal().lexically_relative(folder);
    return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

fs::path path_of_record(const Job& job, const std::string& recorded) {
    return (job.folder / recorded).lexically_normal();
}

ResultsFile::ResultsFile(ResultsFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}

ResultsFile::~ResultsFile() {
    if (file_ >= 0) ::close(file_);
}

base::Result<ResultsFile> ResultsFile::open(const Job& job, const Shard& shard, bool restart) {
    const fs::path path = state_folder(job) / file_name(shard);
    const int file = ::open(
        path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | (restart ? O_TRUNC : 0), 0666);
    if (file < 0) return cannot_write(path);
    ResultsFile results(file, path);
    struct stat status {};
    if (::fstat(file, &status) != 0) return cannot_write(path);
    // What stands behind the last end of a line was torn by a crash.
    off_t end = status.st_size;
    for (char last = 0; end > 0; --end)
        if (::pread(file, &last, 1, end - 1) != 1 || last == '\n') break;
    if (::ftruncate(file, end) != 0 || ::lseek(file, end, SEEK_SET) < 0) return cannot_write(path);
    if (end == 0) {
        const std::string header = header_of(job, shard);
        if (auto written = results.append(std::span(&header, 1)); !written)
            return tl::unexpected(written.error());
    }
    return results;
}

base::Status ResultsFile::append(std::span<const std::string> lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    const off_t before = ::lseek(file_, 0, SEEK_CUR);
    std::size_t put = 0;
    while (put < text.size()) {
        const ssize_t count = ::write(file_, text.data() + put, text.size() - put);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            auto error = cannot_write(path_);
            static_cast<void>(::ftruncate(file_, before) == 0 && ::lseek(file_, before, SEEK_SET));
            return error;
        }
        put += static_cast<std::size_t>(count);
    }
    if (::fdatasync(file_) != 0 && errno != EINVAL) return cannot_write(path_);
    return {};
}

base::Status read_results(const Job& job, const Shard& own, const base::Limits& limits,
                          const std::function<void(Record)>& take) {
    for (const fs::path& file : results_files(job, own))
        if (auto read = read_file_of_results(job, file, limits, take); !read) return read;
    return {};
}

base::Result<DoneItems> read_done(const Job& job, const Shard& own, const base::Limits& limits) {
    DoneItems done;
    auto read = read_results(job, own, limits, [&](Record record) {
        record.json = nullptr;
        std::string output = record.output;
        if (record.is_done)
            done.insert_or_assign(std::move(output), std::move(record));
        else
            done.erase(output);
    });
    if (!read) return tl::unexpected(read.error());
    return done;
}

bool holds(const Job& job, const Record& record, const std::string& input) {
    if (record.input != input) return false;
    for (const std::string& side : record.sides) {
        std::error_code error;
        if (!fs::is_regular_file(path_of_record(job, side), error)) return false;
    }
    const auto bytes =
        base::read_file(path_of_record(job, record.output), base::Limits{}.file_bytes);
    return bytes && base::sha256_hex(*bytes) == record.sha256;
}

}  // namespace facet::batch
