// Primitives with a compressed form: held against their accessors, then decoded into these.
// SPDX-License-Identifier: MIT
#include "scene/gltf/asset.h"
#include "scene/gltf/draco.h"
#include "scene/gltf/extensions.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <optional>

namespace facet::scene::gltf {
namespace {

constexpr std::string_view draco_extension = "KHR_draco_mesh_compression";

/// Which part of which view an accessor was decoded from.
struct DracoPart {
    std::uint32_t view = 0;
    std::uint32_t id = 0;  ///< of an attribute
    bool is_index = false;
    bool operator==(const DracoPart&) const = default;
};

/// One compressed primitive on its way.
struct DracoUse {
    Asset& asset;
    std::size_t mesh;
    std::size_t primitive;
    const Json& json;                           ///< of the primitive
    std::string where;                          ///< of its extension's object
    std::map<std::uint32_t, DracoPart>& parts;  ///< by accessor, of all primitives
    Problems& problems;
    std::vector<std::uint32_t> accessors = {};  ///< of the attributes
    std::uint32_t index_accessor = 0;
    std::uint32_t view = 0;

    std::nullopt_t refuse(std::string pointer, std::string what, std::string found = {}) {
        problems.error("MESH_PRIMITIVE_COMPRESSION_INVALID", std::move(pointer), std::move(what),
                       std::move(found));
        return std::nullopt;
    }
    /// Null where it has no known shape: the schema has told.
    [[nodiscard]] const Accessor* shaped(std::optional<std::uint64_t> index) const {
        if (!index || *index >= asset.accessors.size()) return nullptr;
        const Accessor& accessor = asset.accessors[*index];
        return accessor.components > 0 && accessor.rows == 0 ? &accessor : nullptr;
    }
};

/// The compressed bytes. Nothing, with or after a problem told, where they are not there.
std::optional<std::span<const std::byte>> draco_bytes(DracoUse& use, const Json& extension) {
    const auto index = index_at(extension, "bufferView");
    if (!index || *index >= use.asset.views.size()) return std::nullopt;
    use.view = *index;
    const View& view = use.asset.views[*index];
    if (!view.is_sound)
        return use.refuse(use.where + "/bufferView",
                          "the buffer view of the compressed data has no bytes",
                          std::to_string(*index));
    return view.bytes;
}

/// The attributes to decode, with the count of their accessors.
bool read_attributes(DracoUse& use, const Json& extension, DracoStream& stream) {
    const Json* const attributes = find(extension, "attributes");
    const Json* const plain = find(use.json, "attributes");
    if (attributes == nullptr || !attributes->is_object() || plain == nullptr) return false;
    for (const auto& [name, id] : attributes->items()) {
        const std::string at = use.where + (Pointer() / "attributes" / name).text();
        const auto number = as_unsigned(id);
        if (!number || *number > std::numeric_limits<std::uint32_t>::max()) {
            use.refuse(at, "not the id of an attribute", brief(id));
            return false;
        }
        if (find(*plain, name) == nullptr) {
            use.refuse(at, "the primitive lacks this attribute");
            return false;
        }
        const Accessor* const accessor = use.shaped(as_unsigned(*find(*plain, name)));
        if (accessor == nullptr) return false;
        // That all are of one count is checked with the meshes.
        if (!stream.attributes.empty() && accessor->count != stream.point_count) return false;
        stream.point_count = accessor->count;
        stream.attributes.push_back({.id = static_cast<std::uint32_t>(*number),
                                     .components = accessor->components,
                                     .component = accessor->component,
                                     .where = at});
        use.accessors.push_back(static_cast<std::uint32_t>(accessor - use.asset.accessors.data()));
    }
    return !stream.attributes.empty();
}

bool read_indices(DracoUse& use, DracoStream& stream) {
    const Json* const value = find(use.json, "indices");
    if (value == nullptr) {
        use.refuse(use.where, "a compressed primitive has no indices");
        return false;
    }
    const Accessor* const accessor = use.shaped(as_unsigned(*value));
    if (accessor == nullptr || accessor->components != 1) return false;
    use.index_accessor = static_cast<std::uint32_t>(accessor - use.asset.accessors.data());
    stream.index_count = accessor->count;
    return true;
}

std::optional<DracoStream> stream_of(DracoUse& use) {
    const Json& extension = *find_path(use.json, fmt::format("extensions/{}", draco_extension));
    const auto mode = unsigned_at(use.json, "mode").value_or(4);
    if (mode != 4 && mode != 5)
        return use.refuse(use.where, "only triangles and strips can be compressed",
                          fmt::format("mode {}", mode));
    const auto bytes = draco_bytes(use, extension);
    if (!bytes) return std::nullopt;
    DracoStream stream{.bytes = *bytes,
                       .where = use.where,
                       .attributes = {},
                       .is_strip = mode == 5,
                       .memory_bytes = use.asset.memory_left};
    if (!read_attributes(use, extension, stream) || !read_indices(use, stream)) return std::nullopt;
    return stream;
}

/// Whether every accessor is new, or else (false) all have been decoded from these parts before.
std::optional<bool> is_new(DracoUse& use, const DracoStream& stream) {
    std::size_t known = 0;
    const auto meets = [&](std::uint32_t accessor, const DracoPart& part) {
        const auto [found, is_added] = use.parts.try_emplace(accessor, part);
        if (!is_added) ++known;
        return found->second == part;
    };
    bool agrees = meets(use.index_accessor, {.view = use.view, .is_index = true});
    for (std::size_t i = 0; i < use.accessors.size(); ++i)
        agrees &= meets(use.accessors[i], {.view = use.view, .id = stream.attributes[i].id});
    if (!agrees) return use.refuse(use.where, "an accessor is compressed in two ways");
    return known < use.accessors.size() + 1;
}

void fill(Asset& asset, Accessor& accessor, base::Bytes bytes) {
    asset.memory_left -= std::min(asset.memory_left, bytes.size());
    asset.decoded.push_back(std::move(bytes));
    accessor.bytes = asset.decoded.back();
    accessor.stride = accessor.components * component_bytes(accessor.component);
    accessor.sparse_indices.clear();
    accessor.sparse_values = {};
    accessor.is_sound = true;
}

/// The indices in the accessor's own type. False, with a problem told, where one does not fit.
bool fill_indices(DracoUse& use, const std::vector<std::uint32_t>& indices) {
    Accessor& accessor = use.asset.accessors[use.index_accessor];
    const std::size_t size = component_bytes(accessor.component);
    base::Bytes bytes(indices.size() * size);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (size < 4 && indices[i] >> (8 * size) != 0) {
            use.refuse(use.where, "compressed index does not fit the accessor's type",
                       fmt::format("{} at {}", indices[i], i));
            return false;
        }
        std::memcpy(bytes.data() + i * size, &indices[i], size);  // little-endian, as glTF is
    }
    accessor.count = indices.size();
    fill(use.asset, accessor, std::move(bytes));
    return true;
}

/// A feature that is missing is no fault of the file: plain data will do where there are any.
void tell_missing(DracoUse& use, const base::Error& error) {
    const auto is_plain = [&](std::uint32_t index) {
        const Accessor& accessor = use.asset.accessors[index];
        return accessor.is_sound && accessor.view.has_value();
    };
    const bool has_fallback = is_plain(use.index_accessor) &&
                              std::all_of(use.accessors.begin(), use.accessors.end(), is_plain);
    use.problems.add({.severity = Severity::information,
                      .code = has_fallback ? "MESH_PRIMITIVE_COMPRESSION_FALLBACK"
                                           : "MESH_PRIMITIVE_COMPRESSION_UNSUPPORTED",
                      .pointer = error.where,
                      .what = error.what,
                      .found = has_fallback ? "the plain data beside it is used" : error.found,
                      .error = error.code});
}

/// What the accessors say that it takes.
std::size_t decoded_bytes(const DracoUse& use, const DracoStream& stream) {
    std::size_t bytes = stream.index_count * (stream.is_strip ? 3 : 1) * sizeof(std::uint32_t);
    for (const std::uint32_t index : use.accessors) {
        const Accessor& accessor = use.asset.accessors[index];
        bytes += accessor.count * accessor.components * component_bytes(accessor.component);
    }
    return bytes;
}

void decode_primitive(DracoUse& use) {
    const auto stream = stream_of(use);
    if (!stream) return;
    const auto wanted = is_new(use, *stream);
    if (!wanted) return;
    // Draco knows triangles only; a strip's become a list.
    const auto become_list = [&] {
        if (stream->is_strip)
            use.asset.json["meshes"][use.mesh]["primitives"][use.primitive]["mode"] = 4;
    };
    if (!*wanted) return become_list();
    auto decoded = decode_draco(*stream);
    if (!decoded) {
        if (decoded.error().code == base::ErrorCode::feature_missing)
            return tell_missing(use, decoded.error());
        // It took its time, as often as primitives ask for it.
        use.asset.memory_left -= std::min(use.asset.memory_left, decoded_bytes(use, *stream));
        use.problems.add(to_problem("MESH_PRIMITIVE_COMPRESSION_INVALID", decoded.error().where,
                                    decoded.error()));
        return;
    }
    if (!fill_indices(use, decoded->indices)) return;
    for (std::size_t i = 0; i < use.accessors.size(); ++i) {
        Accessor& accessor = use.asset.accessors[use.accessors[i]];
        fill(use.asset, accessor, std::move(decoded->attributes[i]));
        accessor.is_lossy = true;
    }
    become_list();
}

}  // namespace

void decode_primitives(Asset& asset, Problems& problems) {
    if (!is_implemented(draco_extension)) return;
    std::map<std::uint32_t, DracoPart> parts;
    for (std::size_t m = 0; m < count_at(asset.json, "meshes"); ++m) {
        const Json& mesh = *element_at(asset.json, "meshes", m);
        for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p) {
            const Json& primitive = *element_at(mesh, "primitives", p);
            const Json* const use =
                find_path(primitive, fmt::format("extensions/{}", draco_extension));
            if (use == nullptr || !use->is_object()) continue;
            DracoUse one{.asset = asset,
                         .mesh = m,
                         .primitive = p,
                         .json = primitive,
                         .where = fmt::format("/meshes/{}/primitives/{}/extensions/{}", m, p,
                                              draco_extension),
                         .parts = parts,
                         .problems = problems};
            decode_primitive(one);
        }
    }
}

}  // namespace facet::scene::gltf
