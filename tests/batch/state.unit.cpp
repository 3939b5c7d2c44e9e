// What a job remembers from run to run: results files, locks, queues.
// SPDX-License-Identifier: MIT
#include "batch/state.h"

#include "base/hash.h"
#include "batch/collect.h"
#include "batch/input_hash.h"
#include "batch/job_file.h"
#include "batch/leftovers.h"
#include "batch/lock.h"
#include "batch/queues.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

namespace facet::batch {
namespace {

using support::TemporaryFolder;
using support::text_of;

constexpr std::string_view three = R"("scene": "builtin:ball", "samples": [1, 2, 3])";

Job job_in(const TemporaryFolder& folder, std::string_view members = three) {
    const std::string text =
        R"({"facet": 1, "output": "out/{index}.png", "items": [{)" + std::string(members) + "}]}";
    JobProblems problems;
    auto job = parse_job(text, folder.write("job.json", text), {}, problems);
    EXPECT_TRUE(job) << (problems.errors.empty() ? "" : base::to_line(problems.errors.front()));
    if (!job) std::abort();
    std::filesystem::create_directories(state_folder(*job));
    return std::move(*job);
}

std::string line_of(const Job& job, std::size_t item, std::string_view bytes) {
    ItemResult result{.item = item, .output = recorded_path(job, job.output_of(item))};
    result.sha256 = base::sha256_hex(std::as_bytes(std::span(bytes)));
    result.input = InputHashes({}).of(job, *job.item(item));
    return to_line(result);
}

void append(ResultsFile& file, const std::string& line) {
    EXPECT_TRUE(file.append(std::span(&line, 1)));
}

TEST(Results, ATornLineIsDroppedAndTheRestStays) {
    const TemporaryFolder folder;
    const Job job = job_in(folder);
    {
        auto file = ResultsFile::open(job, {}, false);
        ASSERT_TRUE(file);
        append(*file, line_of(job, 0, "zero"));
        append(*file, line_of(job, 1, "one"));
    }
    const auto path = state_folder(job) / "results-0-of-1.jsonl";
    const std::string whole = text_of(path);
    for (std::size_t cut = whole.size() - 1; whole[cut - 1] != '\n'; --cut) {
        std::ofstream(path, std::ios::binary) << whole.substr(0, cut);
        const auto done = read_done(job, {}, {});
        ASSERT_TRUE(done) << base::to_line(done.error());
        EXPECT_EQ(done->size(), 1U);
    }
    auto file = ResultsFile::open(job, {}, false);
    ASSERT_TRUE(file);
    append(*file, line_of(job, 2, "two"));
    EXPECT_EQ(read_done(job, {}, {})->size(), 2U);
}

TEST(Results, OfAnotherJobAreRefused) {
    const TemporaryFolder folder;
    const Job job = job_in(folder);
    const auto path = state_folder(job) / "results-0-of-1.jsonl";
    const std::string header = R"({"facet":1,"job":"job.json","hash":"00","shard":0,"of":1})"
                               "\n";
    const auto message = [&](const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
        const auto done = read_done(job, {}, {});
        if (done) return std::string("taken");
        EXPECT_EQ(base::exit_code(done.error().code), 3);
        EXPECT_EQ(done.error().remedy, "--restart begins anew");
        return done.error().what;
    };
    EXPECT_EQ(message(header), "taken");
    EXPECT_EQ(message(header + line_of(job, 1, "one") + "\n"), "taken") << "the job was edited";
    EXPECT_EQ(message(header + R"({"item":0,"output":"elsewhere.png","status":"done"})" + "\n"),
              "results do not match this job");
    EXPECT_EQ(message(header + "{broken}\n" + line_of(job, 1, "one") + "\n"), "not valid JSON");
    EXPECT_EQ(message(header + "{}\n"), "not the result of an item");
    EXPECT_EQ(message("{\"facet\":2}\n"), "is of a newer version");
    EXPECT_EQ(message("hello\n"), "no results of a job");
}

TEST(Results, HoldOnlyWhileInputAndOutputAreTheSame) {
    const TemporaryFolder folder;
    const Job job = job_in(folder);
    const auto record = parse_record(line_of(job, 0, "picture"), {});
    ASSERT_TRUE(record);
    EXPECT_FALSE(holds(job, *record, record->input));
    folder.write("out/0.png", "picture");
    EXPECT_TRUE(holds(job, *record, record->input));
    EXPECT_FALSE(holds(job, *record, "other"));
    folder.write("out/0.png", "pictures");
    EXPECT_FALSE(holds(job, *record, record->input));
}

TEST(Results, ShardsAreJoined) {
    const TemporaryFolder folder;
    const Job job = job_in(folder);
    for (const std::size_t shard : {0U, 1U}) {
        auto file = ResultsFile::open(job, {shard, 2}, false);
        ASSERT_TRUE(file);
        folder.write("out/" + std::to_string(shard) + ".png", "picture");
        append(*file, line_of(job, shard, "picture"));
    }
    const auto merged = merge(job, {});
    ASSERT_TRUE(merged);
    EXPECT_EQ(merged->done, 2U);
    EXPECT_EQ(merged->missing, std::vector<std::size_t>{2});
    folder.write("out/0.png", "another");
    EXPECT_EQ(merge(job, {})->missing, (std::vector<std::size_t>{0, 2}));
}

TEST(InputHash, ChangesWithEverythingThatThePictureDependsOn) {
    const TemporaryFolder folder;
    folder.write("a.png", "texture");
    const Job job =
        job_in(folder, R"("scene": "builtin:ball", "env": ["studio", "sky"], "threads": 2)");
    const auto hash = [&](std::size_t index) { return InputHashes({}).of(job, *job.item(index)); };
    EXPECT_EQ(hash(0), hash(0));
    EXPECT_NE(hash(0), hash(1));
    const Job threads =
        job_in(folder, R"("scene": "builtin:ball", "env": ["studio", "sky"], "threads": 1)");
    EXPECT_EQ(hash(0), InputHashes({}).of(threads, *threads.item(0)));
}

TEST(Leftovers, OfProcessesThatAreGoneAreRemoved) {
    const TemporaryFolder folder;
    const Job job = job_in(folder);
    const pid_t gone = ::fork();
    if (gone == 0) std::_Exit(0);
    ::waitpid(gone, nullptr, 0);
    const std::string dead = "." + std::to_string(gone) + ".tmp";
    const std::string alive = "." + std::to_string(::getpid()) + ".tmp";
    for (const std::string& name : {".1.png" + dead, ".1.depth.npy" + dead, ".1.png" + alive,
                                    ".other.png" + dead, std::string("1.png")})
        folder.write("out/" + name, "x");
    remove_leftovers(job, items_of(job, {}));
    std::set<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "out"))
        left.insert(entry.path().filename().string());
    EXPECT_EQ(left, (std::set<std::string>{".1.png" + alive, ".other.png" + dead, "1.png"}));
}

