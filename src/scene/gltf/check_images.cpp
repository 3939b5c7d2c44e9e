// Checks of images: one source each, of the kind that was declared, with a header that can be read.
// SPDX-License-Identifier: MIT
#include "image/read.h"
#include "scene/gltf/check.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>
#include <string>

namespace facet::scene::gltf {
namespace {

struct ImageLook {
    Asset& asset;
    const Json& json;
    std::size_t index;
    std::string where;
    const base::Limits& limits;
    Problems& problems;
    bool allows_webp;
    std::set<std::string>& read;  ///< files looked at already
};

std::string_view mime_of(tables::ImageFormat format) {
    switch (format) {
        case tables::ImageFormat::png:
            return "image/png";
        case tables::ImageFormat::jpeg:
            return "image/jpeg";
        case tables::ImageFormat::webp:
            return "image/webp";
        default:
            return {};
    }
}

std::string data_uri_mime(const std::string& uri) {
    return is_data_uri(uri) ? uri.substr(5, uri.find_first_of(";,") - 5) : std::string();
}

void check_source(ImageLook& l) {
    const bool has_uri = find(l.json, "uri") != nullptr;
    const bool has_view = find(l.json, "bufferView") != nullptr;
    if (has_uri == has_view)
        l.problems.error("ONE_OF_MISMATCH", l.where,
                         "image needs a uri or a buffer view, and not both");
    const auto view = index_at(l.json, "bufferView");
    const Json* const view_json = view ? element_at(l.asset.json, "bufferViews", *view) : nullptr;
    if (view_json != nullptr && find(*view_json, "byteStride") != nullptr)
        l.problems.error("IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE", l.where + "/bufferView",
                         "image in a buffer view with a stride");
    const std::string mime = string_at(l.json, "mimeType");
    const bool is_known = mime.empty() || mime == "image/jpeg" || mime == "image/png" ||
                          (mime == "image/webp" && l.allows_webp);
    if (!is_known)
        l.problems.note(Severity::warning, "VALUE_NOT_IN_LIST", l.where + "/mimeType",
                        "not a known value", mime.substr(0, 60));
}

/// A URI that no file could have. `http:` is well-formed, so the validator only warns; `load`
/// refuses it.
void check_uri(ImageLook& l, const std::string& uri) {
    if (is_data_uri(uri)) return;
    if (const auto path = decode_relative_uri(uri); !path) {
        const bool is_remote = path.error().what == "the network is never used";
        Problem problem = to_problem(is_remote ? "NON_RELATIVE_URI" : "INVALID_URI",
                                     l.where + "/uri", path.error());
        if (is_remote) problem.severity = Severity::warning;
        l.problems.add(std::move(problem));
    }
}

void check_declared(ImageLook& l, std::string_view found, const std::string& declared,
                    const std::string& at) {
    if (!declared.empty() && declared != found)
        l.problems.error("IMAGE_MIME_TYPE_INVALID", at, "image is not of the declared media type",
                         fmt::format("{}, declared {}", found, declared.substr(0, 60)));
}

void check_bytes(ImageLook& l, std::span<const std::byte> bytes, const std::string& uri) {
    const auto format = image::sniff(bytes);
    const std::string_view mime = format ? mime_of(*format) : std::string_view{};
    if (mime.empty()) {
        l.problems.note(Severity::warning, "IMAGE_UNRECOGNIZED_FORMAT", l.where,
                        "image is of no known format");
        return;
    }
    const std::string at = l.where + (uri.empty() ? "/bufferView" : "/uri");
    const std::string embedded = data_uri_mime(uri);
    if (!embedded.empty() && embedded != mime)
        l.problems.error("INVALID_URI", at, "data URI is not of its own media type",
                         fmt::format("{}, declared {}", mime, embedded));
    l.asset.image_mimes[l.index] = mime;
    check_declared(l, mime, string_at(l.json, "mimeType"), at);
    if (mime == "image/webp" && !l.allows_webp)
        l.problems.error("IMAGE_NON_ENABLED_MIME_TYPE", l.where, "WebP needs EXT_texture_webp");
    const auto header = image::read_header(bytes, l.limits);
    if (!header) {
        const bool is_cut = header.error().what.find("cut") != std::string::npos;
        l.problems.add(to_problem(is_cut ? "IMAGE_UNEXPECTED_EOS" : "IMAGE_DATA_INVALID", l.where,
                                  header.error()));
        return;
    }
    const auto is_power_of_two = [](std::uint32_t n) { return (n & (n - 1)) == 0; };
    if (!is_power_of_two(header->size.width) || !is_power_of_two(header->size.height))
        l.problems.note(Severity::information, "IMAGE_NPOT_DIMENSIONS", l.where,
                        "sides are not powers of two",
                        fmt::format("{}x{}", header->size.width, header->size.height));
}

void check_contents(ImageLook& l) {
    const std::string uri = string_at(l.json, "uri");
    if (const auto view = index_at(l.json, "bufferView")) {
        if (*view < l.asset.views.size() && l.asset.views[*view].is_sound)
            check_bytes(l, l.asset.views[*view].bytes, {});
        return;
    }
    if (uri.empty() || (!is_data_uri(uri) && !decode_relative_uri(uri))) return;
    if (!is_data_uri(uri) && !l.read.insert(uri).second) return;
    const auto bytes = read_uri(l.asset, uri, l.asset.memory_left);
    if (!bytes) {
        const bool is_io = !is_data_uri(uri);
        l.problems.add(
            to_problem(is_io ? "IO_ERROR" : "INVALID_URI", l.where + "/uri", bytes.error()));
        return;
    }
    check_bytes(l, *bytes, uri);
}

bool uses(const Json& json, const char* extension) {
    const Json* const used = find(json, "extensionsUsed");
    return used != nullptr && used->is_array() &&
           std::find(used->begin(), used->end(), Json(extension)) != used->end();
}

}  // namespace

void check_images(Asset& asset, Depth depth, const base::Limits& limits, Problems& problems) {
    const bool allows_webp = uses(asset.json, "EXT_texture_webp");
    std::set<std::string> read;
    asset.image_mimes.resize(count_at(asset.json, "images"));
    for (std::size_t i = 0; i < count_at(asset.json, "images"); ++i) {
        const Json& json = *element_at(asset.json, "images", i);
        if (!json.is_object()) continue;
        ImageLook looking{asset,  json,     i,           pointer_text("images", i),
                          limits, problems, allows_webp, read};
        check_source(looking);
        if (const std::string uri = string_at(json, "uri"); find(json, "uri") != nullptr)
            check_uri(looking, uri);
        if (depth == Depth::elements) check_contents(looking);
    }
}

}  // namespace facet::scene::gltf
