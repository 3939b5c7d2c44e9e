// RMSE, PSNR and largest error of two pictures.
// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include "image/flip.h"
#include "math/color.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace facet::image {
namespace {

const Layer* find_layer(const Picture& picture, const std::string& name) {
    const auto found = std::ranges::find(picture.layers, name, &Layer::name);
    return found == picture.layers.end() ? nullptr : &*found;
}
const Layer* beauty(const Picture& picture) {
    if (const Layer* unnamed = find_layer(picture, "")) return unnamed;
    return picture.layers.empty() ? nullptr : &picture.layers.front();
}

/// A sample as a float: integers over their largest.
float value_at(const Image& image, std::size_t index) {
    switch (image.sample) {
        case Sample::u8:
            return static_cast<float>(image.as<std::uint8_t>()[index]) / 255.0F;
        case Sample::u16:
            return static_cast<float>(image.as<std::uint16_t>()[index]) / 65535.0F;
        case Sample::f32:
            return image.as<float>()[index];
    }
    return 0.0F;
}

float clipped(float v) { return v > 0.0F ? std::min(v, 1.0F) : 0.0F; }  // NaN -> 0

/// R, G, B, A of pixel `i` of any channel count.
std::array<float, 4> rgba_at(const Image& image, std::size_t i) {
    const std::size_t first = i * image.channels;
    const bool is_color = image.channels >= 3;
    const bool has_alpha = image.channels == 2 || image.channels == 4;
    const float r = value_at(image, first);
    return {r, is_color ? value_at(image, first + 1) : r, is_color ? value_at(image, first + 2) : r,
            has_alpha ? value_at(image, first + image.channels - 1) : 1.0F};
}

/// The values of a layer that is no colour: as they are, three channels at most, absent ones 0.
Image as_stored(const Layer& layer) {
    Image out(layer.image.size, 4, Sample::f32);
    const auto to = out.as<float>();
    const std::size_t count = std::min<std::size_t>(layer.image.channels, 3);
    for (std::size_t i = 0; i < to.size() / 4; ++i) {
        for (std::size_t c = 0; c < count; ++c)
            to[i * 4 + c] = value_at(layer.image, i * layer.image.channels + c);
        to[i * 4 + 3] = 1.0F;
    }
    return out;
}

/// |a - b|, where both being NaN, or the same infinity, is no difference and one of them is all of
/// it.
float distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0F;
    const float d = std::fabs(a - b);
    return std::isnan(d) ? std::numeric_limits<float>::infinity() : d;
}

/// Black, red, yellow, white by thirds of the error's square root, so that small errors are seen.
void paint(float error, std::uint8_t* rgb) {
    const float t = 3.0F * std::sqrt(clipped(error));
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = static_cast<std::uint8_t>(255.0F * clipped(t - static_cast<float>(c)) + 0.5F);
}

/// Magma (van der Walt & Smith 2015, of matplotlib, CC0) at quarters: even steps of lightness, as
/// FLIP is shown.
constexpr std::array<std::array<float, 3>, 5> magma{{{0.0F, 0.0F, 4.0F},
                                                     {81.0F, 18.0F, 124.0F},
                                                     {183.0F, 55.0F, 121.0F},
                                                     {252.0F, 137.0F, 97.0F},
                                                     {252.0F, 253.0F, 191.0F}}};

Image painted_flip(const Image& map) {
    Image out(map.size, 3, Sample::u8);
    const auto errors = map.as<float>();
    const auto to = out.as<std::uint8_t>();
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float at = clipped(errors[i]) * 4.0F;
        const auto below = std::min(static_cast<std::size_t>(at), std::size_t{3});
        const float share = at - static_cast<float>(below);
        for (std::size_t c = 0; c < 3; ++c)
            to[i * 3 + c] = static_cast<std::uint8_t>(magma[below][c] * (1.0F - share) +
                                                      magma[below + 1][c] * share + 0.5F);
    }
    return out;
}

/// Linear light, f32 [height, width, 4]: radiance of scene-linear files, else what is shown,
/// decoded.
Image linear(const Picture& picture, const Image& shown) {
    Image out = shown;
    const auto to = out.as<float>();
    const bool is_linear = tables::row(picture.format).scene_linear;
    const Layer* const layer = beauty(picture);
    constexpr float most = 1e30F;
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (i % 4 == 3) continue;
        if (!is_linear) {
            to[i] = math::linear_from_srgb(to[i]);
            continue;
        }
        const float v = rgba_at(layer->image, i / 4)[i % 4];
        to[i] = v > 0.0F ? std::min(v, most) : 0.0F;
    }
    return out;
}

