// tinygltf behind a gate; the only place where its code is compiled.
// SPDX-License-Identifier: MIT
#include <fstream>  // tinygltf names it even where it opens nothing

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/model.h"

#include <array>
#include <exception>
#include <limits>
#include <string>
#include <string_view>

namespace facet::scene::gltf {
namespace {

/// What tinygltf is given; extras are left out too, as it copies them by recursion.
constexpr auto kept =
    std::to_array<std::string_view>({"asset", "scene", "scenes", "nodes", "meshes", "materials",
                                     "textures", "samplers", "cameras"});

bool no_such_file(const std::string&, void*) { return false; }
std::string same_path(const std::string& path, void*) { return path; }
bool read_nothing(std::vector<unsigned char>*, std::string* error, const std::string&, void*) {
    if (error != nullptr) *error = "nothing is read through tinygltf";
    return false;
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}
bool keep_no_image(tinygltf::Image*, int, std::string*, std::string*, int, int,
                   const unsigned char*, int, void*) {
    return true;
}

void drop_extras(Json& value) {  // depth is bounded by the parse
    if (value.is_object()) value.erase("extras");
    if (value.is_structured())
        for (Json& child : value) drop_extras(child);
}

std::string reduced_text(const Json& json) {
    Json reduced = Json::object();
    for (const std::string_view name : kept)
        if (const Json* const part = find(json, name)) reduced[std::string(name)] = *part;
    if (const Json* const lights = find_path(json, "extensions/KHR_lights_punctual"))
        reduced["extensions"]["KHR_lights_punctual"] = *lights;
    // tinygltf refuses indices whose accessor has no buffer view, which glTF allows: it gets a view
    // to see.
    const Json stand_in = {
        {"bufferView", 0}, {"componentType", 5121}, {"count", 1}, {"type", "SCALAR"}};
    reduced["accessors"] = Json(count_at(json, "accessors"), stand_in);
    reduced["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 1}}});
    drop_extras(reduced);
    return reduced.dump(-1, ' ', false, Json::error_handler_t::replace);
}

base::Result<tinygltf::Model> refuse(std::string reason) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .what = "tinygltf cannot read the document",
                       .found = std::move(reason)});
}

}  // namespace

base::Result<tinygltf::Model> parse_model(const Json& json) {
    const std::string text = reduced_text(json);
    if (text.size() > std::numeric_limits<std::int32_t>::max()) return refuse("document too large");
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({no_such_file, same_path, read_nothing, write_nothing, nullptr});
    parser.SetImageLoader(keep_no_image, nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;
    try {
        const bool parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                       static_cast<unsigned>(text.size()), "");
        // It can return true with an error set.
        if (!parsed || !error.empty()) return refuse(error);
    } catch (const std::exception& fault) {
        return refuse(fault.what());
    }
    return model;
}

}  // namespace facet::scene::gltf
