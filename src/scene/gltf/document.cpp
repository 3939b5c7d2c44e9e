// A glTF document that is written.
// SPDX-License-Identifier: MIT
#include "scene/gltf/document.h"

#include "base/text.h"
#include "scene/gltf/glb.h"
#include "scene/gltf/meshopt.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstring>

namespace facet::scene::gltf {
namespace {

constexpr std::uint32_t glb_magic = 0x46546C67;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t bin_chunk = 0x004E4942;
constexpr std::size_t alignment = 4;

void put_u32(base::Bytes& out, std::uint64_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<std::byte>(value >> shift & 0xFFU));
}

void put(base::Bytes& out, std::span<const std::byte> bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

void align(base::Bytes& out, std::byte with) {
    while (out.size() % alignment != 0) out.push_back(with);
}

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

/// What follows the JSON and BIN chunks; the file has been walked already.
base::Bytes chunks_after(std::span<const std::byte> file, const GlbChunks& chunks) {
    const auto end_of = [&](const void* data, std::size_t size) {
        const auto at = static_cast<std::size_t>(static_cast<const std::byte*>(data) - file.data());
        return (at + size + alignment - 1) / alignment * alignment;
    };
    std::size_t end = end_of(chunks.json.data(), chunks.json.size());
    if (chunks.bin) end = std::max(end, end_of(chunks.bin->data(), chunks.bin->size()));
    if (end >= file.size()) return {};
    return {file.begin() + static_cast<std::ptrdiff_t>(end), file.end()};
}

/// Points every view of buffer `index` (and its compressed form) at buffer 0, from `offset` on.
void move_views(OrderedJson& json, std::size_t index, std::size_t offset) {
    if (!json.contains("bufferViews")) return;
    const auto move = [&](OrderedJson& object) {
        if (!object.is_object() || !object.contains("buffer") || object["buffer"] != index) return;
        object["buffer"] = 0;
        object["byteOffset"] = object.value("byteOffset", std::size_t{0}) + offset;
    };
    for (OrderedJson& view : json["bufferViews"]) {
        move(view);
        if (!view.contains("extensions") || !view["extensions"].is_object()) continue;
        auto& extensions = view["extensions"];
        for (const std::string_view name : meshopt_extensions)
            if (extensions.contains(name)) move(extensions[std::string(name)]);
    }
}

/// What the first bytes say a picture is; empty for a kind glTF does not embed.
std::string_view mime_of(std::span<const std::byte> bytes) {
    const auto starts = [&](std::string_view text) {
        return bytes.size() >= text.size() &&
               std::memcmp(bytes.data(), text.data(), text.size()) == 0;
    };
    if (starts("\x89PNG")) return "image/png";
    if (starts("\xFF\xD8\xFF")) return "image/jpeg";
    if (starts("RIFF")) return "image/webp";
    return {};
}

}  // namespace

base::Result<Document> document_of(const Asset& asset) {
    Document out;
    std::string_view text(reinterpret_cast<const char*>(asset.file.data()), asset.file.size());
    Problems problems;
    if (asset.is_glb) {
        const auto chunks = split_glb(asset.file, problems);
        if (!chunks)
            return base::fail({.code = base::ErrorCode::internal, .what = "the GLB has no JSON"});
        text = chunks->json;
        out.has_bin = chunks->bin.has_value();
        if (chunks->bin) out.bin.assign(chunks->bin->begin(), chunks->bin->end());
        out.later_chunks = chunks_after(asset.file, *chunks);
    }
    out.json = OrderedJson::parse(text.begin(), text.end(), nullptr, false);
    if (!out.json.is_object())
        return base::fail({.code = base::ErrorCode::internal, .what = "the document is no object"});
    return out;
}

OrderedJson& array_at(OrderedJson& object, const std::string& key) {
    OrderedJson& array = object[key];
    if (!array.is_array()) array = OrderedJson::array();
    return array;
}

void use_extension(OrderedJson& json, std::string_view extension) {
    OrderedJson& used = array_at(json, "extensionsUsed");
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

OrderedJson shortest(float value) {
    return base::parse_number(fmt::format("{}", value)).value_or(0.0);
}
OrderedJson shortest(const math::Vec3& value) {
    return OrderedJson::array({shortest(value.x), shortest(value.y), shortest(value.z)});
}

std::size_t append_view(Document& document, std::span<const std::byte> bytes) {
    OrderedJson& buffers = array_at(document.json, "buffers");
    // The BIN chunk is the first buffer, and only where that has no URI.
    if (!document.has_bin) {
        document.has_bin = true;
        buffers.insert(buffers.begin(), OrderedJson{{"byteLength", 0}});
        if (document.json.contains("bufferViews"))
            for (OrderedJson& view : document.json["bufferViews"])
                view["buffer"] = view.value("buffer", std::size_t{0}) + 1;
    }
    align(document.bin, std::byte{0});
    const std::size_t offset = document.bin.size();
    put(document.bin, bytes);
    buffers[0]["byteLength"] = document.bin.size();
    OrderedJson& views = array_at(document.json, "bufferViews");
    views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    return views.size() - 1;
}

base::Result<base::Bytes> glb_bytes(const Document& document) {
    const std::string text =
        document.json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    base::Bytes json;
    put(json, bytes_of(text));
    align(json, std::byte{' '});
    base::Bytes bin = document.bin;
    align(bin, std::byte{0});
    const std::uint64_t size = 12 + 8 + json.size() + (document.has_bin ? 8 + bin.size() : 0) +
                               document.later_chunks.size();
    if (size > UINT32_MAX)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .what = "a GLB holds 4 GiB at most",
                           .found = fmt::format("{} bytes", size),
                           .remedy = "save it as .gltf"});
    base::Bytes out;
    out.reserve(size);
    put_u32(out, glb_magic);
    put_u32(out, 2);
    put_u32(out, size);
    put_u32(out, json.size());
    put_u32(out, json_chunk);
    put(out, json);
    if (document.has_bin) {
        put_u32(out, bin.size());
        put_u32(out, bin_chunk);
        put(out, bin);
    }
    put(out, document.later_chunks);
    return out;
}

