// Buffer views with a compressed form: every size checked, then decoded into the view.
// SPDX-License-Identifier: MIT
#include "scene/gltf/asset.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/meshopt.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <utility>

namespace facet::scene::gltf {
namespace {

constexpr auto meshopt_modes = std::to_array<std::pair<std::string_view, MeshoptMode>>(
    {{"ATTRIBUTES", MeshoptMode::attributes},
     {"TRIANGLES", MeshoptMode::triangles},
     {"INDICES", MeshoptMode::indices}});
constexpr auto meshopt_filters = std::to_array<std::pair<std::string_view, MeshoptFilter>>(
    {{"NONE", MeshoptFilter::none},
     {"OCTAHEDRAL", MeshoptFilter::octahedral},
     {"QUATERNION", MeshoptFilter::quaternion},
     {"EXPONENTIAL", MeshoptFilter::exponential},
     {"COLOR", MeshoptFilter::color}});

template <class Table>
auto choice_at(const Table& table, std::string_view word)
    -> std::optional<typename Table::value_type::second_type> {
    for (const auto& [name, value] : table)
        if (name == word) return value;
    return std::nullopt;
}

/// One compressed view on its way.
struct Compressed {
    Asset& asset;
    const Json& parent;  ///< the view
    const Json& json;    ///< its extension's object
    std::string where;   ///< of `json`
    Problems& problems;

    std::nullopt_t refuse(const char* member, std::string what, std::string found = {}) {
        problems.error("BUFFER_VIEW_COMPRESSION_INVALID", where + member, std::move(what),
                       std::move(found));
        return std::nullopt;
    }
};

/// The compressed bytes. Nothing, with or after a problem told, where they are not all there.
std::optional<std::span<const std::byte>> source_of(Compressed& c) {
    const auto index = index_at(c.json, "buffer");
    const auto length = unsigned_at(c.json, "byteLength");
    if (!index || *index >= c.asset.buffers.size() || !length) return std::nullopt;
    if (find(c.json, "byteOffset") != nullptr && !unsigned_at(c.json, "byteOffset"))
        return std::nullopt;
    const Buffer& buffer = c.asset.buffers[*index];
    if (!buffer.is_sound)
        return c.refuse("/buffer", "the buffer of the compressed data has no bytes",
                        std::to_string(*index));
    const std::uint64_t offset = unsigned_at(c.json, "byteOffset").value_or(0);
    const std::size_t size = buffer.bytes.size();
    if (offset > size || *length > size - offset)
        return c.refuse(offset >= size ? "/byteOffset" : "/byteLength",
                        "compressed data leaves its buffer",
                        fmt::format("offset {} + length {}, but buffer {} has {} bytes", offset,
                                    *length, *index, size));
    return buffer.bytes.subspan(offset, *length);
}

/// Mode, filter, count and stride. Nothing where the schema has told what is wrong.
std::optional<MeshoptStream> shape_of(const Json& json) {
    const auto mode = choice_at(meshopt_modes, string_at(json, "mode"));
    const bool is_filtered = find(json, "filter") != nullptr;
    const auto filter =
        is_filtered ? choice_at(meshopt_filters, string_at(json, "filter")) : MeshoptFilter::none;
    const auto count = unsigned_at(json, "count");
    const auto stride = unsigned_at(json, "byteStride");
    if (!mode || !filter || !count || *count == 0 || !stride || *stride == 0 || *stride > 256)
        return std::nullopt;
    return MeshoptStream{
        .mode = *mode, .filter = *filter, .count = *count, .stride_bytes = *stride, .bytes = {}};
}

/// What the view says of the bytes that its compressed form shall become.
bool agrees_with_parent(Compressed& c, const MeshoptStream& stream) {
    const std::uint64_t length = unsigned_at(c.parent, "byteLength").value_or(0);
    if (length / stream.stride_bytes != stream.count || length % stream.stride_bytes != 0) {
        c.refuse("/count", "count times stride is not the length of the buffer view",
                 fmt::format("{} of {} bytes, but the view has {}", stream.count,
                             stream.stride_bytes, length));
        return false;
    }
    const auto stride = unsigned_at(c.parent, "byteStride");
    if (stride && stream.mode == MeshoptMode::attributes && *stride != stream.stride_bytes) {
        c.refuse("/byteStride", "stride is not that of the buffer view",
                 fmt::format("{}, but the view has {}", stream.stride_bytes, *stride));
        return false;
    }
    return true;
}

/// Everything but the bytes themselves is sound; memory is set aside.
std::optional<MeshoptStream> stream_of(Compressed& c) {
    auto stream = shape_of(c.json);
    if (!stream) return std::nullopt;
    if (const auto shape = check_shape(*stream); !shape)
        return c.refuse(("/" + shape.error().where).c_str(), shape.error().what,
                        shape.error().found);
    if (!agrees_with_parent(c, *stream)) return std::nullopt;
    const auto bytes = source_of(c);
    if (!bytes) return std::nullopt;
    stream->bytes = *bytes;
    const std::size_t needed = stream->count * stream->stride_bytes;  // the parent's byteLength
    if (needed > c.asset.memory_left) {
        c.problems.add({.code = "BUFFER_VIEW_COMPRESSION_INVALID",
                        .pointer = c.where + "/count",
                        .what = "compressed data needs more memory than allowed",
                        .found = fmt::format("{} bytes more, {} left", needed, c.asset.memory_left),
                        .remedy = "raise --max-memory",
                        .error = base::ErrorCode::limit_reached});
        return std::nullopt;
    }
    c.asset.memory_left -= needed;
    return stream;
}

/// A feature that is missing is no fault of the file: plain bytes will do where there are any.
void tell_missing(Compressed& c, const View& view, const base::Error& error) {
    const bool has_fallback = view.is_sound;
    c.problems.add({.severity = Severity::information,
                    .code = has_fallback ? "BUFFER_VIEW_COMPRESSION_FALLBACK"
                                         : "BUFFER_VIEW_COMPRESSION_UNSUPPORTED",
                    .pointer = c.where,
                    .what = error.what,
                    .found = has_fallback ? "the plain data beside it is used" : "",
                    .error = error.code});
}

void decode_view(Compressed& c, View& view) {
    const auto stream = stream_of(c);
    if (!stream) {
        view.is_sound = false;
        return;
    }
    auto bytes = decode(*stream);
    if (bytes) {
        view.decoded = std::move(*bytes);
        view.bytes = view.decoded;
        view.is_lossy = stream->filter != MeshoptFilter::none;
        view.is_sound = true;
        return;
    }
    if (bytes.error().code == base::ErrorCode::feature_missing)
        return tell_missing(c, view, bytes.error());
    c.refuse("", bytes.error().what, bytes.error().found);
    view.is_sound = false;
}

}  // namespace

void decode_views(Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < asset.views.size(); ++i) {
        const Json& view = *element_at(asset.json, "bufferViews", i);
        for (const std::string_view name : meshopt_extensions) {
            const Json* const json = find_path(view, fmt::format("extensions/{}", name));
            if (json == nullptr || !json->is_object() || !is_implemented(name)) continue;
            Compressed compressed{
                asset, view, *json,
                pointer_text("bufferViews", i, fmt::format("/extensions/{}", name)), problems};
            decode_view(compressed, asset.views[i]);
            break;
        }
    }
}

}  // namespace facet::scene::gltf
