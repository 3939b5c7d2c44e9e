// Buffers and buffer views: fetched, measured, and their ranges checked.
// SPDX-License-Identifier: MIT
#include "scene/gltf/asset.h"
#include "scene/gltf/meshopt.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

/// Padding of the BIN chunk's end to 4 bytes (glTF 2.0, section 4.4.3).
constexpr std::size_t bin_padding = 3;

void take_bin(Asset& asset, std::uint64_t length, Buffer& buffer, Problems& problems) {
    if (!asset.bin) {
        problems.error("BUFFER_MISSING_GLB_DATA", "/buffers/0",
                       "the GLB has no BIN chunk for this buffer");
        return;
    }
    if (asset.bin->size() < length) {
        problems.error("BUFFER_BYTE_LENGTH_MISMATCH", "/buffers/0",
                       "buffer is longer than the GLB's BIN chunk",
                       fmt::format("{}, but there are {} bytes", length, asset.bin->size()));
        return;
    }
    if (asset.bin->size() - length > bin_padding)
        problems.note(Severity::warning, "BUFFER_GLB_CHUNK_TOO_BIG", "/buffers/0",
                      "the GLB's BIN chunk is longer than its buffer",
                      fmt::format("{}, but there are {} bytes", length, asset.bin->size()));
    buffer.bytes = asset.bin->first(length);
    buffer.is_sound = true;
}

/// The code for a URI that could not be read.
std::string_view code_of(const std::string& uri, const base::Error& error) {
    if (is_data_uri(uri)) return "INVALID_URI";
    if (error.what == "the network is never used") return "NON_RELATIVE_URI";
    return error.what == "no such file" || error.what == "not a regular file" ? "IO_ERROR"
                                                                              : "INVALID_URI";
}

void check_data_uri_mime(const std::string& uri, const std::string& where, Problems& problems) {
    const std::string_view mime = std::string_view(uri).substr(5, uri.find_first_of(";,") - 5);
    if (mime != "application/octet-stream" && mime != "application/gltf-buffer" &&
        uri.find(',') != std::string::npos)
        problems.error("BUFFER_DATA_URI_MIME_TYPE_INVALID", where + "/uri",
                       "wrong media type of a buffer", std::string(mime.substr(0, 80)));
}

/// Buffers that hold, if anything, what a decoder makes of compressed views as well.
bool is_fallback(const Json& json) {
    for (const std::string_view name : meshopt_extensions)
        if (const Json* const use = find_path(json, fmt::format("extensions/{}", name));
            use != nullptr && bool_at(*use, "fallback").value_or(false))
            return true;
    return false;
}

void fetch(Asset& asset, const std::string& uri, std::uint64_t length, Buffer& buffer,
           const std::string& where, Problems& problems) {
    auto bytes = read_uri(asset, uri, asset.memory_left);
    if (!bytes) {
        Problem problem = to_problem(code_of(uri, bytes.error()), where + "/uri", bytes.error());
        if (problem.code == "NON_RELATIVE_URI") problem.severity = Severity::warning;
        problems.add(std::move(problem));
        return;
    }
    if (bytes->size() < length) {
        problems.error("BUFFER_BYTE_LENGTH_MISMATCH", where, "buffer has fewer bytes than it says",
                       fmt::format("{}, but there are {}", length, bytes->size()));
        return;
    }
    asset.memory_left -= bytes->size();
    buffer.owned = std::move(*bytes);
    buffer.bytes = std::span(buffer.owned).first(length);
    buffer.is_sound = true;
}

void read_buffer(Asset& asset, std::size_t index, const base::Limits& limits, Problems& problems) {
    const Json& json = *element_at(asset.json, "buffers", index);
    const std::string where = pointer_text("buffers", index);
    const std::optional<std::uint64_t> length = unsigned_at(json, "byteLength");
    const std::string uri = string_at(json, "uri");
    if (length && *length > limits.file_bytes) {
        problems.add({.code = "VALUE_NOT_IN_RANGE",
                      .pointer = where + "/byteLength",
                      .what = "buffer is over the limit",
                      .found = fmt::format("{} bytes, limit {}", *length, limits.file_bytes),
                      .error = ErrorCode::limit_reached});
        return;
    }
    if (is_data_uri(uri)) check_data_uri_mime(uri, where, problems);
    Buffer& buffer = asset.buffers[index];
    if (find(json, "uri") != nullptr) {
        if (find(json, "uri")->is_string())
            fetch(asset, uri, length.value_or(0), buffer, where, problems);
    } else if (index == 0 && asset.is_glb && length && *length > 0 && !is_fallback(json)) {
        take_bin(asset, *length, buffer, problems);
    } else if (!is_fallback(json) && length) {
        problems.note(Severity::information, "BUFFER_WITHOUT_DATA", where, "buffer has no bytes");
    }
    if (!length) buffer.is_sound = false;
}

void read_view(Asset& asset, std::size_t index, Problems& problems) {
    const Json& json = *element_at(asset.json, "bufferViews", index);
    const std::string where = pointer_text("bufferViews", index);
    const auto buffer_index = index_at(json, "buffer");
    const auto length = unsigned_at(json, "byteLength");
    if (!buffer_index || *buffer_index >= asset.buffers.size() || !length) return;
    if (find(json, "byteOffset") != nullptr && !unsigned_at(json, "byteOffset")) return;
    const std::uint64_t offset = unsigned_at(json, "byteOffset").value_or(0);
    const auto declared =
        unsigned_at(*element_at(asset.json, "buffers", *buffer_index), "byteLength");
    if (!declared) return;
    if (offset > *declared || *length > *declared - offset) {
        // The validator points at the offset where that alone is out of the buffer.
        const char* const part = offset >= *declared ? "/byteOffset" : "/byteLength";
        problems.error("BUFFER_VIEW_TOO_LONG", where + part, "buffer view leaves its buffer",
                       fmt::format("offset {} + length {}, but buffer {} has {} bytes", offset,
                                   *length, *buffer_index, *declared));
        return;
    }
    View& view = asset.views[index];
    view.stride = unsigned_at(json, "byteStride").value_or(0);
    if (view.stride > 252) return;
    const Buffer& buffer = asset.buffers[*buffer_index];
    if (!buffer.is_sound) return;
    view.bytes = buffer.bytes.subspan(offset, *length);
    view.is_sound = true;
}

}  // namespace

void read_buffers(Asset& asset, const base::Limits& limits, Problems& problems) {
    asset.buffers.resize(count_at(asset.json, "buffers"));
    for (std::size_t i = 0; i < asset.buffers.size(); ++i) read_buffer(asset, i, limits, problems);
}

void read_views(Asset& asset, Problems& problems) {
    asset.views.resize(count_at(asset.json, "bufferViews"));
    for (std::size_t i = 0; i < asset.views.size(); ++i) read_view(asset, i, problems);
}

}  // namespace facet::scene::gltf
