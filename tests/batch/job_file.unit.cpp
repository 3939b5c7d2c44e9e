// Job files: what they multiply out to, and how mistakes in them are told.
// SPDX-License-Identifier: MIT
#include "batch/job_file.h"

#include "base/file.h"
#include "batch/schema.h"
#include "scene/animation_fixture.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace facet::batch {
namespace {

using support::TemporaryFolder;

struct Parsed {
    std::optional<Job> job;
    JobProblems problems;

    [[nodiscard]] std::string first() const {
        return problems.errors.empty() ? "" : base::to_line(problems.errors.front());
    }
};

Parsed parse(std::string_view text, const std::filesystem::path& file = "job.json",
             const JobOptions& options = {}) {
    Parsed out;
    out.job = parse_job(text, file, options, out.problems);
    return out;
}

/// A job of one entry with these members.
std::string job_of(std::string_view members, std::string_view output = "{index}.png") {
    return R"({"facet": 1, "output": ")" + std::string(output) + R"(", "items": [{)" +
           std::string(members) + "}]}";
}

std::vector<Item> items(const Parsed& parsed) {
    std::vector<Item> out;
    EXPECT_TRUE(parsed.job) << parsed.first();
    for (std::size_t i = 0; parsed.job && i < parsed.job->item_count(); ++i) {
        auto item = parsed.job->item(i);
        EXPECT_TRUE(item);
        if (item) out.push_back(std::move(*item));
    }
    return out;
}

TEST(JobFile, TheContractsExample) {
    const TemporaryFolder folder;
    for (const char* name : {"models/b.glb", "models/a.glb", "models/c.gltf"})
        folder.write(name, "x");
    const auto parsed = parse(R"({ "facet": 1,
  "output": "out/{scene}/{camera}-{index}.png",
  "defaults": { "size": [512, 512], "env": "studio" },
  "items": [ { "scene": ["models/*.glb"], "camera": ["auto", "orbit:azimuth=90"],
               "set": { "material.*.roughness": [0.1, 0.5, 0.9] } } ] })",
                              folder / "job.json");
    const auto all = items(parsed);
    ASSERT_EQ(all.size(), 12U);
    EXPECT_EQ(all[0].scene, (folder / "models/a.glb").string());
    EXPECT_EQ(all[0].output, folder / "out/a/auto-0.png");
    EXPECT_EQ(all[0].settings.size, (math::Extent{512, 512}));
    EXPECT_EQ(all[5].output, folder / "out/a/orbit_azimuth=90-5.png");
    EXPECT_EQ(all[5].settings.set, std::vector<std::string>{"material.*.roughness=0.9"});
    EXPECT_EQ(all[6].scene, (folder / "models/b.glb").string());
    EXPECT_EQ(all[11].settings.camera, "orbit:azimuth=90");
}

