// A picture as a view of OpenColorIO shows it.
// SPDX-License-Identifier: MIT
#include "render/ocio.h"

#include "image/oiio.h"
#include "math/blackbody.h"
#include "math/color.h"
#include "render/plan.h"

#include <algorithm>
#include <cmath>

namespace facet::render {

base::Result<image::Image> ocio_picture(image::Image radiance, double exposure, const Plan& plan) {
    math::Mat3 balance(1.0F);
    if (plan.white_balance_k)
        balance = math::adapted_from(math::blackbody_color(*plan.white_balance_k));
    const auto values = radiance.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float coverage = values[i + 3];
        math::Vec3 color(values[i], values[i + 1], values[i + 2]);
        color = coverage > 0.0F ? balance * color * (static_cast<float>(exposure) / coverage)
                                : math::Vec3(0.0F);
        for (std::size_t c = 0; c < 3; ++c) values[i + c] = color[static_cast<int>(c)];
    }
    if (auto shown = image::oiio::show(radiance, plan.ocio_display, plan.ocio_view); !shown)
        return tl::unexpected(base::in_file(shown.error(), "--tonemap"));
    image::Image out(radiance.size, 4, plan.display_sample);
    const bool is_laid = plan.background.kind == frame::BackgroundKind::color;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t c = i % 4;
        const float coverage = std::clamp(values[i - c + 3], 0.0F, 1.0F);
        float value = c == 3 ? coverage : std::clamp(values[i], 0.0F, 1.0F);
        if (is_laid) {
            const float under =
                c == 3 ? 1.0F : math::srgb_from_linear(plan.background.color[static_cast<int>(c)]);
            value = c == 3 ? 1.0F : value * coverage + under * (1.0F - coverage);
        }
        if (out.sample == image::Sample::u16)
            out.as<std::uint16_t>()[i] = static_cast<std::uint16_t>(std::lround(value * 65535.0F));
        else
            out.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(std::lround(value * 255.0F));
    }
    return out;
}

}  // namespace facet::render
