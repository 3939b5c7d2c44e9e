// glTF files that are bent, and what may come of them.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/gltf.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <utility>

#include "gltf_fixture.h"

namespace facet::test {

inline std::size_t rounds() {
    const char* const asked = std::getenv("FACET_FUZZ_ROUNDS");
    return asked != nullptr ? static_cast<std::size_t>(std::strtoull(asked, nullptr, 10)) : 6000;
}

/// Every clip without a fault, before, within and after its time, and the pose of the file again.
inline void play(scene::Scene scene) {
    if (scene.rig == nullptr) return;
    for (const scene::Clip& clip : scene.rig->clips)
        for (const double time_s : {-1.0, 0.4, 1e30}) {
            if (clip.fault) continue;
            const scene::Pose pose = scene::pose_at(*scene.rig, &clip, time_s);
            scene::take_pose(pose, scene);
            scene::take_pose(pose, scene.lights);
        }
    scene::take_pose(scene::pose_at(*scene.rig, nullptr, 0.0), scene);
    for (const scene::Instance& instance : scene.instances)
        for (const std::uint32_t index : scene.meshes[instance.mesh.index].indices)
            ASSERT_LT(index, scene.meshes[instance.mesh.index].positions_m.size());
}

/// Loads, plays and checks: all answer, and in the contract's codes.
inline void feed(const std::string& text) {
    base::Limits limits;
    limits.memory_bytes = std::size_t{64} << 20;
    const auto loaded = load_text(text, {}, limits);
    if (!loaded) {
        const int code = base::exit_code(loaded.error().code);
        ASSERT_TRUE(code >= 3 && code <= 5) << base::to_line(loaded.error());
    }
    if (loaded) play(loaded->scene);
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    const auto findings =
        scene::gltf::check_bytes(base::Bytes(first, first + text.size()),
                                 {.label = "fuzz", .folder = {}, .allowed_folders = {}}, limits);
    ASSERT_LE(findings.size(), 10'000U);
}

inline std::string mutated(std::string text, std::mt19937& random) {
    const auto pick = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
    for (std::size_t n = 1 + pick(4); n > 0 && text.size() > 4; --n) {
        const std::size_t at = pick(text.size());
        switch (pick(5)) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
                break;
            case 2:
                text.erase(at, 1 + pick(8));
                break;
            case 3:
                text.insert(at, text.substr(pick(text.size()), 1 + pick(16)));
                break;
            default:
                text[at] = "0123456789-{}[],"[pick(16)];
                break;
        }
    }
    return text;
}

/// Every number of a document in turn replaced by ones that break things.
inline void replace_numbers(const Json& whole, Json& at, const Json& bad, std::size_t& left) {
    if (left == 0) return;
    if (at.is_structured()) {
        for (Json& child : at) replace_numbers(whole, child, bad, left);
        return;
    }
    if (!at.is_number()) return;
    --left;
    const Json kept = std::exchange(at, bad);
    feed(whole.dump());
    at = kept;
}
inline void feed_hostile_numbers(Json json) {
    for (const Json& bad :
         {Json(-1), Json(0), Json(2147483647), Json(4294967295U), Json(18446744073709551615U),
          Json(1e300), Json(0.5), Json("x"), Json(nullptr), Json::array(), Json::object()}) {
        std::size_t left = 400;
        replace_numbers(json, json, bad, left);
        if (testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace facet::test
