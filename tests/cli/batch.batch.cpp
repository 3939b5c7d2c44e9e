// facet batch as it is typed.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

constexpr std::string_view small_job = R"({"facet": 1, "output": "out/{scene}-{index}.png",
  "defaults": {"size": [40, 30], "samples": 2, "env": "overcast"},
  "items": [{"scene": ["builtin:ball", "builtin:spheres"], "set": {"material.*.roughness": [0.2, 0.8]}}]})";

Ran batch(const TemporaryFolder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), "batch");
    return facet(words, {.folder = folder.path()});
}

std::vector<json> lines_of(const std::string& text) {
    std::vector<json> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) out.push_back(json::parse(line));
    return out;
}

/// The object that ends a run's --json.
json run_json(const TemporaryFolder& folder, int exit, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"job.json", "--json"});
    const Ran ran = batch(folder, more);
    EXPECT_EQ(ran.exit, exit) << ran.err;
    return ran.out.empty() ? json() : lines_of(ran.out).back();
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            out[fs::relative(entry.path(), folder).string()] = text_of(entry.path());
    return out;
}

void expect_refused(const Ran& ran, int exit, std::string_view word) {
    EXPECT_EQ(ran.exit, exit) << ran.err;
    EXPECT_NE(ran.err.find(word), std::string::npos) << ran.err;
    EXPECT_EQ(support::line_count(ran.err), 1U) << ran.err;
    EXPECT_EQ(ran.out, "");
}

TEST(Batch, GivesTheBytesOfFacetRender) {
    const TemporaryFolder folder;
    folder.write("job.json", small_job);
    EXPECT_EQ(batch(folder, {"job.json", "-q", "--jobs", "2"}).exit, 0);
    const Ran dry = batch(folder, {"job.json", "--dry-run", "--json"});
    const auto items = lines_of(dry.out);
    ASSERT_EQ(items.size(), 4U);
    for (const json& item : items) {
        std::vector<std::string> words = {"render", item["scene"], "-o", "single.png"};
        for (const auto& [key, value] : item["settings"].items())
            for (const json& text : value.is_array() ? value : json::array({value}))
                words.insert(words.end(), {"--" + key, text.get<std::string>()});
        ASSERT_EQ(facet(words, {.folder = folder.path()}).exit, 0);
        EXPECT_EQ(text_of(folder / item["output"].get<std::string>()),
                  text_of(folder / "single.png"))
            << item;
    }
}

TEST(Batch, BytesDoNotDependOnWorkersOrShards) {
    const TemporaryFolder one;
    const TemporaryFolder many;
    for (const TemporaryFolder* folder : {&one, &many}) folder->write("job.json", small_job);
    EXPECT_EQ(batch(one, {"job.json", "-q", "--jobs", "1"}).exit, 0);
    for (const char* shard : {"2/3", "0/3", "1/3"})
        EXPECT_EQ(batch(many, {"job.json", "-q", "--jobs", "3", "--shard", shard}).exit, 0);
    EXPECT_EQ(files_in(one / "out"), files_in(many / "out"));
    const Ran merged = batch(many, {"job.json", "--merge", "--json"});
    EXPECT_EQ(merged.exit, 0) << merged.err;
    EXPECT_EQ(lines_of(merged.out).back()["done"], 4);
    fs::remove(many / "out/ball-1.png");
    const Ran missing = batch(many, {"job.json", "--merge"});
    EXPECT_EQ(missing.exit, 1);
    EXPECT_NE(missing.err.find("item 1 is missing"), std::string::npos) << missing.err;
}

TEST(Batch, ResumesWithWhatChanged) {
    const TemporaryFolder folder;
    folder.write("job.json", small_job);
    EXPECT_EQ(run_json(folder, 0)["done"], 4);
    EXPECT_EQ(run_json(folder, 0)["skipped"], 4);
    fs::remove(folder / "out/ball-0.png");
    EXPECT_EQ(run_json(folder, 0)["done"], 1);
    std::string edited(small_job);
    edited.replace(edited.find("0.8"), 3, "0.9");
    folder.write("job.json", edited);
    EXPECT_EQ(run_json(folder, 0)["done"], 2) << "only items whose settings changed";
    EXPECT_EQ(run_json(folder, 0, {"--restart"})["done"], 4);
}

