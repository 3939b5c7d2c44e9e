// Animations: every sampler checked and decoded, what is wrong kept beside the clip it is in.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "scene/gltf/attributes.h"
#include "scene/gltf/elements.h"
#include "scene/gltf/import.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

/// Errors of the specification that leave an animation playable.
constexpr auto playable = std::to_array<std::string_view>(
    {"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE",  // elements are read by their stride
     "ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS",
     "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS"});

tl::unexpected<base::Error> broken(std::string where, std::string what, std::string found = {}) {
    return base::fail({.code = ErrorCode::input_invalid,
                       .where = std::move(where),
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = "export the model again"});
}

/// The clip that a pointer leads into.
std::optional<std::size_t> clip_at(std::string_view pointer) {
    constexpr std::string_view before = "/animations/";
    if (!pointer.starts_with(before)) return std::nullopt;
    pointer.remove_prefix(before.size());
    const auto number = base::parse_integer(pointer.substr(0, pointer.find('/')));
    if (!number || *number < 0) return std::nullopt;
    return static_cast<std::size_t>(*number);
}

/// By clip: the first thing in the document that keeps it from being played; null where none does.
std::vector<const Problem*> faults_of(const Problems& problems, std::size_t clip_count) {
    std::vector<const Problem*> first(clip_count, nullptr);
    for (const Problem& problem : problems.all()) {
        if (problem.severity != Severity::error ||
            problem.code.starts_with("KHR_ANIMATION_POINTER") ||
            std::find(playable.begin(), playable.end(), problem.code) != playable.end())
            continue;
        const auto clip = clip_at(problem.pointer);
        if (clip && *clip < clip_count && first[*clip] == nullptr) first[*clip] = &problem;
    }
    return first;
}

base::Result<const Accessor*> find_accessor(const Import& import, const Json& sampler,
                                            const char* key, const std::string& where) {
    const auto index = index_at(sampler, key);
    const auto& accessors = import.asset.accessors;
    if (!index || *index >= accessors.size() || !accessors[*index].is_sound)
        return broken(where + "/" + key, "the animation's data cannot be read");
    return &accessors[*index];
}

base::Status check_rising(const std::vector<float>& times, const std::string& where) {
    for (std::size_t i = 1; i < times.size(); ++i)
        if (!(times[i] > times[i - 1]))
            return broken(where, "times do not increase",
                          fmt::format("{} at {} after {}", times[i], i, times[i - 1]));
    return {};
}

base::Result<Interpolation> interpolation_of(const Json& sampler, const std::string& where) {
    if (find(sampler, "interpolation") == nullptr) return Interpolation::linear;
    const std::string name = string_at(sampler, "interpolation");
    if (name == "STEP") return Interpolation::step;
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    return broken(where + "/interpolation", "no such interpolation", brief(sampler));
}

base::Result<Keyframes> read_keyframes(Import& import, const Json& sampler,
                                       const std::string& where) {
    const auto input = find_accessor(import, sampler, "input", where);
    if (!input) return tl::unexpected(input.error());
    const auto output = find_accessor(import, sampler, "output", where);
    if (!output) return tl::unexpected(output.error());
    const auto interpolation = interpolation_of(sampler, where);
    if (!interpolation) return tl::unexpected(interpolation.error());
    if (format_of(**input) != "SCALAR f32")
        return broken(where + "/input", "wrong format for times", format_of(**input));
    // Samplers may share accessors without end.
    const std::size_t value_count = (*output)->count * (*output)->components;
    if (auto taken = import.take_memory(((*input)->count + value_count) * sizeof(float), where);
        !taken)
        return tl::unexpected(taken.error());
    Keyframes out{.interpolation = *interpolation,
                  .times_s = read_floats(**input),
                  .values = read_floats(**output)};
    if (auto s = check_finite(out.times_s, where + "/input"); !s) return tl::unexpected(s.error());
    if (auto s = check_rising(out.times_s, where + "/input"); !s) return tl::unexpected(s.error());
    if (auto s = check_finite(out.values, where + "/output"); !s) return tl::unexpected(s.error());
    const std::size_t rows =
        out.times_s.size() * (out.interpolation == Interpolation::cubic ? 3 : 1);
    out.width = rows == 0 ? 0 : value_count / rows;
    if (out.width == 0 || out.width * rows != value_count)
        return broken(where + "/output", "number of values does not fit the times",
                      fmt::format("{} for {} times", (*output)->count, out.times_s.size()));
    return out;
}

