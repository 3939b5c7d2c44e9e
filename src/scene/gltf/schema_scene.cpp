// Shapes of scenes, nodes, cameras, animations and of the document itself (glTF 2.0, chapter 5).
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

constexpr auto node_rules = std::to_array<Rule>(
    {{.name = "camera", .kind = Kind::integer, .refers_to = "cameras"},
     {.name = "children", .kind = Kind::integers, .is_unique = true, .refers_to = "nodes"},
     {.name = "skin", .kind = Kind::integer, .refers_to = "skins", .needs = "mesh"},
     {.name = "matrix", .kind = Kind::numbers, .lengths = "16"},
     {.name = "mesh", .kind = Kind::integer, .refers_to = "meshes"},
     {.name = "rotation", .kind = Kind::numbers, .low = -1, .high = 1, .lengths = "4"},
     {.name = "scale", .kind = Kind::numbers, .lengths = "3"},
     {.name = "translation", .kind = Kind::numbers, .lengths = "3"},
     {.name = "weights", .kind = Kind::numbers, .needs = "mesh"}});
constexpr ObjectShape node{.name = "node", .rules = node_rules};

constexpr auto scene_rules = std::to_array<Rule>(
    {{.name = "nodes", .kind = Kind::integers, .is_unique = true, .refers_to = "nodes"}});
constexpr ObjectShape scene{.name = "scene", .rules = scene_rules};

constexpr auto orthographic_rules = std::to_array<Rule>(
    {{.name = "xmag", .kind = Kind::number, .is_required = true},
     {.name = "ymag", .kind = Kind::number, .is_required = true},
     {.name = "zfar", .kind = Kind::number, .is_required = true, .low = 0, .excludes_low = true},
     {.name = "znear", .kind = Kind::number, .is_required = true, .low = 0}});
constexpr ObjectShape orthographic{.name = "cameraOrthographic", .rules = orthographic_rules};

constexpr auto perspective_rules = std::to_array<Rule>(
    {{.name = "aspectRatio", .kind = Kind::number, .low = 0, .excludes_low = true},
     {.name = "yfov", .kind = Kind::number, .is_required = true, .low = 0, .excludes_low = true},
     {.name = "zfar", .kind = Kind::number, .low = 0, .excludes_low = true},
     {.name = "znear", .kind = Kind::number, .is_required = true, .low = 0, .excludes_low = true}});
constexpr ObjectShape perspective{.name = "cameraPerspective", .rules = perspective_rules};

constexpr auto camera_rules =
    std::to_array<Rule>({{.name = "orthographic", .kind = Kind::object, .shape = &orthographic},
                         {.name = "perspective", .kind = Kind::object, .shape = &perspective},
                         {.name = "type",
                          .kind = Kind::string,
                          .is_required = true,
                          .words = "orthographic|perspective"}});
constexpr ObjectShape camera{.name = "camera", .rules = camera_rules};

constexpr auto target_rules =
    std::to_array<Rule>({{.name = "node", .kind = Kind::integer, .refers_to = "nodes"},
                         {.name = "path",
                          .kind = Kind::string,
                          .is_required = true,
                          .words = "translation|rotation|scale|weights|pointer"}});
constexpr ObjectShape target{.name = "animationChannelTarget", .rules = target_rules};

constexpr auto channel_rules = std::to_array<Rule>(
    {{.name = "sampler", .kind = Kind::integer, .is_required = true, .low = 0},
     {.name = "target", .kind = Kind::object, .is_required = true, .shape = &target}});
constexpr ObjectShape channel{.name = "animationChannel", .rules = channel_rules};

constexpr auto animation_sampler_rules = std::to_array<Rule>(
    {{.name = "input", .kind = Kind::integer, .is_required = true, .refers_to = "accessors"},
     {.name = "interpolation", .kind = Kind::string, .words = "LINEAR|STEP|CUBICSPLINE"},
     {.name = "output", .kind = Kind::integer, .is_required = true, .refers_to = "accessors"}});
constexpr ObjectShape animation_sampler{.name = "animationSampler",
                                        .rules = animation_sampler_rules};

constexpr auto animation_rules = std::to_array<Rule>(
    {{.name = "channels", .kind = Kind::objects, .is_required = true, .shape = &channel},
     {.name = "samplers",
      .kind = Kind::objects,
      .is_required = true,
      .shape = &animation_sampler}});
constexpr ObjectShape animation{.name = "animation", .rules = animation_rules};

constexpr auto asset_rules =
    std::to_array<Rule>({{.name = "copyright", .kind = Kind::string},
                         {.name = "generator", .kind = Kind::string},
                         {.name = "version", .kind = Kind::string, .is_required = true},
                         {.name = "minVersion", .kind = Kind::string}});
constexpr ObjectShape asset{.name = "asset", .rules = asset_rules};

}  // namespace

const ObjectShape& node_shape() { return node; }
const ObjectShape& scene_shape() { return scene; }
const ObjectShape& camera_shape() { return camera; }
const ObjectShape& animation_shape() { return animation; }

const ObjectShape& document_shape() {
    static const auto rules = std::to_array<Rule>(
        {{.name = "extensionsUsed", .kind = Kind::strings, .is_unique = true},
         {.name = "extensionsRequired",
          .kind = Kind::strings,
          .is_unique = true,
          .needs = "extensionsUsed"},
         {.name = "accessors", .kind = Kind::objects, .shape = &accessor_shape()},
         {.name = "animations", .kind = Kind::objects, .shape = &animation},
         {.name = "asset", .kind = Kind::object, .is_required = true, .shape = &asset},
         {.name = "buffers", .kind = Kind::objects, .shape = &buffer_shape()},
         {.name = "bufferViews", .kind = Kind::objects, .shape = &buffer_view_shape()},
         {.name = "cameras", .kind = Kind::objects, .shape = &camera},
         {.name = "images", .kind = Kind::objects, .shape = &image_shape()},
         {.name = "materials", .kind = Kind::objects, .shape = &material_shape()},
         {.name = "meshes", .kind = Kind::objects, .shape = &mesh_shape()},
         {.name = "nodes", .kind = Kind::objects, .shape = &node},
         {.name = "samplers", .kind = Kind::objects, .shape = &sampler_shape()},
         {.name = "scene", .kind = Kind::integer, .refers_to = "scenes"},
         {.name = "scenes", .kind = Kind::objects, .shape = &scene},
         {.name = "skins", .kind = Kind::objects, .shape = &skin_shape()},
         {.name = "textures", .kind = Kind::objects, .shape = &texture_shape()}});
    static const ObjectShape document{.name = "document", .rules = rules};
    return document;
}

}  // namespace facet::scene::gltf