TEST(Batch, AChangedInputFileIsRenderedAgain) {
    const TemporaryFolder folder;
    fs::copy(FACET_SOURCE_DIR "/resources/scenes/ball.glb", folder / "a.glb");
    fs::copy(FACET_SOURCE_DIR "/resources/scenes/furnace.glb", folder / "b.glb");
    folder.write("job.json", R"({"facet": 1, "output": "{scene}.png",
        "items": [{"scene": "*.glb", "size": "32x32", "samples": 1}]})");
    EXPECT_EQ(run_json(folder, 0)["done"], 2);
    fs::copy(FACET_SOURCE_DIR "/resources/scenes/spheres.glb", folder / "b.glb",
             fs::copy_options::overwrite_existing);
    const json again = run_json(folder, 0);
    EXPECT_EQ(again["done"], 1);
    EXPECT_EQ(again["skipped"], 1);
}

TEST(Batch, ABadSceneFailsItsItemAlone) {
    const TemporaryFolder folder;
    folder.write("bad.glb", "glTF\x02");
    folder.write(
        "job.json",
        R"({"facet": 1, "output": "{scene}.png", "defaults": {"size": "24x24", "samples": 1},
        "items": [{"scene": ["bad.glb", "builtin:ball", "none.glb"]}, {"scene": "builtin:spheres", "camera": "nowhere"}]})");
    const Ran ran = batch(folder, {"job.json"});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_NE(ran.out.find("1 of 4 done, 3 failed"), std::string::npos) << ran.out;
    EXPECT_TRUE(fs::exists(folder / "ball.png"));
    EXPECT_FALSE(fs::exists(folder / "bad.png"));
    const auto lines = lines_of(text_of(folder / "job.facet/results-0-of-1.jsonl"));
    ASSERT_EQ(lines.size(), 5U);
    std::map<std::string, int> codes;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        for (const char* key : {"item", "output", "sha256", "status", "error", "ms", "peak_rss"})
            EXPECT_TRUE(lines[i].contains(key)) << key;
        codes[lines[i]["output"]] = lines[i]["code"];
        if (lines[i]["status"] != "failed") continue;
        for (const char* key : {"severity", "code", "path", "pointer", "message"})
            EXPECT_TRUE(lines[i]["error"].contains(key)) << key;
    }
    EXPECT_EQ(codes, (std::map<std::string, int>{
                         {"bad.png", 3}, {"ball.png", 0}, {"none.png", 3}, {"spheres.png", 2}}));
    EXPECT_EQ(run_json(folder, 1)["skipped"], 1) << "what failed is tried again";
}

TEST(Batch, AWorkerThatDiesOrHangsFailsItsItemAlone) {
    const TemporaryFolder folder;
    // A few large pictures of many samples: seconds each, so that the shell finds the worker at
    // work.
    folder.write("job.json",
                 R"({"facet": 1, "output": "{index}.png", "defaults": {"env": "overcast"},
        "items": [{"scene": "builtin:ball", "size": "32x32", "samples": 1},
                  {"scene": "builtin:showcase", "size": "1280x960", "samples": 256},
                  {"scene": "builtin:ball", "size": "32x32", "samples": 2}]})");
    const std::string program = FACET_BINARY_DIR "/facet";
    const auto meddle = [&](const std::string& signal, const std::string& options) {
        // Whoever is still at work after the small ones are done is at work on the large one.
        return support::run(
            {"/bin/bash", "-c",
             program + " batch job.json --restart --jobs 1 " + options +
                 " & p=$!; until [ -e 0.png ] && [ -e 2.png ]; do sleep 0.05; done; sleep 0.3; "
                 "for try in 1 2; do pkill -" +
                 signal + " -P $p; sleep 0.7; done; wait $p"},
            {.folder = folder.path()});
    };
    // Orders follow the scene's first appearance: the large one comes last.
    const Ran killed = meddle("SEGV", "--retries 0");
    EXPECT_EQ(killed.exit, 1) << killed.err;
    EXPECT_NE(killed.err.find("the worker died (signal 11"), std::string::npos) << killed.err;
    EXPECT_TRUE(fs::exists(folder / "2.png"));
    EXPECT_FALSE(fs::exists(folder / "1.png"));
    fs::remove(folder / "0.png");
    fs::remove(folder / "2.png");
    const Ran hung = meddle("STOP", "--item-timeout 2");
    EXPECT_EQ(hung.exit, 1) << hung.err;
    EXPECT_NE(hung.err.find("took longer than 2 seconds"), std::string::npos) << hung.err;
}

