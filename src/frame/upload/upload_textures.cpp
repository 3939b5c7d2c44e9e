// The images that materials use, as GL textures with mips.
// SPDX-License-Identifier: MIT
#include "frame/upload/upload_textures.h"

#include "image/mips.h"

namespace facet::frame {
namespace {

base::Result<gl::Texture> upload_levels(const gl::Context& gl,
                                        const std::vector<image::Image>& levels,
                                        tables::Space space) {
    const gl::TextureSpec spec{
        .format = static_cast<GLenum>(space == tables::Space::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8),
        .size = levels.front().size,
        .levels = static_cast<GLsizei>(levels.size())};
    auto texture = gl::make_texture(gl, spec);
    if (!texture) return texture;
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl::upload(gl, *texture, spec, static_cast<GLint>(level), 0, {}, levels[level].bytes);
    return texture;
}

}  // namespace

base::Result<std::map<TextureUse, std::size_t>> upload_textures(const gl::Context& gl,
                                                                const scene::Scene& scene,
                                                                base::ThreadPool& pool,
                                                                GpuScene& out) {
    std::map<TextureUse, std::size_t> uses;
    std::vector<TextureUse> order;
    for (const scene::Material& material : scene.materials)
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
            if (!material.textures[slot]) continue;
            const std::uint32_t image = material.textures[slot]->image.index;
            if (scene.images[image].pixels == nullptr) continue;
            const TextureUse use{image, tables::material_textures[slot].space};
            if (uses.emplace(use, order.size()).second) order.push_back(use);
        }
    std::vector<std::vector<image::Image>> levels(order.size());
    pool.parallel_for(order.size(), [&](std::size_t i) {
        const image::Image& pixels = *scene.images[order[i].first].pixels;
        levels[i] =
            image::build_mips(image::to_rgba8(pixels), order[i].second == tables::Space::srgb);
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        auto texture = upload_levels(gl, levels[i], order[i].second);
        if (!texture)
            return tl::unexpected(
                base::in_file(texture.error(), scene.images[order[i].first].name));
        out.textures.push_back(std::move(*texture));
        levels[i].clear();
    }
    return uses;
}

}  // namespace facet::frame
