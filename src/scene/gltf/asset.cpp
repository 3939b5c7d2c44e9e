// Opening a glTF file: GLB or text, its document, and what its URIs name.
// SPDX-License-Identifier: MIT
#include "scene/gltf/asset.h"

#include "base/json.h"
#include "scene/gltf/glb.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

namespace facet::scene::gltf {
namespace {

std::string_view text_of(std::span<const std::byte> file) {
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

/// What a file that is no glTF seems to be; empty where nothing is recognised.
std::string_view guess(std::string_view text) {
    if (text.starts_with("version https://git-lfs")) return "a Git LFS pointer";
    if (text.starts_with("\x89PNG")) return "a PNG";
    if (text.starts_with("\xFF\xD8\xFF")) return "a JPEG";
    if (text.starts_with("PK\x03\x04")) return "a zip archive";
    if (text.starts_with("RIFF")) return "a RIFF file";
    if (text.starts_with("<")) return "HTML or XML";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16 text";
    return {};
}

bool starts_as_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '{';
}

/// Not JSON and not GLB: says what it is instead of where a parser gave up.
Problem not_gltf(std::string_view text) {
    const std::string_view kind = guess(text);
    Problem problem{.code = "INVALID_JSON", .pointer = {}, .what = "not a glTF file", .found = {}};
    if (text.empty()) problem.found = "empty file";
    if (!kind.empty()) problem.found = fmt::format("it seems to be {}", kind);
    if (kind == "a Git LFS pointer") problem.remedy = "run git lfs pull";
    return problem;
}

}  // namespace

std::optional<Asset> open_asset(base::Bytes file, Origin origin, const base::Limits& limits,
                                Problems& problems) {
    Asset asset{.origin = std::move(origin), .file = std::move(file), .json = {}, .bin = {}};
    asset.is_glb = looks_like_glb(asset.file) || asset.origin.label.ends_with(".glb");
    std::string_view text = text_of(asset.file);
    if (asset.is_glb && !starts_as_json(text)) {
        if (!guess(text).empty()) {
            problems.add(not_gltf(text));
            return std::nullopt;
        }
        const auto chunks = split_glb(asset.file, problems);
        if (!chunks) return std::nullopt;
        text = chunks->json;
        asset.bin = chunks->bin;
    } else if (asset.is_glb = false; text.empty() || !guess(text).empty()) {
        problems.add(not_gltf(text));
        return std::nullopt;
    }
    auto json = base::parse_json<Json>(text, limits);
    if (!json) {
        const bool is_range = json.error().what == "number does not fit";
        problems.add(to_problem(is_range ? "VALUE_NOT_IN_RANGE" : "INVALID_JSON",
                                json.error().where, json.error()));
        return std::nullopt;
    }
    if (!json->is_object()) {
        problems.error("TYPE_MISMATCH", "", "the document is not an object", brief(*json));
        return std::nullopt;
    }
    asset.json = std::move(*json);
    asset.memory_left = limits.memory_bytes;
    return asset;
}

base::Result<base::Bytes> read_uri(Asset& asset, const std::string& uri, std::size_t max_bytes) {
    if (is_data_uri(uri)) {
        auto decoded = decode_data_uri(uri, max_bytes);
        if (!decoded) return tl::unexpected(decoded.error());
        return std::move(decoded->bytes);
    }
    const auto path = decode_relative_uri(uri);
    if (!path) return tl::unexpected(path.error());
    if (!asset.origin.folder)
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .what = "relative URI, but there is no folder to look in",
                           .found = uri,
                           .remedy = "give --base DIR"});
    auto bytes = base::read_file_beneath(*asset.origin.folder, *path, asset.origin.allowed_folders,
                                         max_bytes);
    if (bytes) asset.reads.push_back(*asset.origin.folder / *path);
    return bytes;
}

}  // namespace facet::scene::gltf
