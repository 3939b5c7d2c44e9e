// Whether the settings of an item make sense, before its scene is read.
// SPDX-License-Identifier: MIT
#include "batch/group.h"
#include "render/plan.h"
#include "scene/camera_spec.h"
#include "scene/environment.h"
#include "scene/light_spec.h"
#include "scene/material_file.h"
#include "scene/set_path.h"

namespace facet::batch {
namespace {

/// A scene of one material stands for any; lights and textures need the real one.
base::Status check_set(const std::string& assignment) {
    const std::size_t equals = assignment.rfind('=');
    const std::string path = assignment.substr(0, equals);
    if (path.starts_with("light.") || path.starts_with("light[") || path.ends_with("texture"))
        return {};
    scene::Scene any;
    any.materials.emplace_back();
    const bool is_material = path.starts_with("material.") || path.starts_with("material[");
    const std::size_t dot = path.rfind('.');
    const bool has_key = is_material && equals != std::string::npos && dot != std::string::npos;
    return scene::apply_set(any, has_key ? "material.*" + assignment.substr(dot) : assignment)
        .map_error([&](auto error) {
            error.where = path;
            return error;
        });
}

base::Status check_environment(const std::string& env) {
    const auto file = scene::environment_file(env);
    if (!file) return tl::unexpected(base::in_file(file.error(), "--env"));
    return {};
}

}  // namespace

base::Status check_settings(const tables::Settings& settings, const base::Limits& limits) {
    if (const auto plan = render::make_plan(settings); !plan) return tl::unexpected(plan.error());
    if (auto s = check_environment(settings.env); !s) return s;
    for (const std::string& light : settings.light)
        if (const auto parsed = scene::parse_light(light); !parsed)
            return tl::unexpected(base::in_file(parsed.error(), "--light"));
    for (const std::string& text : settings.material) {
        const std::size_t equals = text.rfind('=');
        if (equals == std::string::npos) continue;  // apply_material_setting() says it
        const auto preset = scene::load_material(text.substr(equals + 1), limits);
        if (!preset) return tl::unexpected(base::in_file(preset.error(), "--material"));
    }
    for (const std::string& text : settings.set)
        if (auto s = check_set(text); !s) return s;
    if (!scene::is_orbit(settings.camera)) return {};
    const auto camera = scene::resolve_camera({}, settings.camera, settings.fov, settings.size);
    if (!camera) return tl::unexpected(base::in_file(camera.error(), "--camera"));
    return {};
}

}  // namespace facet::batch
