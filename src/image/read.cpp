// Reading pictures of any format: the codec is found by magic bytes, its values are made safe to
// use. SPDX-License-Identifier: MIT
#include "image/read.h"

#include "image/checks.h"
#include "image/dispatch.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace facet::image {
namespace {

base::Result<const Codec*> codec_of(FileBytes file) {
    if (file.empty())
        return base::fail({.code = base::ErrorCode::input_invalid, .what = "the file is empty"});
    const auto format = sniff(file);
    if (!format)
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .where = "@0x0",
                           .what = "not a picture of a known format",
                           .found = {},
                           .remedy = "use PNG, JPEG, WebP, HDR, EXR or TIFF"});
    return &codec(*format);
}

tl::unexpected<base::Error> out_of_memory() {
    return base::fail({.code = base::ErrorCode::limit_reached,
                       .what = "out of memory while decoding a picture",
                       .found = {},
                       .remedy = "use a smaller picture"});
}

/// The layer that stands for the whole: the unnamed one, else the first with three channels, else
/// the first.
Layer main_layer(Picture& picture) {
    const auto unnamed = std::ranges::find(picture.layers, "", &Layer::name);
    if (unnamed != picture.layers.end()) return std::move(*unnamed);
    const auto color = std::ranges::find_if(
        picture.layers, [](const Layer& layer) { return layer.image.channels >= 3; });
    if (color != picture.layers.end()) return std::move(*color);
    return std::move(picture.layers.front());
}

void warn_count(base::Warnings& warnings, std::size_t count, std::string what) {
    if (count == 0) return;
    warnings.push_back({.file = {},
                        .where = "pixels",
                        .what = std::move(what),
                        .found = fmt::format("{} values", count),
                        .remedy = "they are taken as 0"});
}

/// NaN, infinite and negative values become 0.
void make_usable(Image& image, base::Warnings& warnings) {
    const auto values = image.as<float>();
    // One vectorised look first: a sign bit or an exponent of all ones is what must not be.
    std::uint32_t suspicious = 0;
    for (const float value : values)
        suspicious |= static_cast<std::uint32_t>(std::bit_cast<std::uint32_t>(value) > 0x7F7FFFFFU);
    if (suspicious == 0) return;
    std::size_t not_finite = 0;
    std::size_t negative = 0;
    for (float& value : values) {
        if (!std::isfinite(value)) {
            ++not_finite;
            value = 0.0F;
        } else if (value < 0.0F) {
            ++negative;
            value = 0.0F;
        }
    }
    warn_count(warnings, not_finite, "NaN or infinite pixels");
    warn_count(warnings, negative, "negative pixels");
}

/// EXR alpha is associated; textures want it straight. Where alpha is 0 the colour stays as it is.
void unassociate(Image& image) {
    const auto values = image.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float alpha = values[i + 3];
        if (alpha <= 0.0F || alpha >= 1.0F) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const float straight = values[i + c] / alpha;
            if (std::isfinite(straight)) values[i + c] = straight;
        }
    }
}

/// Codec libraries and our own buffers may throw; nothing leaves this room.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    } catch (const std::exception& problem) {
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .what = "the picture cannot be decoded",
                           .found = problem.what(),
                           .remedy = "export the picture again"});
    }
}

}  // namespace

Layer layer_of(std::string_view name, std::string_view letters, Image image) {
    Layer layer{.name = std::string(name), .channels = {}, .image = std::move(image)};
    for (const char letter : letters) layer.channels.emplace_back(1, letter);
    return layer;
}

std::optional<tables::ImageFormat> sniff(std::span<const std::byte> file) {
    for (std::size_t i = 0; i < codecs.size(); ++i)
        if (codecs[i].sniff(file)) return static_cast<tables::ImageFormat>(i);
    return std::nullopt;
}

base::Result<Header> read_header(std::span<const std::byte> file, const base::Limits& limits) {
    const auto found = codec_of(file);
    if (!found) return tl::unexpected(found.error());
    return guarded([&] { return (*found)->read_header(file, limits); });
}

base::Result<Image> decode(std::span<const std::byte> file, const base::Limits& limits,
                           base::Warnings& warnings) {
    const auto found = codec_of(file);
    if (!found) return tl::unexpected(found.error());
    return guarded([&]() -> base::Result<Image> {
        auto picture = (*found)->read(file, limits, warnings);
        if (!picture) return tl::unexpected(picture.error());
        Layer layer = main_layer(*picture);
        if (layer.image.sample == Sample::f32) {
            make_usable(layer.image, warnings);
            if (layer.image.channels == 4) unassociate(layer.image);
        }
        return std::move(layer.image);
    });
}

base::Result<Picture> decode_picture(std::span<const std::byte> file, const base::Limits& limits) {
    const auto found = codec_of(file);
    if (!found) return tl::unexpected(found.error());
    return guarded([&] {
        base::Warnings unused;
        return (*found)->read(file, limits, unused);
    });
}

}  // namespace facet::image
