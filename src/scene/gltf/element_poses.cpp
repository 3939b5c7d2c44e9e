// Checks of the numbers in the buffers that move things: bind matrices, times, rotations.
// SPDX-License-Identifier: MIT
#include "scene/gltf/element_uses.h"
#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace facet::scene::gltf {
namespace {

void check_times(const Asset& asset, const Json& sampler, const std::string& at, Done& done,
                 Problems& problems) {
    const Accessor* const input = sound_accessor(asset, find(sampler, "input"));
    if (input == nullptr || input->component != Component::f32 || input->components != 1) return;
    if (!done.insert("times " + find(sampler, "input")->dump()).second) return;
    const std::vector<float> times = read_floats(*input);
    std::size_t told = 0;
    for (std::size_t i = 0; i < times.size() && told < most_told; ++i) {
        if (times[i] < 0.0F)
            problems.error("ACCESSOR_ANIMATION_INPUT_NEGATIVE", at, "time is negative",
                           fmt::format("{} at {}", times[i], i));
        else if (i > 0 && times[i] <= times[i - 1])
            problems.error("ACCESSOR_ANIMATION_INPUT_NON_INCREASING", at, "times do not increase",
                           fmt::format("{} at {} after {}", times[i], i, times[i - 1]));
        else
            continue;
        ++told;
    }
}

void check_rotations(const Asset& asset, const Json& sampler, const std::string& at, Done& done,
                     Problems& problems) {
    const Accessor* const output = sound_accessor(asset, find(sampler, "output"));
    if (output == nullptr || output->components != 4) return;
    if (!done.insert("rotations " + sampler.dump()).second) return;
    const bool is_cubic = string_at(sampler, "interpolation") == "CUBICSPLINE";
    const std::vector<float> values = read_floats(*output);
    std::size_t told = 0;
    for (std::size_t q = 0; q * 4 + 3 < values.size() && told < most_told; ++q) {
        if (is_cubic && q % 3 != 1) continue;  // tangents before and after the value
        double square = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto part = static_cast<double>(values[q * 4 + i]);
            square += part * part;
        }
        if (std::fabs(std::sqrt(square) - 1.0) <= unit_tolerance) continue;
        problems.error("ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", at,
                       "quaternion is not of length 1",
                       fmt::format("{} at {}", std::sqrt(square), q));
        ++told;
    }
}

void check_animation(const Asset& asset, std::size_t index, Done& done, Problems& problems) {
    const Json& animation = *element_at(asset.json, "animations", index);
    for (std::size_t s = 0; s < count_at(animation, "samplers"); ++s)
        check_times(asset, *element_at(animation, "samplers", s),
                    fmt::format("/animations/{}/samplers/{}/input", index, s), done, problems);
    for (std::size_t c = 0; c < count_at(animation, "channels"); ++c) {
        const Json& channel = *element_at(animation, "channels", c);
        const Json* const path = find_path(channel, "target/path");
        const auto sampler_index = index_at(channel, "sampler");
        const Json* const sampler =
            sampler_index ? element_at(animation, "samplers", *sampler_index) : nullptr;
        if (path != nullptr && *path == "rotation" && sampler != nullptr)
            check_rotations(asset, *sampler,
                            fmt::format("/animations/{}/channels/{}/sampler", index, c), done,
                            problems);
    }
}

}  // namespace

void check_bind_matrices(const Asset& asset, Problems& problems) {
    Done done;
    for (std::size_t s = 0; s < count_at(asset.json, "skins"); ++s) {
        const Accessor* const accessor =
            sound_accessor(asset, find(*element_at(asset.json, "skins", s), "inverseBindMatrices"));
        if (accessor == nullptr || accessor->components != 16) continue;
        const Json& index = *find(*element_at(asset.json, "skins", s), "inverseBindMatrices");
        if (!done.insert(index.dump()).second) continue;
        const std::vector<float> values = read_floats(*accessor);
        std::size_t told = 0;
        for (std::size_t i = 0; i < values.size() && told < 8; ++i) {
            if (i % 4 != 3 || values[i] == (i % 16 == 15 ? 1.0F : 0.0F)) continue;
            problems.error("ACCESSOR_INVALID_IBM", pointer_text("skins", s, "/inverseBindMatrices"),
                           "last row of a bind matrix is not 0 0 0 1",
                           fmt::format("{} at {}", values[i], i));
            ++told;
        }
    }
}

void check_keyframes(const Asset& asset, Problems& problems) {
    Done done;
    for (std::size_t i = 0; i < count_at(asset.json, "animations"); ++i)
        check_animation(asset, i, done, problems);
}

}  // namespace facet::scene::gltf