TEST(Batch, TermEndsItCleanlyAndItGoesOn) {
    const TemporaryFolder folder;
    folder.write("job.json", R"({"facet": 1, "output": "{index:03}.png",
        "items": [{"scene": "builtin:ball", "size": "320x240", "env_rotation": {"random": [0, 9], "count": 20}}]})");
    const Ran ended = support::run(
        {"/bin/bash", "-c",
         FACET_BINARY_DIR
         "/facet batch job.json --jobs 1 & p=$!; until [ -e 003.png ]; do sleep 0.02; done; "
         "kill -TERM $p; wait $p"},
        {.folder = folder.path()});
    EXPECT_EQ(ended.exit, 143) << ended.err;
    EXPECT_NE(ended.err.find("run again to resume"), std::string::npos) << ended.err;
    const json rest = run_json(folder, 0);
    EXPECT_GT(rest["skipped"], 3);
    EXPECT_EQ(rest["skipped"].get<int>() + rest["done"].get<int>(), 20);
}

TEST(Batch, ASecondRunWaitsOrIsTurnedAway) {
    const TemporaryFolder folder;
    folder.write("job.json", R"({"facet": 1, "output": "{index}.png",
        "items": [{"scene": "builtin:ball", "size": "320x240", "env_rotation": {"random": [0, 9], "count": 12}}]})");
    const Ran both = support::run(
        {"/bin/bash", "-c",
         FACET_BINARY_DIR "/facet batch job.json -q & until [ -e job.facet/results-0-of-1.jsonl ]; "
                          "do sleep 0.02; done; " FACET_BINARY_DIR
                          "/facet batch job.json -q; echo refused $?; " FACET_BINARY_DIR
                          "/facet batch job.json -q --wait 600; echo waited $?; wait"},
        {.folder = folder.path()});
    EXPECT_NE(both.out.find("refused 75"), std::string::npos) << both.out << both.err;
    EXPECT_NE(both.out.find("waited 0"), std::string::npos) << both.out << both.err;
    EXPECT_NE(both.err.find("locked by pid"), std::string::npos) << both.err;
}

TEST(Batch, TurntablesKeepOneExposure) {
    const TemporaryFolder folder;
    folder.write("job.json", R"({"facet": 1, "output": "{frame:02}.png",
        "items": [{"scene": "builtin:ball", "size": "32x32", "samples": 1, "env": "studio", "frames": {"orbit": 6}}]})");
    EXPECT_EQ(batch(folder, {"job.json", "--jobs", "2", "-q", "--report", "sheet.html"}).exit, 0);
    std::set<double> exposures;
    for (const json& line : lines_of(text_of(folder / "job.facet/results-0-of-1.jsonl")))
        if (line.contains("exposure")) exposures.insert(line["exposure"].get<double>());
    EXPECT_EQ(exposures.size(), 1U);
    const std::string page = text_of(folder / "sheet.html");
    EXPECT_NE(page.find("ffmpeg -framerate 24"), std::string::npos);
    EXPECT_NE(page.find("%02d.png"), std::string::npos);
}

TEST(Batch, ComparesWithABaseline) {
    const TemporaryFolder folder;
    folder.write("job.json", small_job);
    EXPECT_EQ(batch(folder, {"job.json", "-q"}).exit, 0);
    fs::create_directories(folder / "good");
    fs::copy(folder / "out", folder / "good/out");
    const Ran same = batch(folder, {"job.json", "-q", "--baseline", "good"});
    EXPECT_EQ(same.exit, 0) << same.out;
    std::string edited(small_job);
    edited.replace(edited.find("0.8"), 3, "0.3");
    folder.write("job.json", edited);
    const Ran changed =
        batch(folder, {"job.json", "-q", "--baseline", "good", "--report", "r.html"});
    EXPECT_EQ(changed.exit, 1);
    EXPECT_NE(changed.out.find("changed  out/ball-1.png  FLIP"), std::string::npos) << changed.out;
    EXPECT_EQ(changed.out.find("changed  out/ball-0.png"), std::string::npos) << changed.out;
    EXPECT_EQ(batch(folder, {"job.json", "-q", "--baseline", "good", "--max-flip", "1"}).exit, 0);
    expect_refused(batch(folder, {"job.json", "--baseline", "none"}), 2, "no such folder");
    expect_refused(batch(folder, {"job.json", "--max-flip", "0.1"}), 2, "--baseline");
}

/// The numbers of a .npy of 32-bit floats.
std::vector<float> npy_of(const fs::path& file) {
    const std::string text = text_of(file);
    const auto low = static_cast<unsigned char>(text[8]);
    const auto high = static_cast<unsigned char>(text[9]);
    const std::size_t start = 10 + low + 256U * high;
    std::vector<float> out((text.size() - start) / sizeof(float));
    std::memcpy(out.data(), text.data() + start, out.size() * sizeof(float));
    return out;
}

