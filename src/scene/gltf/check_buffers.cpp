// Checks of buffers, views and accessors: what their use asks of them beyond lying within bounds.
// SPDX-License-Identifier: MIT
#include "scene/gltf/check.h"
#include "scene/gltf/roles.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace facet::scene::gltf {
namespace {

void check_uri_in_glb(const Asset& asset, const std::string& uri, const std::string& where,
                      Problems& problems) {
    if (!asset.is_glb || uri.empty()) return;
    if (is_data_uri(uri))
        problems.note(Severity::warning, "DATA_URI_GLB", where, "data URI within a GLB");
    else
        problems.note(Severity::information, "URI_GLB", where, "a GLB that needs another file");
}

void check_view(const Asset& asset, std::size_t index, Problems& problems) {
    const Json& view = *element_at(asset.json, "bufferViews", index);
    const std::string where = pointer_text("bufferViews", index, "/byteStride");
    const auto stride = unsigned_at(view, "byteStride");
    if (!stride) return;
    if (*stride % 4 != 0)
        problems.error("VALUE_MULTIPLE_OF", where, "stride is not a multiple of 4",
                       std::to_string(*stride));
    const auto length = unsigned_at(view, "byteLength");
    if (length && *stride > *length)
        problems.error("BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", where,
                       "stride is longer than the buffer view",
                       fmt::format("{} of {} bytes", *stride, *length));
    if (unsigned_at(view, "target") == 34963U)
        problems.error("BUFFER_VIEW_INVALID_BYTE_STRIDE", where, "indices must be tightly packed");
}

void check_accessor(const Asset& asset, std::size_t index, Problems& problems) {
    const Json& json = *element_at(asset.json, "accessors", index);
    const auto component = unsigned_at(json, "componentType").value_or(0);
    if (bool_at(json, "normalized").value_or(false) && (component == 5125 || component == 5126))
        problems.error("ACCESSOR_NORMALIZED_INVALID",
                       pointer_text("accessors", index, "/normalized"),
                       "32-bit components cannot be normalized");
    const Accessor& accessor = asset.accessors[index];
    if (accessor.components == 0) return;
    for (const char* const key : {"min", "max"}) {
        const std::size_t count = count_at(json, key);
        if (count != 0 && count != accessor.components)
            problems.error("ACCESSOR_MIN_MAX_LENGTH",
                           pointer_text("accessors", index, std::string("/") + key),
                           "bounds have another length than an element",
                           fmt::format("{}, but an element has {}", count, accessor.components));
    }
}

/// Marks `index` of `roles`; a second role is an error.
void mark(std::vector<Role>& roles, std::size_t index, Role role, std::string_view code,
          const std::string& where, Problems& problems) {
    if (index >= roles.size()) return;
    if (roles[index] == Role::none) roles[index] = role;
    if (roles[index] == role) return;
    problems.error(code, where, "used in two ways",
                   fmt::format("{} before, {} here", name_of(roles[index]), name_of(role)));
}

struct Marking {
    const Asset& asset;
    std::vector<Role> views;
    std::vector<Role> accessors;
    Problems& problems;

    void accessor(const Json& value, Role role, const std::string& where) {
        const auto index = as_unsigned(value);
        if (!index || *index >= accessors.size()) return;
        mark(accessors, *index, role, "ACCESSOR_USAGE_OVERRIDE", where, problems);
        if (const auto view = index_at(*element_at(asset.json, "accessors", *index), "bufferView"))
            mark(views, *view, role, "BUFFER_VIEW_TARGET_OVERRIDE", where, problems);
    }
    void member(const Json& object, const char* key, Role role, const std::string& where) {
        if (const Json* const value = find(object, key)) accessor(*value, role, where + "/" + key);
    }
    void attributes(const Json* map, const std::string& where) {
        if (map == nullptr || !map->is_object()) return;
        for (const auto& [name, value] : map->items())
            accessor(value, Role::vertices, where + "/" + name);
    }
};

void mark_primitive(Marking& marking, const Json& primitive, const std::string& where) {
    marking.member(primitive, "indices", Role::indices, where);
    marking.attributes(find(primitive, "attributes"), where + "/attributes");
    for (std::size_t t = 0; t < count_at(primitive, "targets"); ++t)
        marking.attributes(element_at(primitive, "targets", t),
                           fmt::format("{}/targets/{}", where, t));
}

}  // namespace

std::string_view name_of(Role role) {
    constexpr std::array<std::string_view, 6> names{"nothing",       "vertices",  "indices",
                                                    "bind matrices", "animation", "image"};
    return names[static_cast<std::size_t>(role)];
}

void check_buffer_use(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < asset.buffers.size(); ++i)
        check_uri_in_glb(asset, string_at(*element_at(asset.json, "buffers", i), "uri"),
                         pointer_text("buffers", i, "/uri"), problems);
    for (std::size_t i = 0; i < count_at(asset.json, "images"); ++i)
        check_uri_in_glb(asset, string_at(*element_at(asset.json, "images", i), "uri"),
                         pointer_text("images", i, "/uri"), problems);
    for (std::size_t i = 0; i < asset.views.size(); ++i) check_view(asset, i, problems);
    for (std::size_t i = 0; i < asset.accessors.size(); ++i) check_accessor(asset, i, problems);
}

void check_accessor_uses(const Asset& asset, Problems& problems) {
    Marking marking{asset, std::vector<Role>(asset.views.size()),
                    std::vector<Role>(asset.accessors.size()), problems};
    for (std::size_t i = 0; i < asset.views.size(); ++i) {
        const auto target = unsigned_at(*element_at(asset.json, "bufferViews", i), "target");
        if (target == 34962U) marking.views[i] = Role::vertices;
        if (target == 34963U) marking.views[i] = Role::indices;
    }
    for (std::size_t m = 0; m < count_at(asset.json, "meshes"); ++m) {
        const Json& mesh = *element_at(asset.json, "meshes", m);
        for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p)
            mark_primitive(marking, *element_at(mesh, "primitives", p),
                           fmt::format("/meshes/{}/primitives/{}", m, p));
    }
    for (std::size_t i = 0; i < count_at(asset.json, "skins"); ++i)
        marking.member(*element_at(asset.json, "skins", i), "inverseBindMatrices",
                       Role::bind_matrices, pointer_text("skins", i));
    for (std::size_t a = 0; a < count_at(asset.json, "animations"); ++a) {
        const Json& animation = *element_at(asset.json, "animations", a);
        for (std::size_t s = 0; s < count_at(animation, "samplers"); ++s)
            for (const char* const key : {"input", "output"})
                marking.member(*element_at(animation, "samplers", s), key, Role::animation,
                               fmt::format("/animations/{}/samplers/{}", a, s));
    }
    for (std::size_t i = 0; i < count_at(asset.json, "images"); ++i)
        if (const auto view = index_at(*element_at(asset.json, "images", i), "bufferView"))
            mark(marking.views, *view, Role::image, "BUFFER_VIEW_TARGET_OVERRIDE",
                 pointer_text("images", i, "/bufferView"), problems);
}

}  // namespace facet::scene::gltf