base::Bytes gltf_bytes(const Document& document) {
    const std::string text =
        document.json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
    base::Bytes out;
    put(out, bytes_of(text));
    return out;
}

base::Status pack(Asset& asset, Document& document) {
    OrderedJson& json = document.json;
    base::Bytes bin;
    for (std::size_t i = 0; i < asset.buffers.size(); ++i) {
        if (!asset.buffers[i].is_sound)
            return base::fail({.code = base::ErrorCode::feature_missing,
                               .where = pointer_text("buffers", i),
                               .what = "a buffer without bytes cannot be packed",
                               .remedy = "save it as .gltf"});
        align(bin, std::byte{0});
        // Views of buffer 0 stay where they are; those of others must not be moved twice.
        if (i > 0) move_views(json, i, bin.size());
        put(bin, asset.buffers[i].bytes);
    }
    document.bin = std::move(bin);
    document.has_bin = !asset.buffers.empty();
    if (document.has_bin) {
        OrderedJson first = json["buffers"][0];
        first.erase("uri");
        first["byteLength"] = document.bin.size();
        json["buffers"] = OrderedJson::array({first});
    }
    if (!json.contains("images")) return {};
    for (OrderedJson& image : json["images"]) {
        if (!image.contains("uri") || !image["uri"].is_string()) continue;
        const auto bytes = read_uri(asset, image["uri"].get<std::string>(), asset.memory_left);
        if (!bytes) continue;  // missing before, missing after
        const std::string_view mime = mime_of(*bytes);
        if (mime.empty())
            return base::fail({.code = base::ErrorCode::feature_missing,
                               .where = image["uri"].get<std::string>(),
                               .what = "is no PNG, JPEG or WebP, and cannot be packed",
                               .remedy = "save it as .gltf"});
        image.erase("uri");
        image["bufferView"] = append_view(document, *bytes);
        image["mimeType"] = mime;
    }
    return {};
}

void unpack(Document& document, const std::string& name) {
    if (!document.has_bin) return;
    document.json["buffers"][0]["uri"] = name;
    // The chunk was padded, the buffer is not.
    const auto length = document.json["buffers"][0].value("byteLength", document.bin.size());
    document.bin.resize(std::min(length, document.bin.size()));
    document.new_files.push_back({name, std::move(document.bin)});
    document.bin.clear();
    document.has_bin = false;
}

base::Result<std::vector<SideFile>> named_files(Asset& asset, const Document& document) {
    std::vector<SideFile> out;
    for (const char* list : {"buffers", "images"}) {
        if (!document.json.contains(list)) continue;
        for (const OrderedJson& item : document.json[list]) {
            if (!item.contains("uri") || !item["uri"].is_string()) continue;
            const auto uri = item["uri"].get<std::string>();
            if (is_data_uri(uri)) continue;
            const auto path = decode_relative_uri(uri);
            if (!path) continue;
            const bool is_new =
                std::any_of(document.new_files.begin(), document.new_files.end(),
                            [&](const SideFile& file) { return file.path == *path; });
            if (is_new) continue;
            auto bytes = read_uri(asset, uri, asset.memory_left);
            if (!bytes) continue;  // missing before, missing after
            out.push_back({*path, std::move(*bytes)});
        }
    }
    return out;
}

}  // namespace facet::scene::gltf
