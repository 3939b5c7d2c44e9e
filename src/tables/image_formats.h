// The picture formats: image_formats.def's expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace facet::tables {

enum class ImageFormat : std::size_t {
#define FORMAT(name, ...) name,
#include "tables/image_formats.def"
};

/// One row of image_formats.def.
struct ImageFormatRow {
    std::string_view key;
    std::string_view endings;  ///< comma list, lower case, without the dot
    bool reads = false;
    bool writes = false;
    std::string_view depths;    ///< comma list of what --depth takes; the first is the default
    bool scene_linear = false;  ///< holds radiance in nit, before exposure and tone mapping
    bool layers = false;        ///< AOVs go inside
    bool alpha = true;          ///< holds what a picture does not cover
    bool slow_module = false;   ///< through OpenImageIO, in the module opened at first need
    std::string_view help;
};
inline constexpr auto image_formats = std::to_array<ImageFormatRow>({
#define FORMAT(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/image_formats.def"
});
[[nodiscard]] constexpr const ImageFormatRow& row(ImageFormat format) {
    return image_formats[static_cast<std::size_t>(format)];
}

}  // namespace facet::tables