TEST(JobFile, ListsThatAreValuesDoNotMultiply) {
    EXPECT_EQ(items(parse(job_of(R"("scene": "builtin:ball", "size": [64, 32],
        "light": ["point:candela=1", "spot:candela=2"], "aov": ["depth", "normal"],
        "set": {"material.*.base_color": [1, 0, 0]})")))
                  .size(),
              1U);
    const auto all = items(parse(job_of(R"("scene": "builtin:ball", "size": [[64, 32], "16x16"],
        "light": [["point:candela=1"], ["point:candela=2", "spot:candela=2"], []],
        "set": {"material.*.base_color": [[1, 0, 0], "#00ff00"]})")));
    ASSERT_EQ(all.size(), 12U);
    EXPECT_EQ(all[3].settings.light.size(), 2U);
    EXPECT_EQ(all[3].settings.set.front(), "material.*.base_color=#00ff00");
    EXPECT_EQ(all[11].settings.size, (math::Extent{16, 16}));
}

TEST(JobFile, ItemsStandOverDefaults) {
    const auto all = items(parse(R"({"facet": 1, "output": "{index}.png",
        "defaults": {"scene": "builtin:ball", "samples": 4,
                     "set": {"material.*.roughness": 0.2, "material.*.metallic": 1}},
        "items": [{"samples": 2, "set": {"material.*.roughness": [0.5, 0.6]}}, {"output": "x.exr"}]})"));
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].settings.samples, 2U);
    EXPECT_EQ(all[1].settings.set,
              (std::vector<std::string>{"material.*.metallic=1", "material.*.roughness=0.6"}));
    EXPECT_EQ(all[2].settings.samples, 4U);
    EXPECT_EQ(all[2].output, "x.exr");
}

TEST(JobFile, TurntablesGoRoundAndKeepTheirDistance) {
    const auto all = items(parse(job_of(
        R"("scene": "builtin:ball", "camera": "orbit:azimuth=350,elevation=20", "frames": {"orbit": 4})",
        "{scene}-{frame:03}.png")));
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[0].settings.camera, "orbit:azimuth=350,elevation=20,fit=turn");
    EXPECT_EQ(all[1].settings.camera, "orbit:azimuth=80,elevation=20,fit=turn");
    EXPECT_EQ(all[3].output, "ball-003.png");
    EXPECT_EQ(*all[3].frame, 3U);
}

/// A file with an animation that lasts that long.
std::string walking(float seconds) {
    test::Document d = test::triangle();
    test::animate(d, 0, 0, "translation", test::times(d, {0, seconds}),
                  d.floats("VEC3", 3, {0, 0, 0, 4, 0, 0}));
    d.json["animations"][0]["name"] = "Walk";
    return d.text();
}

TEST(JobFile, AnimationsHaveAsManyFramesAsTheyLast) {
    const TemporaryFolder folder;
    folder.write("a.gltf", walking(1.0F));
    folder.write("b.gltf", walking(0.26F));
    const auto parsed =
        parse(job_of(R"("scene": ["a.gltf", "b.gltf"], "quality": ["draft", "standard"],
        "frames": {"animation": "Walk", "fps": 10})",
                     "{scene}-{quality}-{frame:02}.png"),
              folder / "job.json");
    const auto all = items(parsed);
    ASSERT_EQ(all.size(), 26U);
    EXPECT_EQ(all[0].settings.animation, "Walk");
    EXPECT_EQ(all[0].settings.time, 0.0F);
    EXPECT_EQ(all[9].settings.time, 0.9F) << "a film that loops is at its beginning at the end";
    EXPECT_EQ(all[9].output.filename(), "a-draft-09.png");
    EXPECT_EQ(all[19].output.filename(), "a-standard-09.png");
    EXPECT_EQ(all[22].output.filename(), "b-draft-02.png");
    EXPECT_EQ(all[22].settings.time, 0.2F);
    const std::vector<std::size_t> firsts{0, 1, 10, 20, 23};
    const auto films = parsed.job->films(firsts);
    ASSERT_EQ(films.size(), 4U);
    EXPECT_NE(films[0].find("-framerate 10 "), std::string::npos) << films[0];
    EXPECT_NE(films[2].find("-frames:v 3 "), std::string::npos) << films[2];
}

TEST(JobFile, MistakesInFramesOfAnimationsAreTold) {
    const TemporaryFolder folder;
    folder.write("a.gltf", walking(1.0F));
    const auto first = [&](std::string_view frames) {
        return parse(
                   job_of(R"("scene": "a.gltf", "frames": )" + std::string(frames), "{frame}.png"),
                   folder / "job.json")
            .first();
    };
    for (const auto& [frames, told] : std::vector<std::pair<const char*, const char*>>{
             {R"({"animation": "Run"})", "no such animation (Run); one of Walk"},
             {R"({"animation": "Walk", "fps": 0})", "/items/0/frames/fps"},
             {R"({"animation": "Walk", "fps": "x"})", "/items/0/frames/fps"},
             {R"({"animation": [1]})", "/items/0/frames/animation"},
             {R"({"animation": "Walk", "orbit": 3})", "an orbit or an animation"},
             {R"({"orbit": 3, "fps": 3})", "fps is for an animation"},
             {R"({"animation": "Walk", "fsp": 3})", "did you mean fps"}})
        EXPECT_NE(first(frames).find(told), std::string::npos) << frames << ": " << first(frames);
}

TEST(JobFile, RandomAxesComeFromTheirSeed) {
    const std::string text = job_of(
        R"("scene": "builtin:ball", "env_rotation": {"random": [0, 360], "count": 5, "seed": 7},
        "set": {"material.*.roughness": {"random": [0.25, 0.5]}, "material.*.base_color": {"random": [[0,0,0],[1,0.5,0.25]]}})");
    const auto one = items(parse(text));
    const auto two = items(parse(text));
    ASSERT_EQ(one.size(), 5U);
    std::set<std::string> seen;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_TRUE(one[i].settings == two[i].settings);
        EXPECT_GE(one[i].settings.env_rotation, 0.0F);
        EXPECT_LT(one[i].settings.env_rotation, 360.0F);
        const double roughness = std::stod(one[i].settings.set[0].substr(21));
        EXPECT_GE(roughness, 0.25);
        EXPECT_LE(roughness, 0.5);
        seen.insert(one[i].settings.set[0]);
    }
    EXPECT_EQ(seen.size(), 5U) << "without a count every item has its own";
}

