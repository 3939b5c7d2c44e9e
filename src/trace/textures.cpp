// The images that materials use, as the tracer reads them.
// SPDX-License-Identifier: MIT
#include "trace/textures.h"

#include "image/mips.h"
#include "math/color.h"
#include "scene/wrap.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec4;

using Decode = std::array<float, 256>;

Decode make_decode(bool srgb) {
    Decode table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float code = static_cast<float>(i) / 255.0F;
        table[i] = srgb ? math::linear_from_srgb(code) : code;
    }
    return table;
}
/// Made once, on first use, and never changed.
const Decode& decode_of(bool srgb) {
    static const Decode encoded = make_decode(true);
    static const Decode plain = make_decode(false);
    return srgb ? encoded : plain;
}

Vec4 texel(const std::uint8_t* pixels, const Decode& decode) {
    return {decode[pixels[0]], decode[pixels[1]], decode[pixels[2]],
            static_cast<float>(pixels[3]) * (1.0F / 255.0F)};
}

}  // namespace

Textures Textures::build(const scene::Scene& scene, base::ThreadPool& pool) {
    Textures out;
    out.images_.resize(scene.images.size());
    std::vector<std::pair<std::size_t, tables::Texels>> wanted;
    for (const scene::Material& material : scene.materials)
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
            if (!material.textures[slot] || tables::material_textures[slot].is_relief) continue;
            const std::pair use(std::size_t{material.textures[slot]->image.index},
                                tables::texels_of(tables::material_textures[slot]));
            if (scene.images[use.first].pixels == nullptr) continue;
            if (std::find(wanted.begin(), wanted.end(), use) == wanted.end()) wanted.push_back(use);
        }
    pool.parallel_for(wanted.size(), [&](std::size_t i) {
        const auto [image, texels] = wanted[i];
        out.images_[image][static_cast<std::size_t>(texels)] =
            image::build_mips(image::to_rgba8(*scene.images[image].pixels), texels);
    });
    return out;
}

const MipImage* Textures::find(scene::ImageId image, tables::Texels texels) const {
    const MipImage& found = images_[image.index][static_cast<std::size_t>(texels)];
    return found.empty() ? nullptr : &found;
}

math::Extent Textures::size(scene::ImageId image) const {
    for (const MipImage& levels : images_[image.index])
        if (!levels.empty()) return levels.front().size;
    return {1, 1};
}

Vec4 Textures::sample(const scene::Texture& texture, tables::Texels texels, Vec2 uv,
                      float lod) const {
    const MipImage* levels = find(texture.image, texels);
    if (levels == nullptr) return Vec4(1.0F);
    const auto last = static_cast<float>(levels->size() - 1);
    const auto level = static_cast<std::size_t>(std::clamp(lod + 0.5F, 0.0F, last));
    const image::Image& image = (*levels)[level];
    const Decode& decode = decode_of(texels == tables::Texels::colors);
    const auto width = static_cast<int>(image.size.width);
    const auto height = static_cast<int>(image.size.height);
    const auto at = [&](int x, int y) {
        const auto row = static_cast<std::size_t>(scene::wrapped(y, height, texture.wrap_v));
        const auto column = static_cast<std::size_t>(scene::wrapped(x, width, texture.wrap_u));
        return reinterpret_cast<const std::uint8_t*>(image.bytes.data()) +
               (row * image.size.width + column) * 4;
    };
    const float x = scene::tame(uv.x) * static_cast<float>(width);
    const float y = scene::tame(uv.y) * static_cast<float>(height);
    if (texture.nearest && level == 0)
        return texel(at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))), decode);
    const float left = std::floor(x - 0.5F);
    const float top = std::floor(y - 0.5F);
    const float across = x - 0.5F - left;
    const float down = y - 0.5F - top;
    const auto x0 = static_cast<int>(left);
    const auto y0 = static_cast<int>(top);
    const Vec4 upper =
        texel(at(x0, y0), decode) * (1.0F - across) + texel(at(x0 + 1, y0), decode) * across;
    const Vec4 lower = texel(at(x0, y0 + 1), decode) * (1.0F - across) +
                       texel(at(x0 + 1, y0 + 1), decode) * across;
    return upper * (1.0F - down) + lower * down;
}

}  // namespace facet::trace
