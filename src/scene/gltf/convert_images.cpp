// Images: fetched, measured before they are decoded, decoded on all cores.
// SPDX-License-Identifier: MIT
#include "image/read.h"
#include "scene/gltf/import.h"
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

#include <cstring>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

/// One image in flight: its bytes, then its pixels or what was wrong.
struct Flight {
    std::string where;
    base::Bytes owned;
    std::span<const std::byte> bytes;
    base::Result<image::Image> pixels;
    base::Warnings warnings;
};

base::Result<std::span<const std::byte>> fetch(Import& import, std::uint32_t index,
                                               base::Bytes& owned) {
    const Json& json = *element_at(import.asset.json, "images", index);
    if (const auto view = index_at(json, "bufferView")) {
        if (*view < import.asset.views.size() && import.asset.views[*view].is_sound)
            return import.asset.views[*view].bytes;
        return base::fail(
            {.code = ErrorCode::input_invalid, .what = "image's buffer view has no bytes"});
    }
    const std::string uri = string_at(json, "uri");
    if (uri.empty())
        return base::fail({.code = ErrorCode::input_invalid, .what = "image has no source"});
    auto bytes = read_uri(import.asset, uri, import.asset.memory_left);
    if (!bytes) return tl::unexpected(bytes.error());
    owned = std::move(*bytes);
    return std::span<const std::byte>(owned);
}

/// KTX2's identifier (Khronos, KTX File Format 2.0, section 3.1) starts with these bytes.
bool is_ktx2(std::span<const std::byte> bytes) {
    constexpr std::string_view start = "\xABKTX 20\xBB";
    return bytes.size() >= start.size() &&
           std::memcmp(bytes.data(), start.data(), start.size()) == 0;
}

/// Bytes that decoding takes, against what is left; nothing is allocated before.
base::Status measure(Import& import, std::size_t id, const Flight& flight) {
    if (is_ktx2(flight.bytes))
        return base::fail({.code = ErrorCode::feature_missing,
                           .what = "KTX2 pictures are not supported",
                           .found = import.scene.images[id].name,
                           .remedy = "convert it to PNG, JPEG or WebP"});
    const auto header = image::read_header(flight.bytes, import.limits);
    if (!header) return tl::unexpected(header.error());
    const std::uint64_t needed =
        header->size.pixels() * header->channels * image::sample_bytes(header->sample);
    return import.take_memory(needed, flight.where);
}

/// A texture that is not to be had is white and a warning; a limit, a forbidden path and --strict
/// are errors.
base::Status settle(Import& import, const std::string& where, base::Error error) {
    const bool is_forbidden = error.what == "outside the model's folder";
    if (error.code == ErrorCode::limit_reached || import.options.strict || is_forbidden) {
        error.where = where;
        return base::fail(std::move(error));
    }
    import.warn(where, "texture is white: " + error.what, error.found, error.remedy);
    return {};
}

base::Status prepare(Import& import, std::size_t id, Flight& flight) {
    const std::uint32_t index = import.image_sources[id];
    flight.where = pointer_text("images", index);
    flight.pixels = base::fail({.code = ErrorCode::internal, .what = "not decoded"});
    const auto bytes = fetch(import, index, flight.owned);
    if (!bytes) return settle(import, flight.where, bytes.error());
    flight.bytes = *bytes;
    if (auto fits = measure(import, id, flight); !fits) {
        flight.bytes = {};
        return settle(import, flight.where, fits.error());
    }
    return {};
}

void decode_all(Import& import, std::vector<Flight>& flights) {
    import.pool.parallel_for(flights.size(), [&](std::size_t i) {
        Flight& flight = flights[i];
    if (flight.bytes.empty()) return;
    try {  // tasks must not throw
        flight.pixels = image::decode(flight.bytes, import.limits, flight.warnings);
    } catch (const std::exception& fault) {
        flight.pixels = base::fail(
            {.code = ErrorCode::input_invalid, .what = "cannot be decoded", .found = fault.what()});
    }
    flight.owned = {};
});
}  // namespace

}  // namespace facet::scene::gltf

ImageId use_image(Import& import, std::uint32_t index) {
    const Json& json = *element_at(import.asset.json, "images", index);
    const std::string uri = string_at(json, "uri");
    // A data URI may be megabytes long: by index then.
    const bool is_file = !uri.empty() && !is_data_uri(uri);
    const std::string key = is_file ? uri : fmt::format("#{}", index);
    const ImageId next{static_cast<std::uint32_t>(import.scene.images.size())};
    const auto [slot, is_new] = import.images_by_key.emplace(key, next);
    if (!is_new) return slot->second;
    const std::string name = string_at(json, "name");
    import.scene.images.push_back({.name = is_file         ? uri
                                           : !name.empty() ? name
                                                           : fmt::format("image {}", index),
                                   .pixels = nullptr,
                                   .source = index});
    import.image_sources.push_back(index);
    return next;
}

base::Status load_images(Import& import) {
    std::vector<Flight> flights(import.image_sources.size());
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (auto prepared = prepare(import, i, flights[i]); !prepared) return prepared;
    if (!import.options.decode_images) return {};
    decode_all(import, flights);
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (flights[i].bytes.empty()) continue;
        for (base::Warning& warning : flights[i].warnings) {
            warning.where = flights[i].where;
            import.warnings.push_back(std::move(warning));
        }
        if (flights[i].pixels) {
            import.scene.images[i].pixels =
                std::make_shared<const image::Image>(std::move(*flights[i].pixels));
        } else if (auto settled = settle(import, flights[i].where, flights[i].pixels.error());
                   !settled) {
            return settled;
        }
    }
    return {};
}

}  // namespace facet::scene::gltf
