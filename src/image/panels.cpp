// Pictures side by side with captions.
// SPDX-License-Identifier: MIT
#include "image/panels.h"

#include "image/dotted_font.h"

#include <algorithm>
#include <array>

namespace facet::image {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb strip_color{24, 26, 30};
constexpr Rgb text_color{228, 230, 234};
constexpr Rgb title_color{255, 255, 255};
constexpr float under_alpha = 0.5F;
/// Advance of a character and of a line, in dots.
constexpr std::uint32_t advance = glyph_columns + 1;
constexpr std::uint32_t line_dots = glyph_rows + 3;
constexpr std::uint32_t margin_dots = 5;

std::uint64_t dots_of(char character) {
    for (const Glyph& glyph : dotted_font)
        if (glyph.character == character) return glyph.dots;
    return unknown_dots;
}

std::uint8_t sample(const Image& image, std::size_t index) {
    return image.sample == Sample::u16
               ? static_cast<std::uint8_t>((image.as<std::uint16_t>()[index] + 128U) / 257U)
               : image.as<std::uint8_t>()[index];
}

class Canvas {
public:
    explicit Canvas(math::Extent size) : image(size, 3, Sample::u8) {}

    void dot(std::uint32_t x, std::uint32_t y, std::uint32_t side, const Rgb& color) {
        for (std::uint32_t dy = 0; dy < side; ++dy)
            for (std::uint32_t dx = 0; dx < side; ++dx) put(x + dx, y + dy, color);
    }
    void put(std::uint32_t x, std::uint32_t y, const Rgb& color) {
        if (x >= image.size.width || y >= image.size.height) return;
        std::copy(color.begin(), color.end(),
                  image.as<std::uint8_t>().data() + (std::size_t{y} * image.size.width + x) * 3);
    }
    void text(std::uint32_t x, std::uint32_t y, std::uint32_t scale, const std::string& line,
              const Rgb& color) {
        for (const char character : line) {
            const std::uint64_t dots = dots_of(character);
            for (std::uint32_t i = 0; i < glyph_rows * glyph_columns; ++i)
                if (((dots >> i) & 1U) != 0)
                    dot(x + i % glyph_columns * scale, y + i / glyph_columns * scale, scale, color);
            x += advance * scale;
        }
    }
    void picture(std::uint32_t x0, const Image& from) {
        for (std::uint32_t y = 0; y < from.size.height; ++y)
            for (std::uint32_t x = 0; x < from.size.width; ++x) {
                const std::size_t at = (std::size_t{y} * from.size.width + x) * from.channels;
                const float alpha =
                    from.channels == 4 ? static_cast<float>(sample(from, at + 3)) / 255.0F : 1.0F;
                Rgb color{};
                for (std::size_t c = 0; c < 3; ++c)
                    color[c] =
                        static_cast<std::uint8_t>(static_cast<float>(sample(from, at + c)) * alpha +
                                                  255.0F * under_alpha * (1.0F - alpha) + 0.5F);
                put(x0 + x, y, color);
            }
    }

    Image image;
};

/// The largest whole scale at which every line fits the width and text stays a small part of the
/// picture.
std::uint32_t scale_for(std::span<const Panel> panels) {
    const math::Extent size = panels.front().picture->size;
    std::size_t longest = 1;
    for (const Panel& panel : panels)
        for (const std::string& line : panel.lines) longest = std::max(longest, line.size());
    const std::size_t by_width = size.width / (longest * advance + 2 * margin_dots);
    const std::size_t by_height = size.height / 240 + 1;
    return static_cast<std::uint32_t>(std::clamp<std::size_t>(std::min(by_width, by_height), 1, 8));
}

}  // namespace

Image side_by_side(std::span<const Panel> panels) {
    const math::Extent size = panels.front().picture->size;
    const std::uint32_t scale = scale_for(panels);
    std::size_t lines = 0;
    for (const Panel& panel : panels) lines = std::max(lines, panel.lines.size());
    const std::uint32_t strip =
        lines == 0 ? 0
                   : (static_cast<std::uint32_t>(lines) * line_dots + 2 * margin_dots - 3) * scale;
    const std::uint32_t gap = 2 * scale;
    const auto count = static_cast<std::uint32_t>(panels.size());
    Canvas canvas({count * size.width + (count - 1) * gap, size.height + strip});
    for (std::uint32_t y = 0; y < canvas.image.size.height; ++y)
        for (std::uint32_t x = 0; x < canvas.image.size.width; ++x) canvas.put(x, y, strip_color);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t x = i * (size.width + gap);
        canvas.picture(x, *panels[i].picture);
        for (std::size_t k = 0; k < panels[i].lines.size(); ++k)
            canvas.text(
                x + margin_dots * scale,
                size.height + (margin_dots + static_cast<std::uint32_t>(k) * line_dots) * scale,
                scale, panels[i].lines[k], k == 0 ? title_color : text_color);
    }
    return std::move(canvas.image);
}

}  // namespace facet::image
