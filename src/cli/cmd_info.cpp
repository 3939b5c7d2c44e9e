// facet info: what is in a scene.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "base/thread_pool.h"
#include "cli/flags.h"
#include "cli/scene_options.h"
#include "scene/load.h"
#include "scene/rig.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <memory>

namespace facet::cli {
namespace {

using base::Result;
using Json = nlohmann::ordered_json;

struct InfoOptions {
    std::string scene;
    TypedSettings typed;
};

/// A float as its own shortest decimals; as a double it would trail digits that nobody set.
Json number(float value) { return base::parse_number(fmt::format("{}", value)).value_or(0.0); }
Json vector_object(const math::Vec3& v) {
    return Json::array({number(v.x), number(v.y), number(v.z)});
}

std::string_view name_of(scene::AlphaMode mode) {
    constexpr std::string_view names[] = {"opaque", "mask", "blend"};
    return names[static_cast<std::size_t>(mode)];
}

/// The numbers of a material by the table's keys, and the images its textures use.
Json material_object(const scene::Material& material, const scene::Scene& scene) {
    Json out{{"name", material.name}, {"alpha_mode", name_of(material.alpha_mode)}};
    for (const auto& param : tables::material_params) {
        const auto key = std::string(param.key);
        if (const auto* scalar = std::get_if<float tables::MaterialValues::*>(&param.field))
            out[key] = number(material.values.**scalar);
        else
            out[key] = vector_object(
                material.values.*std::get<tables::Color tables::MaterialValues::*>(param.field));
    }
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot)
        if (const auto& texture = material.textures[slot];
            texture && texture->image.index < scene.images.size())
            out[std::string(tables::material_textures[slot].key)] =
                scene.images[texture->image.index].name;
    out["double_sided"] = material.double_sided;
    out["unlit"] = material.unlit;
    return out;
}

Json camera_object(const scene::Camera& camera) {
    Json out{{"name", camera.name}, {"node", camera.node}};
    if (camera.projection == scene::Projection::perspective) {
        out["projection"] = "perspective";
        out["fov"] = number(camera.yfov_rad * 180.0F / math::pi);
    } else {
        out["projection"] = "orthographic";
        out["ymag"] = number(camera.ymag_m);
    }
    return out;
}

Json clip_object(const scene::Clip& clip) {
    Json out = {{"name", clip.name}, {"seconds", number(clip.end_s)}};
    if (clip.fault) out["broken"] = true;
    return out;
}

Json light_object(const scene::Light& light) {
    const auto& row = tables::light_kinds[static_cast<std::size_t>(light.kind)];
    return {{"name", light.name},
            {"kind", row.key},
            {std::string(row.unit), number(light.intensity)},
            {"color", vector_object(light.color)}};
}

Json texture_object(const scene::SceneImage& image) {
    Json out{{"name", image.name}};
    if (image.pixels)
        out.update(
            Json{{"width", image.pixels->size.width}, {"height", image.pixels->size.height}});
    return out;
}

Json describe(const std::string& path, const scene::Scene& scene) {
    const math::Bounds bounds = scene.bounds_m();
    Json out{{"facet", 1},
             {"path", path},
             {"name", scene.name},
             {"triangles", scene.triangle_count()},
             {"meshes", scene.meshes.size()},
             {"instances", scene.instances.size()}};
    if (!bounds.is_empty())
        out["extent"] = {{"low", vector_object(bounds.low)},
                         {"high", vector_object(bounds.high)},
                         {"size", vector_object(bounds.high - bounds.low)}};
    for (const char* list : {"materials", "textures", "cameras", "lights", "clips"})
        out[list] = Json::array();
    for (const auto& material : scene.materials)
        out["materials"].push_back(material_object(material, scene));
    for (const auto& image : scene.images) out["textures"].push_back(texture_object(image));
    for (const auto& camera : scene.cameras) out["cameras"].push_back(camera_object(camera));
    for (const auto& light : scene.lights) out["lights"].push_back(light_object(light));
    if (scene.rig != nullptr)
        for (const scene::Clip& clip : scene.rig->clips) out["clips"].push_back(clip_object(clip));
    out["variants"] = scene.variants;
    out["extensions"] = scene.extensions_used;
    return out;
}

/// One object as a line a person reads: its name, then `key value` for the rest.
/// What is as in `usual` is left out, so that what matters is seen.
std::string line_of(const Json& object, std::size_t index, const Json& usual) {
    std::string out = fmt::format("  [{}] {}", index, base::escaped(object.value("name", ""), 60));
    for (const auto& [key, value] : object.items()) {
        if (key == "name" || (value.is_boolean() && !value.get<bool>())) continue;
        if (usual.contains(key) && usual[key] == value) continue;
        const std::string text =
            value.is_string() ? base::escaped(value.get<std::string>(), 60) : value.dump();
        if (!text.empty())
            out += fmt::format("  {}{}{}", key, value.is_boolean() ? "" : " ",
                               value.is_boolean() ? "" : text);
    }
    return out;
}

void print_lists(const Json& info, Io& io) {
    const Json usual = material_object({}, {});
    for (const char* list : {"materials", "textures", "cameras", "lights", "clips"}) {
        io.print(fmt::format("{:<11} {}", list, info[list].size()));
        for (std::size_t i = 0; i < info[list].size(); ++i)
            io.print(line_of(info[list][i], i, usual));
    }
    for (const char* list : {"variants", "extensions"}) {
        std::vector<std::string> names;
        for (const auto& name : info[list]) names.push_back(base::escaped(name.get<std::string>()));
        io.print(fmt::format("{:<11} {}{}", list, names.size(),
                             names.empty() ? "" : "  " + base::join(names, ", ")));
    }
}

void print_text(const Json& info, const math::Bounds& bounds, Io& io) {
    io.print(base::escaped(info["path"].get<std::string>(), 4096));
    io.print(fmt::format("{:<11} {} in {} meshes, placed {} times", "triangles",
                         info["triangles"].dump(), info["meshes"].dump(),
                         info["instances"].dump()));
    if (bounds.is_empty()) {
        io.print("extent      empty");
    } else {
        const math::Vec3 size = bounds.high - bounds.low;
        io.print(fmt::format(
            "{:<11} {:.4g} x {:.4g} x {:.4g} m, from {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g}",
            "extent", size.x, size.y, size.z, bounds.low.x, bounds.low.y, bounds.low.z,
            bounds.high.x, bounds.high.y, bounds.high.z));
    }
    print_lists(info, io);
}

Result<Exit> run_info(const InfoOptions& options, Io& io) {
    if (options.scene.empty())
        return base::fail({.code = base::ErrorCode::usage,
                           .what = "no scene given",
                           .remedy = "facet info SCENE"});
    const auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    base::ThreadPool pool(1);
    const auto loaded =
        scene::load(options.scene, load_options(*settings), limits_of(*settings), pool);
    if (!loaded) return tl::unexpected(base::in_file(loaded.error(), options.scene));
    io.warn(loaded->warnings);
    const Json info = describe(options.scene, loaded->scene);
    if (io.json)
        io.print_object(info);
    else
        print_text(info, loaded->scene.bounds_m(), io);
    return Exit::done;
}

}  // namespace

void add_info(Declaration& command) {
    auto options = std::make_shared<InfoOptions>();
    command.flags.push_back({"SCENE", &options->scene, "", "", ".gltf, .glb or builtin:NAME"});
    options->typed.declare(command.flags, concerns_loading);
    command.job = [options](Io& io) { return run_info(*options, io); };
}

}  // namespace facet::cli