double relative_mse(const Image& reference, const Image& test, Pixels pixels) {
    constexpr double darkest2 = 1e-2;
    double sum = 0.0;
    std::uint64_t count = 0;
    const auto a = reference.as<float>();
    const auto b = test.as<float>();
    for (std::size_t i = 0; i < a.size(); i += 4) {
        if (pixels == Pixels::covered && (a[i + 3] <= 0.5F || b[i + 3] <= 0.5F)) continue;
        ++count;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto x = static_cast<double>(a[i + c]);
            const double d = x - static_cast<double>(b[i + c]);
            sum += d * d / (x * x + darkest2);
        }
    }
    return sum / (3.0 * static_cast<double>(std::max<std::uint64_t>(count, 1)));
}

Difference measure(const Image& a, const Image& b, Pixels pixels) {
    Difference out;
    out.heat = Image(a.size, 3, Sample::u8);
    const auto heat = out.heat.as<std::uint8_t>();
    const auto va = a.as<float>();
    const auto vb = b.as<float>();
    double sum = 0.0;
    for (std::size_t i = 0; i < va.size() / 4; ++i) {
        if (pixels == Pixels::covered && (va[i * 4 + 3] <= 0.5F || vb[i * 4 + 3] <= 0.5F)) continue;
        float largest = 0.0F;
        for (std::size_t c = 0; c < 3; ++c) {
            const float d = distance(va[i * 4 + c], vb[i * 4 + c]);
            largest = std::max(largest, d);
            sum += static_cast<double>(d) * static_cast<double>(d);
        }
        paint(largest, heat.data() + i * 3);
        out.max_error = std::max(out.max_error, static_cast<double>(largest));
        ++out.pixel_count;
    }
    out.rmse =
        std::sqrt(sum / (3.0 * static_cast<double>(std::max<std::uint64_t>(out.pixel_count, 1))));
    out.psnr_db =
        out.rmse > 0.0 ? -20.0 * std::log10(out.rmse) : std::numeric_limits<double>::infinity();
    return out;
}

/// A layer of both pictures. Errors: input_invalid.
base::Result<std::pair<Image, Image>> both(const Picture& a, const Picture& b,
                                           const std::string& layer) {
    if (layer.empty()) return std::pair(shown(a), shown(b));
    const Layer* const in_a = find_layer(a, layer);
    const Layer* const in_b = find_layer(b, layer);
    if (in_a == nullptr || in_b == nullptr)
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .what = "the layer is not in both pictures",
                           .found = layer,
                           .remedy = "render both with --aov " + layer});
    return std::pair(as_stored(*in_a), as_stored(*in_b));
}

}  // namespace

Image shown(const Picture& picture) {
    const Layer* const layer = beauty(picture);
    if (layer == nullptr) return {};
    const bool is_linear = tables::row(picture.format).scene_linear;
    Image out(layer->image.size, 4, Sample::f32);
    const auto to = out.as<float>();
    for (std::size_t i = 0; i < to.size() / 4; ++i) {
        auto rgba = rgba_at(layer->image, i);
        const float alpha = clipped(rgba[3]);
        for (std::size_t c = 0; c < 3; ++c) {
            // EXR's alpha is associated.
            if (is_linear && alpha > 0.0F && alpha < 1.0F) rgba[c] /= alpha;
            const float v = clipped(rgba[c]);
            to[i * 4 + c] = is_linear ? math::srgb_from_linear(v) : v;
        }
        to[i * 4 + 3] = alpha;
    }
    return out;
}

base::Result<Difference> compare(const Picture& a, const Picture& b,
                                 const CompareOptions& options) {
    const auto images = both(a, b, options.layer);
    if (!images) return tl::unexpected(images.error());
    const auto& [first, second] = *images;
    if (first.size != second.size)
        return base::fail(
            {.code = base::ErrorCode::input_invalid,
             .what = "the pictures differ in size",
             .found = fmt::format("{}x{} and {}x{}", first.size.width, first.size.height,
                                  second.size.width, second.size.height),
             .remedy = "render both at one --size"});
    Difference out = measure(first, second, options.pixels);
    if (out.pixel_count == 0)
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .what = "no pixel is covered in both pictures",
                           .found = {},
                           .remedy = "compare without --mask"});
    if (!options.layer.empty()) return out;
    const Image light_a = linear(a, first);
    const Image light_b = linear(b, second);
    out.relative_mse = relative_mse(light_a, light_b, options.pixels);
    if (options.pixels != Pixels::all) return out;
    out.flip_is_hdr = tables::row(a.format).scene_linear && tables::row(b.format).scene_linear;
    const Image map = out.flip_is_hdr ? hdr_flip_map(light_a, light_b) : flip_map(first, second);
    out.flip = mean_of(map);
    if (options.heat == Heat::flip) out.heat = painted_flip(map);
    return out;
}

}  // namespace facet::image
