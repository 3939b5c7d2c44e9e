// Values of a scene by path.
// SPDX-License-Identifier: MIT
#include "scene/set_path.h"

#include "base/text.h"
#include "scene/light_spec.h"
#include "scene/set_texture.h"
#include "scene/spec.h"
#include "scene/tangents.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace facet::scene {
namespace {

/// `material.NAME.KEY` or `material[3].KEY`, taken apart.
struct Path {
    std::string room;  ///< "material" or "light"
    std::string name;  ///< "*" for all
    std::optional<long long> index;
    std::string key;
};

constexpr std::string_view path_help =
    "material.NAME.KEY, material.*.KEY, material[INDEX].KEY, or the same with light";

base::Result<Path> parse_path(std::string_view text) {
    const std::size_t dot = text.rfind('.');
    const std::size_t begin = text.find_first_of(".[");
    if (dot == std::string_view::npos || begin == std::string_view::npos)
        return usage_error("not a path", text, std::string(path_help));
    Path path{.room = std::string(text.substr(0, begin)), .name = {}, .index = {}, .key = {}};
    path.key = text.substr(dot + 1);
    std::replace(path.key.begin(), path.key.end(), '-', '_');
    const std::vector<std::string> rooms = {"material", "light"};
    if (std::find(rooms.begin(), rooms.end(), path.room) == rooms.end())
        return usage_error("nothing of this kind can be set", path.room,
                           suggestion(path.room, rooms));
    if (text[begin] == '[') {
        const std::size_t end = text.find(']', begin);
        if (end != std::string_view::npos)
            path.index = base::parse_integer(text.substr(begin + 1, end - begin - 1));
        if (!path.index || end + 1 != dot)
            return usage_error("not a path", text, std::string(path_help));
    } else if (dot > begin) {
        path.name = text.substr(begin + 1, dot - begin - 1);
    } else {
        return usage_error("path has no name", text, std::string(path_help));
    }
    return path;
}

/// Places in `names` that the path means. Errors: usage, with what there is.
base::Result<std::vector<std::size_t>> matches(const Path& path,
                                               const std::vector<std::string>& names) {
    if (names.empty())
        return usage_error(fmt::format("the scene has no {}s", path.room), path.name,
                           "leave this out");
    std::vector<std::size_t> out;
    if (path.index) {
        if (*path.index < 0 || static_cast<std::size_t>(*path.index) >= names.size())
            return usage_error(fmt::format("no {} of this index", path.room),
                               fmt::format("{}", *path.index),
                               fmt::format("0 to {}", names.size() - 1));
        return std::vector{static_cast<std::size_t>(*path.index)};
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (path.name == "*" || names[i] == path.name) out.push_back(i);
    if (out.empty())
        return usage_error(fmt::format("no {} of this name", path.room), path.name,
                           suggestion(path.name, names));
    return out;
}

base::Status set_field(Material& material, const tables::MaterialParam& param,
                       std::string_view value) {
    if (const auto* number = std::get_if<float tables::MaterialValues::*>(&param.field)) {
        const auto parsed = parse_in_range(param.key, value, param.range);
        if (!parsed) return tl::unexpected(parsed.error());
        material.values.** number = *parsed;
        return {};
    }
    const auto parsed = parse_color(param.key, value, param.range);
    if (!parsed) return tl::unexpected(parsed.error());
    material.values.*std::get<tables::Color tables::MaterialValues::*>(param.field) = *parsed;
    return {};
}

base::Status set_material_key(Material& material, std::string_view key, std::string_view value) {
    std::vector<std::string> keys;
    for (const tables::MaterialParam& param : tables::material_params) {
        if (param.key == key) return set_field(material, param, value);
        keys.emplace_back(param.key);
    }
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot) {
        const std::string_view name = tables::material_textures[slot].key;
        keys.emplace_back(name);
        if (name != key) continue;
        material.textures[slot].reset();  // other values are files: see apply_set()
        return {};
    }
    return usage_error("unknown key of a material", key, suggestion(key, keys));
}

template <class Thing>
std::vector<std::string> names_of(const std::vector<Thing>& things) {
    std::vector<std::string> names;
    for (const Thing& thing : things) names.push_back(thing.name);
    return names;
}

std::optional<std::size_t> texture_slot(std::string_view key) {
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot)
        if (tables::material_textures[slot].key == key) return slot;
    return std::nullopt;
}

/// Applies `set` to copies first: all of them change or none does.
template <class Thing>
base::Status set_all(std::vector<Thing>& things, const Path& path,
                     const std::function<base::Status(Thing&)>& set) {
    const auto found = matches(path, names_of(things));
    if (!found) return tl::unexpected(found.error());
    std::vector<Thing> changed;
    for (const std::size_t i : *found) {
        changed.push_back(things[i]);
        if (auto status = set(changed.back()); !status) return status;
    }
    for (std::size_t i = 0; i < found->size(); ++i) things[(*found)[i]] = std::move(changed[i]);
    return {};
}

}  // namespace

base::Status apply_set(Scene& scene, const std::string& assignment, const base::Limits& limits) {
    // The last one: names may hold anything, values never an equals sign.
    const std::size_t equals = assignment.rfind('=');
    if (equals == std::string::npos)
        return usage_error("not PATH=VALUE", assignment, "as material.Helmet.roughness=0.4");
    const auto path = parse_path(base::trimmed(std::string_view(assignment).substr(0, equals)));
    if (!path) return tl::unexpected(path.error());
    const std::string_view value = base::trimmed(std::string_view(assignment).substr(equals + 1));
    const auto placed = [&](base::Error error) {
        error.where = assignment.substr(0, equals);
        return error;
    };
    const auto slot = path->room == "material" ? texture_slot(path->key) : std::nullopt;
    if (slot && value != "none") {
        const auto found = matches(*path, names_of(scene.materials));
        if (!found) return tl::unexpected(placed(found.error()));
        return set_texture(scene, *found, *slot, std::string(value), limits).map_error(placed);
    }
    if (path->room == "material") {
        const auto set = set_all<Material>(scene.materials, *path, [&](Material& m) {
            return set_material_key(m, path->key, value);
        });
        if (!set) return tl::unexpected(placed(set.error()));
        generate_missing_tangents(scene);
        return {};
    }
    return set_all<Light>(scene.lights, *path,
                          [&](Light& light) { return set_light_key(light, path->key, value); })
        .map_error(placed);
}

}  // namespace facet::scene
