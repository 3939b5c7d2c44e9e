// The files that a job writes: no two items the same one.
// SPDX-License-Identifier: MIT
#include "batch/outputs.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <climits>
#include <unordered_map>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

/// What a file system that knows no case would call the file.
class Identity {
public:
    std::string of(const fs::path& output) {
        const std::string folder = output.parent_path().string();
        auto [known, is_new] = folders_.try_emplace(folder);
        if (is_new) {
            std::error_code error;
            known->second =
                fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder), error).string();
        }
        std::string name = known->second + "/" + output.filename().string();
        std::ranges::transform(name, name.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        });
        return name;
    }

private:
    std::unordered_map<std::string, std::string> folders_;
};

}  // namespace

void check_outputs(const Job& job, JobProblems& problems) {
    constexpr std::size_t most_told = 20;
    Identity identity;
    std::unordered_map<std::string, std::size_t> owners;
    owners.reserve(job.item_count());
    for (std::size_t i = 0; i < job.item_count() && problems.errors.size() < most_told; ++i) {
        const fs::path output = job.output_of(i);
        const auto refuse = [&](std::string what, std::string remedy) {
            problems.errors.push_back({.code = base::ErrorCode::input_invalid,
                                       .where = "/output",
                                       .what = std::move(what),
                                       .found = output.string(),
                                       .remedy = std::move(remedy)});
        };
        if (const std::size_t bytes = output.filename().string().size(); bytes > NAME_MAX)
            return refuse(fmt::format("name too long ({} bytes)", bytes), "a shorter \"output\"");
        const auto [owner, is_new] = owners.try_emplace(identity.of(output), i);
        if (!is_new)
            refuse(fmt::format("items {} and {} write one file", owner->second, i),
                   "add {index} to \"output\"");
    }
}

}  // namespace facet::batch
