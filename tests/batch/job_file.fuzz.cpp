// Job and results files that are cut off, bent and stirred: an error, or a job; never anything
// else. SPDX-License-Identifier: MIT
#include "batch/job_file.h"

#include "batch/result.h"
#include "support/mutate.h"

#include <gtest/gtest.h>

#include <string_view>

namespace facet::batch {
namespace {

constexpr std::string_view job_seed =
    R"({ "facet": 1, "output": "out/{scene}/{camera}-{index:05}.png",
  "defaults": { "size": [512, 512], "env": "studio", "light": [["point:candela=1"], ["spot:lumen=3"]] },
  "items": [ { "scene": ["builtin:ball", "models/**/*.glb"], "camera": {"sphere": 9, "elevation": [-5, 60]},
               "set": { "material.*.roughness": [0.1, 0.5, 0.9], "material.*.base_color": [1, 0, 0] } },
             { "scene": "builtin:spheres", "frames": {"orbit": 12}, "samples": {"random": [1, 9], "count": 3, "seed": 2},
               "material": ["*=gold"], "output": "b{frame}-{index}.exr", "exposure": "auto" } ] })";
constexpr std::string_view line_seed =
    R"({"item":3,"output":"a.png","sha256":"00","status":"done","error":null,"sides":["a.depth.npy"],"input":"11"})";

constexpr std::string_view signs = "{}[]\"\\:,.-0e9\n*?/~%";

TEST(JobFiles, AreAJobOrAnError) {
    base::Limits limits;
    limits.json_bytes = 1 << 20;
    std::size_t sound = 0;
    support::mutate(job_seed, signs, 3, [&](const std::string& text) {
        JobProblems problems;
        const auto job =
            parse_job(text, "/nowhere/job.json", {.settings = {}, .limits = limits}, problems);
        EXPECT_NE(job.has_value(), !problems.errors.empty()) << text;
        for (const base::Error& error : problems.errors) EXPECT_FALSE(error.what.empty()) << text;
        if (!job) return;
        ++sound;
        for (std::size_t i = 0; i < std::min<std::size_t>(job->item_count(), 20); ++i)
            static_cast<void>(job->item(i));
    });
    EXPECT_GT(sound, 100U);
}

TEST(ResultLines, AreARecordOrAnError) {
    support::mutate(line_seed, signs, 4, [](const std::string& text) {
        const auto record = parse_record(text, {});
        if (!record) {
            EXPECT_FALSE(record.error().what.empty());
        }
    });
}

}  // namespace
}  // namespace facet::batch
