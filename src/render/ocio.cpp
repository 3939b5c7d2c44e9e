// A picture as a view of OpenColorIO shows it.
// SPDX-License-Identifier: MIT
#include "render/ocio.h"

#include "image/oiio.h"
#include "math/color.h"
#include "render/plan.h"

#include <algorithm>
#include <cmath>

namespace facet::render {
namespace {

/// What a code can hold; 0 for what is no number.
float unit(float value) { return value > 0.0F ? std::min(value, 1.0F) : 0.0F; }

void set_code(image::Image& image, std::size_t at, float value) {
    if (image.sample == image::Sample::u16)
        image.as<std::uint16_t>()[at] = static_cast<std::uint16_t>(std::lround(value * 65535.0F));
    else
        image.as<std::uint8_t>()[at] = static_cast<std::uint8_t>(std::lround(value * 255.0F));
}

}  // namespace

base::Result<image::Image> ocio_picture(image::Image radiance, double exposure, const Plan& plan) {
    const auto values = radiance.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float coverage = values[i + 3];
        math::Vec3 color(values[i], values[i + 1], values[i + 2]);
        color = coverage > 0.0F ? plan.balance * color * (static_cast<float>(exposure) / coverage)
                                : math::Vec3(0.0F);
        for (std::size_t c = 0; c < 3; ++c) values[i + c] = color[static_cast<int>(c)];
    }
    if (auto shown = image::oiio::show(radiance, plan.ocio_display, plan.ocio_view); !shown)
        return tl::unexpected(base::in_file(shown.error(), "--tonemap"));
    image::Image out(radiance.size, 4, plan.display_sample);
    const bool is_laid = plan.background.kind == frame::BackgroundKind::color;
    math::Vec4 under(0.0F);
    for (int c = 0; is_laid && c < 4; ++c)
        under[c] = c == 3 ? 1.0F : math::srgb_from_linear(plan.background.color[c]);
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float coverage = unit(values[i + 3]);
        math::Vec4 shown(unit(values[i]), unit(values[i + 1]), unit(values[i + 2]), 1.0F);
        if (is_laid)
            // In codes: what a display of OpenColorIO makes of light is not known here.
            shown = shown * coverage + under * (1.0F - coverage);
        else
            shown.w = coverage;
        for (std::size_t c = 0; c < 4; ++c) set_code(out, i + c, shown[static_cast<int>(c)]);
    }
    return out;
}

}  // namespace facet::render