/// Largest distance in metres between `position` and what depth and camera make of each pixel.
double reprojection_error(const json& frame, const std::vector<float>& depth,
                          const std::vector<float>& position) {
    double worst = 0.0;
    const std::size_t width = frame["w"];
    const json& matrix = frame["transform_matrix"];
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (!std::isfinite(depth[i])) continue;
        const double d = static_cast<double>(depth[i]);
        const double x = static_cast<double>(i % width) + 0.5 - frame["cx"].get<double>();
        const double y = static_cast<double>(i / width) + 0.5 - frame["cy"].get<double>();
        const std::array<double, 4> p{x / frame["fl_x"].get<double>() * d,
                                      -y / frame["fl_y"].get<double>() * d, -d, 1.0};
        for (std::size_t row = 0; row < 3; ++row) {
            double world = 0.0;
            for (std::size_t k = 0; k < 4; ++k) world += matrix[row][k].get<double>() * p[k];
            worst = std::max(worst, std::fabs(world - static_cast<double>(position[i * 3 + row])));
        }
    }
    return worst;
}

TEST(Batch, MakesADataSet) {
    const TemporaryFolder folder;
    folder.write("job.json", R"({"facet": 1, "output": "set/images/{camera}.exr", "data_set": "set",
        "items": [{"scene": "builtin:spheres", "size": "48x32", "samples": 1, "camera": {"sphere": 5, "elevation": [5, 60]},
                   "aov": ["depth", "position", "object_id"], "aov_format": "npy"}]})");
    const Ran ran = batch(folder, {"job.json", "-q"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const auto manifest = lines_of(text_of(folder / "set/manifest.jsonl"));
    ASSERT_EQ(manifest.size(), 5U);
    EXPECT_EQ(manifest[2]["file"], "images/2.exr");
    EXPECT_EQ(manifest[2]["aovs"]["depth"], "images/2.depth.npy");
    const json transforms = json::parse(text_of(folder / "set/transforms.json"));
    ASSERT_EQ(transforms["frames"].size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const json& frame = transforms["frames"][i];
        const std::string stem = "set/images/" + std::to_string(i);
        EXPECT_NEAR(frame["camera_angle_x"].get<double>(),
                    2.0 * std::atan(24.0 / frame["fl_x"].get<double>()), 1e-12);
        // The scene is 6 m wide; floats of that size are 5e-7 apart.
        EXPECT_LT(reprojection_error(frame, npy_of(folder / (stem + ".depth.npy")),
                                     npy_of(folder / (stem + ".position.npy"))),
                  1e-4);
    }
    const json names = json::parse(text_of(folder / "set/names.json"));
    EXPECT_FALSE(names["builtin:spheres"]["object_id"].empty());
    const std::string depth = text_of(folder / "set/images/2.depth.npy");
    EXPECT_NE(depth.find("'descr': '<f4', 'fortran_order': False, 'shape': (32, 48), }"),
              std::string::npos);
    EXPECT_NE(text_of(folder / "set/images/2.object_id.npy").find("'<u4'"), std::string::npos);
}

TEST(Batch, MistakesAreToldBeforeAnythingIsDone) {
    const TemporaryFolder folder;
    folder.write("job.json", small_job);
    expect_refused(batch(folder, {}), 2, "no job given");
    expect_refused(batch(folder, {"none.json"}), 3, "No such file");
    expect_refused(batch(folder, {"job.json", "--shard", "2/2"}), 2, "--shard");
    expect_refused(batch(folder, {"job.json", "--restart", "--resume"}), 2, "excludes");
    expect_refused(batch(folder, {"job.json", "--item-timeout", "0"}), 2, "--item-timeout");
    expect_refused(batch(folder, {"job.json", "--report", "no/where.html"}), 2, "no such folder");
    folder.write("empty.json", R"({"facet": 1, "output": "a.png", "items": []})");
    expect_refused(batch(folder, {"empty.json"}), 2, "no items");
    folder.write("typo.json", R"({"facet": 1, "output": "a.png",
 "items": [{"scene": "builtin:ball", "samplse": 3}]})");
    expect_refused(batch(folder, {"typo.json"}), 3,
                   "typo.json:/items/0/samplse (2:38): unknown key");
    folder.write("film.json", R"({"facet": 1, "output": "a.png",
        "items": [{"scene": "builtin:ball", "frames": {"animation": "Walk", "fps": 24}}]})");
    expect_refused(batch(folder, {"film.json"}), 3, "no such animation (Walk); it has none");
    EXPECT_FALSE(fs::exists(folder / "job.facet"));
    EXPECT_FALSE(fs::exists(folder / "out"));
    EXPECT_EQ(
        facet({"batch", "job.json", "-q", "--jobs", "100000"}, {.folder = folder.path()}).exit, 0);
}

}  // namespace
}  // namespace facet::cli
