// Picture files as textures of materials.
// SPDX-License-Identifier: MIT
#include "scene/set_texture.h"

#include "base/file.h"
#include "image/read.h"
#include "scene/builtin_files.h"
#include "scene/spec.h"
#include "scene/tangents.h"

#include <algorithm>

namespace facet::scene {
namespace {

/// The image that `file` holds, read at most once.
base::Result<ImageId> image_of(Scene& scene, const std::string& file, const base::Limits& limits) {
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        if (scene.images[i].is_added && scene.images[i].name == file)
            return ImageId{static_cast<std::uint32_t>(i)};
    const auto path = file_of(file, builtin_textures);
    if (!path) return tl::unexpected(path.error());
    const auto bytes = base::read_file(*path, limits.file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    base::Warnings warnings;
    auto pixels = image::decode(*bytes, limits, warnings);
    if (!pixels) return tl::unexpected(pixels.error());
    if (pixels->sample == image::Sample::f32)
        return usage_error("textures have codes, not radiance", file, "a PNG, JPEG, WebP or TIFF");
    scene.images.push_back({file, std::make_shared<const image::Image>(std::move(*pixels)), true});
    return ImageId{static_cast<std::uint32_t>(scene.images.size() - 1)};
}

bool is_one_of(std::span<const std::size_t> materials, const Mesh& mesh) {
    return std::find(materials.begin(), materials.end(), mesh.material.index) != materials.end();
}

bool has_coordinates(const Scene& scene, std::span<const std::size_t> materials,
                     std::uint32_t uv_set) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
        return is_one_of(materials, mesh) && !mesh.uv(uv_set).empty();
    });
}

}  // namespace

base::Status set_texture(Scene& scene, std::span<const std::size_t> materials, std::size_t slot,
                         const std::string& file, const base::Limits& limits) {
    if (!tables::material_textures[slot].is_ramp && !has_coordinates(scene, materials, 0))
        return usage_error("the material's meshes have no texture coordinates", file,
                           "unwrap them where they were modelled");
    const auto image = image_of(scene, file, limits);
    if (!image) return tl::unexpected(base::in_file(image.error(), file));
    for (const std::size_t i : materials) {
        auto& texture = scene.materials[i].textures[slot];
        texture = texture.value_or(Texture{});
        texture->image = *image;
    }
    generate_missing_tangents(scene);
    return {};
}

}  // namespace facet::scene
