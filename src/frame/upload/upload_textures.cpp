// The images that materials use, as GL textures with mips.
// SPDX-License-Identifier: MIT
#include "frame/upload/upload_textures.h"

#include "image/mips.h"

#include <algorithm>

namespace facet::frame {
namespace {

base::Result<gl::Texture> upload_levels(const gl::Context& gl,
                                        const std::vector<image::Image>& levels,
                                        tables::Texels texels) {
    const gl::TextureSpec spec{.format = static_cast<GLenum>(
                                   texels == tables::Texels::colors ? GL_SRGB8_ALPHA8 : GL_RGBA8),
                               .size = levels.front().size,
                               .levels = static_cast<GLsizei>(levels.size())};
    auto texture = gl::make_texture(gl, spec);
    if (!texture) return texture;
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl::upload(gl, *texture, spec, static_cast<GLint>(level), 0, {}, levels[level].bytes);
    return texture;
}

std::string name_of(const scene::Scene& scene, const image::Image& pixels) {
    for (const scene::SceneImage& image : scene.images)
        if (image.pixels.get() == &pixels) return image.name;
    return {};
}

}  // namespace

base::Status upload_textures(const gl::Context& gl, const scene::Scene& scene,
                             base::ThreadPool& pool, GpuScene& out) {
    std::vector<TextureUse> missing;
    for (const scene::Material& material : scene.materials)
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
            if (!material.textures[slot] || tables::material_textures[slot].is_relief) continue;
            const std::uint32_t image = material.textures[slot]->image.index;
            if (scene.images[image].pixels == nullptr) continue;
            const TextureUse use{scene.images[image].pixels,
                                 tables::texels_of(tables::material_textures[slot])};
            if (out.textures.contains(use) ||
                std::find(missing.begin(), missing.end(), use) != missing.end())
                continue;
            missing.push_back(use);
        }
    std::vector<std::vector<image::Image>> levels(missing.size());
    pool.parallel_for(missing.size(), [&](std::size_t i) {
        levels[i] = image::build_mips(image::to_rgba8(*missing[i].first), missing[i].second);
    });
    for (std::size_t i = 0; i < missing.size(); ++i) {
        auto texture = upload_levels(gl, levels[i], missing[i].second);
        if (!texture)
            return tl::unexpected(
                base::in_file(texture.error(), name_of(scene, *missing[i].first)));
        out.textures.emplace(missing[i], std::move(*texture));
        levels[i].clear();
    }
    return {};
}

}  // namespace facet::frame
