// The pictures of lessons, rendered.
// SPDX-License-Identifier: MIT
#include "teach/gallery.h"

#include "base/cache_folder.h"
#include "base/text.h"
#include "image/mips.h"
#include "image/write.h"
#include "render/render.h"
#include "render/viewable.h"
#include "scene/load.h"
#include "tables/settings_text.h"

#include <algorithm>

namespace facet::teach {
namespace {

tables::Settings settings_of(const Picture& picture) {
    tables::Settings settings = picture.settings;
    if (!picture.show.empty()) settings.aov = {picture.show};
    return settings;
}

/// RGB with the alpha of the picture that it belongs to.
image::Image with_coverage(const image::Image& rgb, const image::Image& picture) {
    if (rgb.channels != 3 || picture.channels != 4 || picture.size != rgb.size) return rgb;
    image::Image out(rgb.size, 4, image::Sample::u8);
    const auto from = rgb.as<std::uint8_t>();
    const auto alpha = image::to_rgba8(picture);
    const auto cover = alpha.as<std::uint8_t>();
    const auto to = out.as<std::uint8_t>();
    for (std::size_t i = 0; i < to.size() / 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) to[i * 4 + c] = from[i * 3 + c];
        to[i * 4 + 3] = cover[i * 4 + 3];
    }
    return out;
}

/// The AOV as it is looked at, transparent where no surface is.
base::Result<image::Image> shown(const Picture& picture, const render::Rendered& rendered) {
    if (picture.show.empty()) return rendered.display;
    for (const image::Layer& layer : rendered.layers)
        if (layer.name == picture.show)
            return with_coverage(
                render::viewable(*tables::aov_named(picture.show), layer, rendered.exposure),
                rendered.display);
    return base::fail({.what = "the picture has no such AOV", .found = picture.show});
}

}  // namespace

std::string command_of(const Picture& picture) {
    return tables::command_line(tables::command_words("render", picture.scene, settings_of(picture),
                                                      scene::stem_of(picture.scene) + ".png"));
}

base::Result<const Shot*> Gallery::shot(const Picture& picture) {
    const std::string command = command_of(picture);
    const std::string key = picture.show + "\n" + command;
    if (const auto known = shots_.find(key); known != shots_.end()) return &known->second;
    const auto rendered = render::render({.scene = picture.scene,
                                          .settings = settings_of(picture),
                                          .cache_folder = base::cache_folder()},
                                         *log_);
    if (!rendered) return tl::unexpected(rendered.error());
    const auto image = shown(picture, *rendered);
    if (!image) return tl::unexpected(image.error());
    const auto bytes = image::encode(*image, {.format = tables::ImageFormat::webp});
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    Shot shot{.size = image->size,
              .data_uri = "data:image/webp;base64," + base::base64(text),
              .command = command};
    return &shots_.emplace(key, std::move(shot)).first->second;
}

}  // namespace facet::teach