TEST(JobFile, SphereCamerasAreSpreadEvenly) {
    const auto all = items(parse(
        job_of(R"("scene": "builtin:ball", "camera": {"sphere": 400, "elevation": [0, 90]})")));
    ASSERT_EQ(all.size(), 400U);
    // Equal areas: as many above 30 degrees as below, for sin 30 is a half.
    const auto is_high = [](const Item& item) {
        const std::string& camera = item.settings.camera;
        return std::stod(camera.substr(camera.find("elevation=") + 10)) > 30.0;
    };
    EXPECT_EQ(std::ranges::count_if(all, is_high), 200);
}

TEST(JobFile, MistakesAreToldWithTheirPlaces) {
    const auto line_of = [](std::string_view text) { return parse(text).first(); };
    EXPECT_EQ(line_of(R"({"facet": 1, "output": "a.png", "items": [{"scene": "builtin:ball",
 "apperture": 2}]})")
                  .substr(0, 40),
              "job.json:/items/0/apperture (2:2): unkno");
    EXPECT_NE(
        line_of(job_of(R"("scene": "builtin:ball", "samplse": 2)")).find("did you mean samples"),
        std::string::npos);
    EXPECT_NE(line_of(job_of(R"("scene": "builtin:ball", "samples": 2, "samples": 3)"))
                  .find("duplicate key (samples); the first is at 1:"),
              std::string::npos);
    const TemporaryFolder folder;
    const auto expect = [&](std::string_view members, std::string_view place,
                            std::string_view what) {
        const auto parsed = parse(job_of(members), folder / "job.json");
        ASSERT_FALSE(parsed.job) << members;
        EXPECT_EQ(base::exit_code(parsed.problems.errors.front().code), 3) << parsed.first();
        EXPECT_NE(parsed.first().find(place), std::string::npos) << parsed.first();
        EXPECT_NE(parsed.first().find(what), std::string::npos) << parsed.first();
    };
    expect(R"("scene": 3)", "/items/0/scene (", "a scene is a text (3)");
    expect(R"("samples": 2)", "/items/0 (", "has no scene");
    expect(R"("scene": "builtin:ball", "fov": "50mm")", "/items/0/fov (", "takes a number");
    expect(R"("scene": "builtin:ball", "fov": 500)", "/items/0/fov (", "0 to 179");
    expect(R"("scene": "builtin:ball", "tonemap": ["agx", "filmic"])", "/items/0/tonemap/1 (",
           "agx");
    expect(R"("scene": "builtin:ball", "set": {"material.*.roughness": [0.1, 2]})",
           "/items/0/set/material.*.roughness/1 (", "0 to 1");
    expect(R"("scene": "builtin:ball", "set": {"material.*.rougness": 1})", "rougness (",
           "did you mean roughness");
    expect(R"("scene": "builtin:ball", "light": ["pont:candela=1"])", "/items/0/light (", "point");
    expect(R"("scene": "builtin:ball", "camera": "orbit:azimth=3")", "/items/0/camera (",
           "azimuth");
    expect(R"("scene": "builtin:ball", "frames": {"orbit": 0})", "/items/0/frames (",
           "1 to 100000");
    expect(R"("scene": "builtin:ball", "camera": "hero", "frames": {"orbit": 3})",
           "/items/0/camera (", "orbit:");
    expect(R"("scene": "../secret.glb")", "/items/0/scene (", "outside the job's folder");
    expect(R"("scene": "http://example.com/a.glb")", "/items/0/scene (", "network is never used");
    expect(R"("scene": "builtin:ball", "env": "/etc/passwd.hdr")", "/items/0/env (", "outside");
    expect(R"("scene": "builtin:ball", "allow_read": ["/"])", "/items/0/allow_read (",
           "command line");
    expect(R"("scene": "builtin:ball", "samples": {"random": [3, 1]})", "/samples/random (",
           "high");
    expect(R"("scene": "builtin:ball", "samples": 1e999)", "", "number does not fit");
}

TEST(JobFile, AllUnknownKeysAreFoundInOneRun) {
    const auto parsed = parse(R"({"facet": 1, "outputs": 1, "output": "{index}.png", "items": [
        {"scene": "builtin:ball", "a": 1}, {"scene": "builtin:ball", "b": 1}]})");
    EXPECT_EQ(parsed.problems.errors.size(), 3U);
}

