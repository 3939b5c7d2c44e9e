// The images that materials use, as the tracer reads them.
// SPDX-License-Identifier: MIT
#include "trace/textures.h"

#include "image/mips.h"
#include "math/color.h"

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

/// Texel `i` of `count` as GL wraps it (OpenGL 4.5, 8.14.2).
int wrapped(int i, int count, scene::Wrap wrap) {
    if (i >= 0 && i < count) return i;
    switch (wrap) {
        case scene::Wrap::clamp:
            return std::clamp(i, 0, count - 1);
        case scene::Wrap::mirror: {
            const int period = 2 * count;
            const int at = ((i % period) + period) % period;
            return at < count ? at : period - 1 - at;
        }
        case scene::Wrap::repeat:
            break;
    }
    return ((i % count) + count) % count;
}

Vec4 texel(const std::uint8_t* pixels, const Decode& decode) {
    return {decode[pixels[0]], decode[pixels[1]], decode[pixels[2]],
            static_cast<float>(pixels[3]) * (1.0F / 255.0F)};
}

/// Keeps coordinates that a file made absurd within what int can count.
float tame(float x) { return std::isfinite(x) ? std::clamp(x, -1e6F, 1e6F) : 0.0F; }

}  // namespace

Textures Textures::build(const scene::Scene& scene, base::ThreadPool& pool) {
    Textures out;
    out.images_.resize(scene.images.size());
    std::vector<std::pair<std::size_t, bool>> wanted;
    for (const scene::Material& material : scene.materials)
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
            if (!material.textures[slot]) continue;
            const std::size_t image = material.textures[slot]->image.index;
            const bool srgb = tables::material_textures[slot].space == tables::Space::srgb;
            if (scene.images[image].pixels == nullptr) continue;
            if (std::find(wanted.begin(), wanted.end(), std::pair(image, srgb)) == wanted.end())
                wanted.emplace_back(image, srgb);
        }
    pool.parallel_for(wanted.size(), [&](std::size_t i) {
        const auto [image, srgb] = wanted[i];
        out.images_[image][srgb ? 1 : 0] = {
            image::build_mips(image::to_rgba8(*scene.images[image].pixels), srgb), srgb};
    });
    return out;
}

const MipImage* Textures::find(scene::ImageId image, tables::Space space) const {
    const MipImage& found = images_[image.index][space == tables::Space::srgb ? 1 : 0];
    return found.levels.empty() ? nullptr : &found;
}

math::Extent Textures::size(scene::ImageId image) const {
    for (const MipImage& mips : images_[image.index])
        if (!mips.levels.empty()) return mips.levels.front().size;
    return {1, 1};
}

Vec4 Textures::sample(const scene::Texture& texture, tables::Space space, Vec2 uv,
                      float lod) const {
    const MipImage* mips = find(texture.image, space);
    if (mips == nullptr) return Vec4(1.0F);
    const auto last = static_cast<float>(mips->levels.size() - 1);
    const auto level = static_cast<std::size_t>(std::clamp(lod + 0.5F, 0.0F, last));
    const image::Image& image = mips->levels[level];
    const Decode& decode = decode_of(mips->srgb);
    const auto width = static_cast<int>(image.size.width);
    const auto height = static_cast<int>(image.size.height);
    const auto at = [&](int x, int y) {
        const auto row = static_cast<std::size_t>(wrapped(y, height, texture.wrap_v));
        const auto column = static_cast<std::size_t>(wrapped(x, width, texture.wrap_u));
        return reinterpret_cast<const std::uint8_t*>(image.bytes.data()) +
               (row * image.size.width + column) * 4;
    };
    const float x = tame(uv.x) * static_cast<float>(width);
    const float y = tame(uv.y) * static_cast<float>(height);
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
