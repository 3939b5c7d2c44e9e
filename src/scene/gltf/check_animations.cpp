// Checks of animations: samplers and channels that fit what they move.
// SPDX-License-Identifier: MIT
#include "scene/gltf/attributes.h"
#include "scene/gltf/check.h"

#include <spdlog/fmt/fmt.h>

#include <map>

namespace facet::scene::gltf {
namespace {

/// An accessor of the animation, where its shape is known.
const Accessor* accessor_of(const Asset& asset, const Json& object, const char* key) {
    const auto index = index_at(object, key);
    if (!index || *index >= asset.accessors.size() || asset.accessors[*index].components == 0)
        return nullptr;
    return &asset.accessors[*index];
}

void check_sampler(const Asset& asset, const Json& sampler, const std::string& where,
                   Problems& problems) {
    for (const char* const key : {"input", "output"}) {
        const auto index = index_at(sampler, key);
        const Json* const accessor = index ? element_at(asset.json, "accessors", *index) : nullptr;
        const auto view = accessor != nullptr ? index_at(*accessor, "bufferView") : std::nullopt;
        const Json* const view_json = view ? element_at(asset.json, "bufferViews", *view) : nullptr;
        if (view_json != nullptr && find(*view_json, "byteStride") != nullptr)
            problems.error("ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", where + "/" + key,
                           "animation data in a buffer view with a stride");
    }
    const Accessor* const input = accessor_of(asset, sampler, "input");
    if (input == nullptr) return;
    const std::string at = where + "/input";
    if (format_of(*input) != "SCALAR f32")
        problems.error("ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", at,
                       "wrong format for times", format_of(*input));
    const Json& json = *element_at(asset.json, "accessors", *index_at(sampler, "input"));
    if (find(json, "min") == nullptr || find(json, "max") == nullptr)
        problems.error("ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", at,
                       "times without min and max");
    if (string_at(sampler, "interpolation") == "CUBICSPLINE" && input->count < 2)
        problems.error("ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", at,
                       "a cubic spline needs two times or more", std::to_string(input->count));
}

/// One channel and what it moves.
struct Moving {
    const Asset& asset;
    const Json& animation;
    const Json& channel;
    std::string where;
    Problems& problems;
    std::string path;
};

std::size_t morph_count(const Json& json, const Json& node) {
    const auto index = index_at(node, "mesh");
    const Json* const mesh = index ? element_at(json, "meshes", *index) : nullptr;
    const Json* const primitive = mesh != nullptr ? element_at(*mesh, "primitives", 0) : nullptr;
    return primitive != nullptr ? count_at(*primitive, "targets") : 0;
}

const Json* target_node(const Moving& m) {
    const Json* const target = find(m.channel, "target");
    const auto index = target != nullptr ? index_at(*target, "node") : std::nullopt;
    return index ? element_at(m.asset.json, "nodes", *index) : nullptr;
}

void check_target(Moving& m) {
    const Json* const node = target_node(m);
    if (node == nullptr) return;
    const std::string at = m.where + "/target";
    const bool is_trs = m.path == "translation" || m.path == "rotation" || m.path == "scale";
    if (is_trs && find(*node, "matrix") != nullptr)
        m.problems.error("ANIMATION_CHANNEL_TARGET_NODE_MATRIX", at,
                         "a node with a matrix cannot be animated", m.path);
    if (is_trs && find(*node, "skin") != nullptr && find(*node, "mesh") != nullptr)
        m.problems.note(Severity::warning, "ANIMATION_CHANNEL_TARGET_NODE_SKIN", at + "/path",
                        "a skinned mesh is not moved by its own node");
    if (m.path == "weights" && morph_count(m.asset.json, *node) == 0)
        m.problems.error("ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", at,
                         "animates weights of a mesh without morph targets");
}

void check_pointer(Moving& m) {
    const Json* const target = find(m.channel, "target");
    const Json* const extension =
        target != nullptr ? find_path(*target, "extensions/KHR_animation_pointer") : nullptr;
    const std::string at = m.where + "/target/extensions/KHR_animation_pointer";
    if (extension == nullptr) {
        if (m.path == "pointer")
            m.problems.note(Severity::warning, "VALUE_NOT_IN_LIST", m.where + "/target/path",
                            "not a known value", m.path);
        return;
    }
    if (find(*target, "node") != nullptr)
        m.problems.error("KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE", at,
                         "target must have no node");
    if (m.path != "pointer")
        m.problems.error("KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH", at,
                         "target's path must be 'pointer'", m.path);
    const std::string pointer = string_at(*extension, "pointer");
    if (!pointer.empty() && pointer[0] != '/')
        m.problems.error("PATTERN_MISMATCH", at + "/pointer", "not a JSON pointer",
                         pointer.substr(0, 80));
}

std::string_view output_formats(std::string_view path) {
    if (path == "translation" || path == "scale") return "VEC3 f32";
    if (path == "rotation") return "VEC4 f32 VEC4 i8n VEC4 u8n VEC4 i16n VEC4 u16n";
    if (path == "weights") return "SCALAR f32 SCALAR i8n SCALAR u8n SCALAR i16n SCALAR u16n";
    return {};
}

void check_output(Moving& m) {
    const auto index = index_at(m.channel, "sampler");
    const Json* const sampler = index ? element_at(m.animation, "samplers", *index) : nullptr;
    if (sampler == nullptr) return;
    const Accessor* const input = accessor_of(m.asset, *sampler, "input");
    const Accessor* const output = accessor_of(m.asset, *sampler, "output");
    const std::string_view formats = output_formats(m.path);
    if (output == nullptr || formats.empty()) return;
    if (formats.find(format_of(*output)) == std::string_view::npos)
        m.problems.error("ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", m.where + "/sampler",
                         "wrong format for what the channel moves",
                         fmt::format("{} for {}", format_of(*output), m.path));
    if (input == nullptr) return;
    const Json* const node = target_node(m);
    const std::size_t morphs = node != nullptr ? morph_count(m.asset.json, *node) : 0;
    const std::size_t per_key = m.path == "weights" ? morphs : 1;
    const std::size_t per_time = string_at(*sampler, "interpolation") == "CUBICSPLINE" ? 3 : 1;
    const std::size_t expected = input->count * per_key * per_time;
    if (expected != 0 && output->count != expected)
        m.problems.error("ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", m.where + "/sampler",
                         "number of values does not fit the times",
                         fmt::format("{}, not {}", output->count, expected));
}

void check_animation(const Asset& asset, std::size_t index, Problems& problems) {
    const Json& animation = *element_at(asset.json, "animations", index);
    for (std::size_t s = 0; s < count_at(animation, "samplers"); ++s)
        check_sampler(asset, *element_at(animation, "samplers", s),
                      fmt::format("/animations/{}/samplers/{}", index, s), problems);
    std::map<std::string, std::size_t> targets;
    for (std::size_t c = 0; c < count_at(animation, "channels"); ++c) {
        const Json& channel = *element_at(animation, "channels", c);
        const std::string where = fmt::format("/animations/{}/channels/{}", index, c);
        const Json* const target = find(channel, "target");
        if (target == nullptr) continue;
        Moving moving{asset, animation, channel, where, problems, string_at(*target, "path")};
        check_target(moving);
        check_pointer(moving);
        check_output(moving);
        const auto sampler = unsigned_at(channel, "sampler");
        if (sampler && *sampler >= count_at(animation, "samplers"))
            problems.error(
                "UNRESOLVED_REFERENCE", where + "/sampler", "no such sampler of the animation",
                fmt::format("{}, but there are {}", *sampler, count_at(animation, "samplers")));
        const auto node = index_at(*target, "node");
        if (!node) continue;
        const auto [first, is_new] = targets.emplace(fmt::format("{} {}", *node, moving.path), c);
        if (!is_new)
            problems.error("ANIMATION_DUPLICATE_TARGETS", where + "/target",
                           "two channels move the same thing",
                           fmt::format("channel {} too", first->second));
    }
}

}  // namespace

void check_animations(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < count_at(asset.json, "animations"); ++i)
        check_animation(asset, i, problems);
}

}  // namespace facet::scene::gltf
