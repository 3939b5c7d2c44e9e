// An AOV as a picture that a person can look at.
// SPDX-License-Identifier: MIT
#include "render/viewable.h"

#include "math/color.h"

#include <algorithm>
#include <cmath>

namespace facet::render {
namespace {

using tables::PngCode;

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
struct FiniteRange {
    float low = INFINITY;
    float high = -INFINITY;
    explicit FiniteRange(std::span<const float> values) {
        for (const float v : values)
            if (std::isfinite(v)) {
                low = std::min(low, v);
                high = std::max(high, v);
            }
        if (low < high) return;
        low = 0.0F;
        high = 1.0F;
    }
};

float coded(float v, PngCode code, const FiniteRange& range) {
    switch (code) {
        case PngCode::signed_unit:
            return v * 0.5F + 0.5F;
        case PngCode::range:
            return std::isfinite(v) ? (v - range.low) / (range.high - range.low) : 1.0F;
        case PngCode::compressed:
            return std::isfinite(v) ? v / (1.0F + v) : 1.0F;
        case PngCode::clamp:
        case PngCode::exposed:
        case PngCode::id_color:
            break;
    }
    return v;
}

}  // namespace

image::Image viewable(tables::Aov aov, const image::Layer& layer, double exposure) {
    const tables::AovRow& row = tables::row(aov);
    const auto values = layer.image.as<float>();
    const std::size_t channels = layer.image.channels;
    const float factor = row.png == PngCode::exposed ? static_cast<float>(exposure) : 1.0F;
    const FiniteRange range(row.png == PngCode::range ? values : std::span<const float>{});
    image::Image out(layer.image.size, 3, image::Sample::u8);
    const auto codes = out.as<std::uint8_t>();
    for (std::size_t i = 0; i < values.size() / channels; ++i) {
        const float* v = values.data() + i * channels;
        math::Vec3 color = channels == 3 ? math::Vec3(v[0], v[1], v[2]) : math::Vec3(v[0]);
        if (row.png == PngCode::id_color) color = id_color(v[0]);
        for (int c = 0; c < 3; ++c) {
            float shown = std::clamp(coded(color[c] * factor, row.png, range), 0.0F, 1.0F);
            if (row.space != tables::Space::none) shown = math::srgb_from_linear(shown);
            codes[i * 3 + static_cast<std::size_t>(c)] =
                static_cast<std::uint8_t>(std::lround(shown * 255.0F));
        }
    }
    return out;
}

}  // namespace facet::render