base::Result<Moves> moves_of(const std::string& path, const std::string& where) {
    if (path == "translation") return Moves::translation;
    if (path == "rotation") return Moves::rotation;
    if (path == "scale") return Moves::scale;
    if (path == "weights") return Moves::weights;
    return broken(where + "/target/path", "an animation moves nothing of that name", path);
}

/// Floats of a value.
std::size_t width_of(Moves what, const tinygltf::Model& model, std::size_t node) {
    if (what != Moves::weights) return what == Moves::rotation ? 4 : 3;
    const int mesh = model.nodes[node].mesh;
    if (mesh < 0) return 0;
    std::size_t most = 0;
    for (const auto& primitive : model.meshes[static_cast<std::size_t>(mesh)].primitives)
        most = std::max(most, primitive.targets.size());
    return most;
}

/// One clip, channel by channel.
class ClipReader {
public:
    ClipReader(Import& import, const Json& json, std::string where, Clip& clip)
        : import_(import), json_(json), where_(std::move(where)), clip_(clip) {}

    [[nodiscard]] base::Status read() {
        for (std::size_t c = 0; c < count_at(json_, "channels"); ++c)
            if (auto read = read_channel(c); !read) return read;
        return {};
    }

private:
    base::Status read_channel(std::size_t index) {
        const Json& channel = *element_at(json_, "channels", index);
        const std::string where = fmt::format("{}/channels/{}", where_, index);
        const Json* const target = find(channel, "target");
        if (target == nullptr || find_path(*target, "extensions/KHR_animation_pointer") != nullptr)
            return {};
        const auto what = moves_of(string_at(*target, "path"), where);
        if (!what) return base::fail(what.error());
        const auto node = index_at(*target, "node");
        if (!node) return {};  // for extensions (glTF 2.0, section 3.11)
        if (*node >= import_.model.nodes.size())
            return broken(where + "/target/node", "no such node", std::to_string(*node));
        const auto keyframes = keyframes_of(channel, where);
        if (!keyframes) return base::fail(keyframes.error());
        const std::size_t width = width_of(*what, import_.model, *node);
        if (width == 0) return {};  // nothing there that it could move
        if (clip_.keyframes[*keyframes].width != width)
            return broken(where + "/sampler", "number of values does not fit the times");
        clip_.channels.push_back({*node, *what, *keyframes});
        return {};
    }

    /// Each sampler is read once.
    base::Result<std::size_t> keyframes_of(const Json& channel, const std::string& where) {
        const auto index = index_at(channel, "sampler");
        const Json* const sampler = index ? element_at(json_, "samplers", *index) : nullptr;
        if (sampler == nullptr) return broken(where + "/sampler", "no such sampler");
        const auto [known, is_new] = read_.try_emplace(*index, clip_.keyframes.size());
        if (!is_new) return known->second;
        auto keyframes =
            read_keyframes(import_, *sampler, fmt::format("{}/samplers/{}", where_, *index));
        if (!keyframes) return tl::unexpected(keyframes.error());
        clip_.end_s = std::max(clip_.end_s, keyframes->times_s.back());
        clip_.keyframes.push_back(std::move(*keyframes));
        return known->second;
    }

    Import& import_;
    const Json& json_;
    std::string where_;
    Clip& clip_;
    std::map<std::size_t, std::size_t> read_;
};

}  // namespace

std::vector<Clip> read_clips(Import& import, const Problems& problems) {
    std::vector<Clip> clips(count_at(import.asset.json, "animations"));
    const std::vector<const Problem*> faults = faults_of(problems, clips.size());
    for (std::size_t i = 0; i < clips.size(); ++i) {
        Clip& clip = clips[i];
        clip.name = import.scene.animations[i];
        if (faults[i] != nullptr) {
            clip.fault = to_error(*faults[i]);
            continue;  // the checks' warning tells of it
        }
        const std::string where = pointer_text("animations", i);
        const Json& json = *element_at(import.asset.json, "animations", i);
        if (const auto read = ClipReader(import, json, where, clip).read(); !read) {
            clip.fault = read.error();
            import.warn(clip.fault->where, clip.fault->what, clip.fault->found);
        }
        if (clip.fault) clip.channels.clear();
    }
    return clips;
}

}  // namespace facet::scene::gltf
