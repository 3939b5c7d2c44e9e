// Reading a job file: its members, and what is wrong with them.
// SPDX-License-Identifier: MIT
#include "batch/job_file.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/text.h"
#include "batch/group.h"
#include "batch/outputs.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

constexpr std::size_t most_items = 100'000'000;

const std::vector<std::string> top_keys = {"facet", "output", "defaults", "items", "data_set"};

class Reader {
public:
    Reader(Job& job, const JobOptions& options, JobProblems& problems)
        : job_(job), options_(options), problems_(problems) {}

    void read(const Json& root) {
        if (!root.is_object()) return refuse("", "a job is an object", root);
        for (const auto& [key, value] : root.items())
            if (key != "$schema" && std::ranges::find(top_keys, key) == top_keys.end())
                refuse("/" + base::pointer_key(key), "unknown key", key,
                       base::suggestion(key, top_keys));
        read_version(root);
        read_data_set(root);
        const Json none = Json::object();
        const Json* defaults = find(root, "defaults", &Json::is_object, "an object");
        const Json* items = find(root, "items", &Json::is_array, "a list");
        const Json* output = find(root, "output", &Json::is_string, "a text");
        if (items == nullptr) {
            if (!root.contains("items")) refuse("", "has no items", nullptr, "\"items\": [{…}]");
            return;
        }
        GroupReader groups({.job = job_,
                            .options = options_,
                            .problems = problems_,
                            .defaults = defaults == nullptr ? none : *defaults,
                            .output = output});
        for (std::size_t i = 0; i < items->size(); ++i)
            groups.read((*items)[i], fmt::format("/items/{}", i));
        count();
    }

private:
    void refuse(std::string where, std::string what, const Json& found, std::string remedy = {}) {
        problems_.errors.push_back({.code = ErrorCode::input_invalid,
                                    .where = std::move(where),
                                    .what = std::move(what),
                                    .found = found.is_null()     ? ""
                                             : found.is_string() ? found.get<std::string>()
                                                                 : text_of(found),
                                    .remedy = std::move(remedy)});
    }

    const Json* find(const Json& root, const char* key, bool (Json::*is)() const,
                     const char* kind) {
        const auto found = root.find(key);
        if (found == root.end()) return nullptr;
        if (((*found).*is)()) return &*found;
        refuse(std::string("/") + key, fmt::format("is not {}", kind), *found);
        return nullptr;
    }

    void read_version(const Json& root) {
        const auto version = root.find("facet");
        if (version == root.end())
            refuse("", "has no version", nullptr, "\"facet\": 1 at the top");
        else if (*version != 1)
            refuse("/facet", "is a version that this program does not read", *version,
                   "\"facet\": 1");
    }

    void read_data_set(const Json& root) {
        const Json* const folder = find(root, "data_set", &Json::is_string, "a folder");
        if (folder != nullptr) job_.data_set = DataSet{job_.folder / folder->get<std::string>()};
    }

    void count() {
        std::size_t first = 0;
        for (Group& group : job_.groups) {
            group.first_index = first;
            first += group.item_count;
            if (first > most_items) {
                problems_.errors.push_back({.code = ErrorCode::limit_reached,
                                            .where = "/items",
                                            .what = fmt::format("more than {} items", most_items)});
                return;
            }
        }
        if (first == 0 && problems_.errors.empty())
            problems_.errors.push_back({.code = ErrorCode::usage,
                                        .where = "/items",
                                        .what = "no items",
                                        .remedy = "give at least one, with a scene that is there"});
    }

    Job& job_;
    const JobOptions& options_;
    JobProblems& problems_;
};

/// Adds the file, and the line and column of what a message is about.
template <class Message>
void place(Message& message, const fs::path& file, std::string_view text) {
    message.file = file.string();
    if (!message.where.starts_with('/') && !message.where.empty()) return;
    const bool is_second = message.what == "duplicate key";
    const auto found = base::json_place(text, message.where, is_second ? 1 : 0);
    if (!found || message.where.empty()) return;
    if (is_second)
        if (const auto first = base::json_place(text, message.where))
            message.remedy = fmt::format("the first is at {}:{}", first->line, first->column);
    message.where += fmt::format(" ({}:{})", found->line, found->column);
}

}  // namespace

std::optional<Job> parse_job(std::string_view text, const fs::path& file, const JobOptions& options,
                             JobProblems& problems) {
    Job job;
    job.file = file;
    job.folder = file.parent_path();
    job.text_hash = base::sha256_hex(std::as_bytes(std::span(text)));
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) {
        text.remove_prefix(mark.size());
        problems.warnings.push_back({.where = "@0x0",
                                     .what = "starts with a byte order mark",
                                     .remedy = "save it as UTF-8 without BOM"});
    }
    if (const auto root = base::parse_json<Json>(text, options.limits)) {
        Reader(job, options, problems).read(*root);
        if (problems.errors.empty()) check_outputs(job, problems);
    } else {
        problems.errors.push_back(root.error());
    }
    for (base::Error& error : problems.errors) place(error, file, text);
    for (base::Warning& warning : problems.warnings) place(warning, file, text);
    if (!problems.errors.empty()) return std::nullopt;
    return job;
}

std::optional<Job> read_job(const fs::path& file, const JobOptions& options,
                            JobProblems& problems) {
    const auto text = base::read_text_file(file, options.limits.json_bytes);
    if (text) return parse_job(*text, file, options, problems);
    problems.errors.push_back(text.error());
    return std::nullopt;
}

}  // namespace facet::batch
