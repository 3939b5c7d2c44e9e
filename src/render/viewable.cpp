// An AOV as a picture that a person can look at.
// SPDX-License-Identifier: MIT
#include "render/viewable.h"

#include "math/color.h"
#include "tables/aovs.h"

#include <algorithm>
#include <cmath>

namespace facet::render {
namespace {

const tables::AovRow& row_of(std::string_view key) {
    return *std::find_if(tables::aovs.begin(), tables::aovs.end(),
                         [&](const tables::AovRow& row) { return row.key == key; });
}

/// A colour an id that stays apart from its neighbours': the golden ratio's turns of hue.
math::Vec3 id_color(float id) {
    if (id == 0.0F) return math::Vec3(0.0F);
    const float hue = std::fmod(id * 0.618033988F, 1.0F) * 6.0F;
    const auto channel = [&](float at) {
        const float d = std::fabs(std::fmod(hue - at + 9.0F, 6.0F) - 3.0F);
        return std::clamp(d - 1.0F, 0.15F, 0.95F);
    };
    return {channel(0.0F), channel(2.0F), channel(4.0F)};
}

/// The finite values' ends, for AOVs without a natural range.
std::pair<float, float> finite_range(std::span<const float> values) {
    float low = INFINITY;
    float high = -INFINITY;
    for (const float v : values)
        if (std::isfinite(v)) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    return low < high ? std::pair(low, high) : std::pair(0.0F, 1.0F);
}

}  // namespace

image::Image viewable(const image::Layer& layer, float) {
    const tables::AovRow& row = row_of(layer.name);
    const auto values = layer.image.as<float>();
    const std::size_t channels = layer.image.channels;
    const auto [low, high] = finite_range(values);
    image::Image out(layer.image.size, 3, image::Sample::u8);
    const auto codes = out.as<std::uint8_t>();
    for (std::size_t i = 0; i < values.size() / channels; ++i) {
        math::Vec3 color;
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = values[i * channels + (channels == 3 ? c : 0)];
            float shown = v;
            if (row.png == tables::PngCode::signed_unit) shown = v * 0.5F + 0.5F;
            if (row.png == tables::PngCode::range)
                shown = std::isfinite(v) ? (v - low) / (high - low) : 1.0F;
            color[static_cast<int>(c)] = shown;
        }
        if (row.png == tables::PngCode::id_color) color = id_color(values[i * channels]);
        for (std::size_t c = 0; c < 3; ++c) {
            float shown = std::clamp(color[static_cast<int>(c)], 0.0F, 1.0F);
            if (row.space != tables::Space::none) shown = math::srgb_from_linear(shown);
            codes[i * 3 + c] = static_cast<std::uint8_t>(std::lround(shown * 255.0F));
        }
    }
    return out;
}

}  // namespace facet::render