TEST(JobFile, EmptyJobsAreNoJobs) {
    for (const char* text :
         {R"({"facet": 1, "output": "a.png", "items": []})",
          R"({"facet": 1, "output": "a.png", "items": [{"scene": []}]})",
          R"({"facet": 1, "output": "a.png", "items": [{"scene": "none/*.glb"}]})"}) {
        const auto parsed = parse(text);
        ASSERT_FALSE(parsed.job) << text;
        EXPECT_EQ(base::exit_code(parsed.problems.errors.back().code), 2) << parsed.first();
    }
    for (const char* text : {"", "{", "[]", "{\"facet\": 1,}", "// a\n{}", "\xFF\xFE{\0"})
        EXPECT_EQ(base::exit_code(parse(text).problems.errors.front().code), 3) << text;
}

TEST(JobFile, LampsOfItsOwnAreNoFilesOfTheJob) {
    const auto parsed = parse(
        job_of(R"("scene": "builtin:ball", "light": "ies:file=builtin:downlight,position=0 1 0")"));
    ASSERT_TRUE(parsed.job) << parsed.first();
    EXPECT_NE(parsed.job->item(0)->settings.light.at(0).find("file=builtin:downlight"),
              std::string::npos);
    const TemporaryFolder folder;
    EXPECT_NE(parse(job_of(R"("scene": "builtin:ball", "light": "ies:file=/etc/lamp.ies")"),
                    folder / "job.json")
                  .first()
                  .find("outside"),
              std::string::npos);
}

TEST(JobFile, AByteOrderMarkIsAWarning) {
    const auto parsed = parse("\xEF\xBB\xBF" + job_of(R"("scene": "builtin:ball")"));
    EXPECT_TRUE(parsed.job);
    ASSERT_EQ(parsed.problems.warnings.size(), 1U);
}

TEST(JobFile, TwoItemsOfOneFileAreRefused) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "real");
    std::filesystem::create_directory_symlink(folder / "real", folder / "link");
    const auto clash = [&](std::string_view one, std::string_view two) {
        const std::string text = R"({"facet": 1, "items": [{"scene": "builtin:ball", "output": ")" +
                                 std::string(one) + R"("}, {"scene": "builtin:ball", "output": ")" +
                                 std::string(two) + R"("}]})";
        return parse(text, folder / "job.json").first();
    };
    EXPECT_EQ(clash("a.png", "b.png"), "");
    for (const auto& [one, two] : {std::pair("a.png", "a.png"),
                                   {"A.png", "a.png"},
                                   {"x/../a.png", "./a.png"},
                                   {"real/a.png", "link/a.png"}})
        EXPECT_NE(clash(one, two).find("items 0 and 1 write one file"), std::string::npos) << one;
}

TEST(NameTemplate, ValuesCannotLeaveTheirFolder) {
    EXPECT_EQ(safe_name("../../etc/passwd"), "_._.._etc_passwd");
    EXPECT_EQ(safe_name(".hidden"), "_hidden");
    EXPECT_EQ(safe_name(""), "_");
    EXPECT_EQ(safe_name("a\nb\"c"), "a_b_c");
    EXPECT_LE(safe_name(std::string(500, 'x')).size(), 100U);
    const std::vector<std::string> known = {"scene", "material.a:b.roughness"};
    EXPECT_FALSE(NameTemplate::parse("{scen}.png", known));
    EXPECT_FALSE(NameTemplate::parse("{scene.png", known));
    EXPECT_FALSE(NameTemplate::parse("scene}.png", known));
    EXPECT_FALSE(NameTemplate::parse("{scene:x}.png", known));
    const auto padded = NameTemplate::parse("{scene:04}.png", known);
    ASSERT_TRUE(padded);
    EXPECT_EQ(padded->expand([](std::string_view) { return "7"; }), "0007.png");
    EXPECT_EQ(padded->sequence([](std::string_view) { return "7"; }, "scene"), "%04d.png");
}

TEST(Shards, AreDisjointCompleteAndBalanced) {
    const auto parsed = parse(job_of(
        R"("samples": [1, 2, 3, 4, 5, 6, 7], "scene": ["builtin:ball", "builtin:spheres", "builtin:furnace"])"));
    ASSERT_TRUE(parsed.job) << parsed.first();
    for (const std::size_t count : {1U, 2U, 3U, 4U, 8U, 21U, 50U}) {
        std::multiset<std::size_t> all;
        std::size_t least = 100;
        std::size_t most = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto part = items_of(*parsed.job, {i, count});
            least = std::min(least, part.size());
            most = std::max(most, part.size());
            all.insert(part.begin(), part.end());
        }
        EXPECT_EQ(all.size(), 21U) << count;
        EXPECT_EQ(std::set(all.begin(), all.end()).size(), 21U) << count;
        EXPECT_LE(most - least, 1U) << count;
    }
    // A scene's items lie together, whichever axis varies fastest.
    std::vector<std::string> scenes;
    for (const std::size_t i : items_of(*parsed.job, {}))
        if (scenes.empty() || scenes.back() != parsed.job->scene_of(i))
            scenes.push_back(parsed.job->scene_of(i));
    EXPECT_EQ(scenes.size(), 3U);
}

TEST(Schema, TheFileIsWhatTheTablesSay) {
    const auto text = base::read_text_file(FACET_SOURCE_DIR "/resources/job.schema.json", 1 << 20);
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, job_schema().dump(1) + "\n")
        << "facet batch --schema >resources/job.schema.json";
}

}  // namespace
}  // namespace facet::batch
