// Materials as small JSON files.
// SPDX-License-Identifier: MIT
#include "scene/material_file.h"

#include "base/file.h"
#include "base/json.h"
#include "base/resources.h"
#include "base/text.h"
#include "scene/gltf/json.h"
#include "scene/spec.h"
#include "scene/tangents.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::scene {
namespace {

namespace fs = std::filesystem;
using gltf::Json;

constexpr std::array<std::string_view, 3> alpha_modes = {"opaque", "mask", "blend"};
constexpr std::size_t most_bytes = std::size_t{1} << 20;

tl::unexpected<base::Error> invalid(std::string where, std::string what, const Json& found,
                                    std::string remedy = {}) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = "/" + std::move(where),
                       .what = std::move(what),
                       .found = gltf::brief(found),
                       .remedy = std::move(remedy)});
}

base::Result<float> number_of(const tables::MaterialParam& param, const Json& value) {
    const std::string range = fmt::format("{} to {}", param.range.low, param.range.high);
    if (!value.is_number()) return invalid(std::string(param.key), "not a number", value, range);
    const double number = value.get<double>();
    if (!(number >= param.range.low && number <= param.range.high))
        return invalid(std::string(param.key), "out of range", value, range);
    return static_cast<float>(number);
}

base::Status read_param(const tables::MaterialParam& param, const Json& value,
                        tables::MaterialValues& values) {
    if (const auto* field = std::get_if<float tables::MaterialValues::*>(&param.field)) {
        const auto number = number_of(param, value);
        if (!number) return tl::unexpected(number.error());
        values.** field = *number;
        return {};
    }
    if (!value.is_array() || value.size() != 3)
        return invalid(std::string(param.key), "not three numbers", value, "[r, g, b], linear");
    math::Vec3 color;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = number_of(param, value[i]);
        if (!number) return tl::unexpected(number.error());
        color[static_cast<int>(i)] = *number;
    }
    values.*std::get<tables::Color tables::MaterialValues::*>(param.field) = color;
    return {};
}

base::Status read_alpha_mode(const Json& value, MaterialFile& file) {
    const auto found = value.is_string() ? std::find(alpha_modes.begin(), alpha_modes.end(),
                                                     value.get<std::string>())
                                         : alpha_modes.end();
    if (found == alpha_modes.end())
        return invalid("alpha_mode", "no such mode", value, "opaque, mask or blend");
    file.alpha_mode = static_cast<AlphaMode>(found - alpha_modes.begin());
    return {};
}

/// One member of the document.
base::Status read_member(const std::string& key, const Json& value, MaterialFile& file) {
    if (key == "facet")
        return value == 1 ? base::Status{}
                          : invalid(key, "not a version that is known", value, "1");
    if (key == "name" || key == "source") {
        if (!value.is_string()) return invalid(key, "not a text", value);
        (key == "name" ? file.name : file.source) = value.get<std::string>();
        return {};
    }
    if (key == "alpha_mode") return read_alpha_mode(value, file);
    if (key == "double_sided") {
        if (!value.is_boolean()) return invalid(key, "neither true nor false", value);
        file.double_sided = value.get<bool>();
        return {};
    }
    std::vector<std::string> keys = {"facet", "name", "source", "alpha_mode", "double_sided"};
    for (const tables::MaterialParam& param : tables::material_params) {
        keys.emplace_back(param.key);
        if (param.key != key) continue;
        file.given.push_back(param.key);
        return read_param(param, value, file.values);
    }
    return invalid(key, "unknown key", value, suggestion(key, keys));
}

base::Result<fs::path> presets_folder() {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    return *folder / "resources" / "materials";
}

}  // namespace

base::Result<MaterialFile> parse_material(std::string_view text, const base::Limits& limits) {
    const auto json = base::parse_json<gltf::Json>(text, limits);
    if (!json) return tl::unexpected(json.error());
    if (!json->is_object()) return invalid("", "not an object", *json);
    if (!json->contains("facet")) return invalid("facet", "is missing", Json(), "1");
    MaterialFile file;
    for (const auto& [key, value] : json->items())
        if (auto read = read_member(key, value, file); !read) return tl::unexpected(read.error());
    return file;
}

std::string material_text(const Material& material) {
    nlohmann::ordered_json json = {{"facet", 1}, {"name", material.name}};
    const auto shortest = [](float value) {
        return base::parse_number(fmt::format("{}", value)).value_or(0.0);
    };
    for (const tables::MaterialParam& param : tables::material_params) {
        const std::string key(param.key);
        if (const auto* field = std::get_if<float tables::MaterialValues::*>(&param.field)) {
            json[key] = shortest(material.values.**field);
            continue;
        }
        const math::Vec3& color =
            material.values.*std::get<tables::Color tables::MaterialValues::*>(param.field);
        json[key] = {shortest(color.x), shortest(color.y), shortest(color.z)};
    }
    json["alpha_mode"] = alpha_modes[static_cast<std::size_t>(material.alpha_mode)];
    json["double_sided"] = material.double_sided;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void apply_material(const MaterialFile& file, Material& material) {
    for (const tables::MaterialParam& param : tables::material_params)
        if (std::find(file.given.begin(), file.given.end(), param.key) != file.given.end())
            std::visit([&](auto field) { material.values.*field = file.values.*field; },
                       param.field);
    for (auto& texture : material.textures) texture.reset();
    if (file.alpha_mode) material.alpha_mode = *file.alpha_mode;
    if (file.double_sided) material.double_sided = *file.double_sided;
}

std::vector<std::string> material_presets() {
    std::vector<std::string> names;
    const auto folder = presets_folder();
    if (!folder) return names;
    std::error_code error;
    for (fs::directory_iterator at(*folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".json") names.push_back(at->path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

base::Result<MaterialFile> load_material(const std::string& name, const base::Limits& limits) {
    fs::path path(name);
    if (!name.ends_with(".json")) {
        const auto names = material_presets();
        if (std::find(names.begin(), names.end(), name) == names.end())
            return usage_error("no such preset of --list materials", name, suggestion(name, names));
        path = *presets_folder() / (name + ".json");
    }
    const auto bytes = base::read_file(path, std::min(most_bytes, limits.file_bytes));
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), name));
    auto file =
        parse_material({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, limits);
    if (!file) return tl::unexpected(base::in_file(file.error(), name));
    return file;
}

base::Status apply_material_setting(Scene& scene, const std::string& assignment,
                                    const base::Limits& limits) {
    const std::size_t equals = assignment.rfind('=');
    if (equals == std::string::npos)
        return usage_error("not NAME=PRESET", assignment, "as Helmet=gold, --list materials");
    const std::string name(base::trimmed(std::string_view(assignment).substr(0, equals)));
    const auto file = load_material(
        std::string(base::trimmed(std::string_view(assignment).substr(equals + 1))), limits);
    if (!file) return tl::unexpected(file.error());
    bool any = false;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& material = scene.materials[i];
        names.push_back(material.name);
        if (name != "*" && name != material.name && name != fmt::format("[{}]", i)) continue;
        apply_material(*file, material);
        any = true;
    }
    if (any) {
        generate_missing_tangents(scene);
        return {};
    }
    return usage_error("no material of this name", name, suggestion(name, names));
}

}  // namespace facet::scene