TEST(Lock, KeepsRunsOfOneShardApart) {
    const TemporaryFolder folder;
    base::Warnings warnings;
    const auto take = [&](Shard shard) {
        return ShardLock::take(folder.path(), shard, std::chrono::milliseconds(0), warnings);
    };
    auto first = take({0, 2});
    ASSERT_TRUE(first) << base::to_line(first.error());
    EXPECT_TRUE(take({1, 2})) << "the other half may run";
    const auto same = take({0, 2});
    ASSERT_FALSE(same);
    EXPECT_EQ(base::exit_code(same.error().code), 75);
    EXPECT_NE(same.error().what.find("locked by pid " + std::to_string(::getpid()) + " on host"),
              std::string::npos)
        << same.error().what;
    const auto split = take({0, 3});
    ASSERT_FALSE(split) << "thirds would render halves' items too";
    EXPECT_EQ(base::exit_code(split.error().code), 75);
    { const ShardLock ended = std::move(*first); }
    EXPECT_TRUE(take({0, 2}));
}

TEST(Lock, GoesWithItsProcess) {
    const TemporaryFolder folder;
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t pid = ::fork();
    if (pid == 0) {
        base::Warnings warnings;
        const auto lock =
            ShardLock::take(folder.path(), {}, std::chrono::milliseconds(0), warnings);
        static_cast<void>(!::write(ready[1], lock ? "y" : "n", 1));
        ::pause();
        std::_Exit(0);
    }
    char answer = 0;
    ASSERT_EQ(::read(ready[0], &answer, 1), 1);
    EXPECT_EQ(answer, 'y');
    base::Warnings warnings;
    EXPECT_FALSE(ShardLock::take(folder.path(), {}, std::chrono::milliseconds(0), warnings));
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
    EXPECT_TRUE(ShardLock::take(folder.path(), {}, std::chrono::milliseconds(0), warnings));
    ::close(ready[0]);
    ::close(ready[1]);
}

TEST(Queues, KeepAScenesItemsTogetherAndShareTheRest) {
    const TemporaryFolder folder;
    const Job job =
        job_in(folder, R"("scene": ["builtin:ball", "builtin:spheres"], "samples": [1, 2, 3, 4])");
    Queues queues(job, items_of(job, {}));
    std::size_t one = 0;
    std::size_t two = 0;
    const auto next = [&](std::size_t& queue) {
        return static_cast<int>(queues.next(queue).value_or(99));
    };
    EXPECT_EQ(next(one), 0);
    EXPECT_EQ(next(two), 4);
    EXPECT_EQ(next(one), 1);
    for (const int item : {5, 6, 7}) EXPECT_EQ(next(two), item);
    EXPECT_EQ(next(two), 3) << "the later half of what the other has left";
    EXPECT_EQ(next(one), 2);
    EXPECT_EQ(next(one), 99);
    EXPECT_EQ(queues.size(), 0U);
    queues.put_back(two, 3);
    EXPECT_EQ(next(two), 3);
}

}  // namespace
}  // namespace facet::batch
