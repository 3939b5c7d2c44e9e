// The two workflows of the lecture.
// SPDX-License-Identifier: MIT
#include "scene/workflow.h"

#include "math/color.h"
#include "scene/dielectric.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::scene {
namespace {

using math::Vec4;
using tables::TextureSlot;

constexpr std::size_t index_of(TextureSlot slot) { return static_cast<std::size_t>(slot); }

/// The slots of a workflow, by what they tell.
constexpr std::array workflow_slots = {
    TextureSlot::base_color_texture, TextureSlot::metallic_roughness_texture,
    TextureSlot::specular_texture, TextureSlot::specular_color_texture};

/// A picture's codes as numbers from 0 to 1, at the nearest texel.
Vec4 texel(const image::Image& image, Vec2 uv) {
    const auto place = [](float at, std::uint32_t size) {
        return std::min(static_cast<std::uint32_t>(at * static_cast<float>(size)), size - 1);
    };
    const std::size_t at = (std::size_t{place(uv.y, image.size.height)} * image.size.width +
                            place(uv.x, image.size.width)) *
                           image.channels;
    const auto code = [&](std::size_t c) {
        if (image.sample == image::Sample::u16)
            return static_cast<float>(image.as<std::uint16_t>()[at + c]) / 65535.0F;
        return static_cast<float>(image.as<std::uint8_t>()[at + c]) / 255.0F;
    };
    const bool is_grey = image.channels < 3;
    const bool has_alpha = image.channels % 2 == 0;
    return {code(0), code(is_grey ? 0 : 1), code(is_grey ? 0 : 2),
            has_alpha ? code(image.channels - 1U) : 1.0F};
}

Vec3 linear(const Vec4& srgb) {
    return {math::linear_from_srgb(srgb.x), math::linear_from_srgb(srgb.y),
            math::linear_from_srgb(srgb.z)};
}

std::uint8_t code_of(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// One material's textures that have pixels.
class Maps {
public:
    Maps(const Scene& scene, const Material& material) : scene_(scene), material_(material) {}

    [[nodiscard]] const image::Image* pixels(TextureSlot slot) const {
        const auto& texture = material_.texture(slot);
        return texture ? scene_.images[texture->image.index].pixels.get() : nullptr;
    }
    /// A texture that shows nothing now, as its picture is missing: its say would be lost.
    [[nodiscard]] bool lack_pixels() const {
        return std::ranges::any_of(workflow_slots, [&](TextureSlot slot) {
            return material_.texture(slot).has_value() && pixels(slot) == nullptr;
        });
    }
    /// 1 where there is none.
    [[nodiscard]] Vec4 at(TextureSlot slot, Vec2 uv) const {
        const image::Image* const image = pixels(slot);
        return image == nullptr ? Vec4(1.0F) : texel(*image, uv);
    }
    /// The first of them that has pixels: how the others must lie.
    [[nodiscard]] const Texture* first() const {
        for (const TextureSlot slot : workflow_slots)
            if (pixels(slot) != nullptr) return &*material_.texture(slot);
        return nullptr;
    }
    [[nodiscard]] bool lie_alike() const {
        const Texture* const one = first();
        return std::ranges::all_of(workflow_slots, [&](TextureSlot slot) {
            if (pixels(slot) == nullptr) return true;
            const Texture& other = *material_.texture(slot);
            return other.uv_set == one->uv_set && other.uv_from_uv == one->uv_from_uv &&
                   other.wrap_u == one->wrap_u && other.wrap_v == one->wrap_v;
        });
    }
    [[nodiscard]] math::Extent largest() const {
        math::Extent out{1, 1};
        for (const TextureSlot slot : workflow_slots)
            if (const image::Image* const image = pixels(slot))
                out = {std::max(out.width, image->size.width),
                       std::max(out.height, image->size.height)};
        return out;
    }

private:
    const Scene& scene_;
    const Material& material_;
};

/// A picture of which `of` gives each texel's numbers from its place in [0, 1]^2.
template <class Of>
image::Image baked(math::Extent size, const Of& of) {
    image::Image out(size, 4, image::Sample::u8);
    const auto codes = out.as<std::uint8_t>();
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const Vec4 value = of((Vec2(x, y) + 0.5F) / Vec2(static_cast<float>(size.width),
                                                             static_cast<float>(size.height)));
            for (int c = 0; c < 4; ++c)
                codes[(std::size_t{y} * size.width + x) * 4 + static_cast<std::size_t>(c)] =
                    code_of(value[c]);
        }
    return out;
}

Texture add_picture(Scene& scene, const Texture& like, std::string name, image::Image picture) {
    Texture out = like;
    out.image = {static_cast<std::uint32_t>(scene.images.size())};
    scene.images.push_back({.name = std::move(name),
                            .pixels = std::make_shared<const image::Image>(std::move(picture))});
    return out;
}

Vec4 in_srgb(const Vec3& c, float alpha) {
    return {math::srgb_from_linear(c.x), math::srgb_from_linear(c.y), math::srgb_from_linear(c.z),
            alpha};
}

void to_metallic(Scene& scene, Material& material) {
    const Maps maps(scene, material);
    material.has_glossiness = false;
    if (maps.pixels(TextureSlot::specular_color_texture) == nullptr) return;
    const Texture like = *material.texture(TextureSlot::specular_color_texture);
    const float glossiness = 1.0F - material.values.roughness;
    image::Image rough =
        baked(maps.pixels(TextureSlot::specular_color_texture)->size, [&](Vec2 uv) {
            const float a = maps.at(TextureSlot::specular_color_texture, uv).w;
            return Vec4(0.0F, 1.0F - glossiness * a, 0.0F, 1.0F);
        });
    material.textures[index_of(TextureSlot::metallic_roughness_texture)] =
        add_picture(scene, like, material.name + "-roughness", std::move(rough));
    material.values.roughness = 1.0F;
}

/// What both workflows are made of, at one place.
struct Reflecting {
    Vec3 diffuse;
    Vec3 specular;
    float glossiness;
};
Reflecting reflecting(const tables::MaterialValues& v, const Maps& maps, Vec2 uv) {
    const Vec3 base = v.base_color * linear(maps.at(TextureSlot::base_color_texture, uv));
    const Vec4 orm = maps.at(TextureSlot::metallic_roughness_texture, uv);
    const Vec3 tint = linear(maps.at(TextureSlot::specular_color_texture, uv));
    const float metallic = v.metallic * orm.z;
    const Vec3 f0 = glm::min(dielectric_f0(v) * tint, Vec3(1.0F)) *
                    (v.specular * maps.at(TextureSlot::specular_texture, uv).w);
    // Diffuse light is what reflection leaves: as much of it either way, seen straight on.
    const auto left = [](const Vec3& c) { return 1.0F - std::max({c.x, c.y, c.z}); };
    const Vec3 specular = glm::mix(f0, base, metallic);
    const float share = left(specular) > 0.0F ? left(f0) / left(specular) : 0.0F;
    return {glm::min(base * ((1.0F - metallic) * share), Vec3(1.0F)), specular,
            1.0F - v.roughness * orm.y};
}

void set_glossiness(Material& material) {
    material.has_glossiness = true;
    material.values.metallic = 0.0F;
    material.values.ior = 0.0F;
    material.values.specular = 1.0F;
}

void to_glossiness(Scene& scene, Material& material) {
    const Maps maps(scene, material);
    const tables::MaterialValues values = material.values;
    const Texture* const like = maps.first();
    if (like == nullptr) {
        const Reflecting r = reflecting(values, maps, Vec2(0.0F));
        material.values.base_color = r.diffuse;
        material.values.specular_color = r.specular;
    } else {
        const math::Extent size = maps.largest();
        image::Image diffuse = baked(size, [&](Vec2 uv) {
            return in_srgb(reflecting(values, maps, uv).diffuse,
                           maps.at(TextureSlot::base_color_texture, uv).w);
        });
        image::Image specular = baked(size, [&](Vec2 uv) {
            const Reflecting r = reflecting(values, maps, uv);
            return in_srgb(r.specular, r.glossiness);
        });
        const Texture place = *like;
        for (const TextureSlot slot : workflow_slots) material.textures[index_of(slot)].reset();
        material.textures[index_of(TextureSlot::base_color_texture)] =
            add_picture(scene, place, material.name + "-diffuse", std::move(diffuse));
        material.textures[index_of(TextureSlot::specular_color_texture)] =
            add_picture(scene, place, material.name + "-specular", std::move(specular));
        material.values.base_color = Vec3(1.0F);
        material.values.specular_color = Vec3(1.0F);
        material.values.roughness = 0.0F;
    }
    set_glossiness(material);
}

void warn(const Material& material, const char* why, base::Warnings& warnings) {
    warnings.push_back({.where = material.name,
                        .what = fmt::format("stays in its workflow: {}", why),
                        .found = {},
                        .remedy = {}});
}

bool is_in(const Material& material, Workflow workflow) {
    return material.has_glossiness == (workflow == Workflow::specular_glossiness);
}

}  // namespace

bool has_other(const Scene& scene, Workflow to) {
    return std::ranges::any_of(scene.materials,
                               [to](const Material& m) { return m.source && !is_in(m, to); });
}

void convert(Scene& scene, Workflow to, base::Warnings& warnings) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!scene.materials[i].source || is_in(scene.materials[i], to)) continue;
        Material& material = scene.materials[i];
        const Maps maps(scene, material);
        const bool is_baked = to == Workflow::specular_glossiness && maps.first() != nullptr;
        if (maps.lack_pixels()) {
            warn(material, "a picture of its textures is missing", warnings);
        } else if (is_baked && !maps.lie_alike()) {
            warn(material, "its textures lie differently, and would be one", warnings);
        } else if (to == Workflow::metallic_roughness) {
            to_metallic(scene, material);
        } else {
            if (material.values.specular != 1.0F || material.texture(TextureSlot::specular_texture))
                warnings.push_back({.where = material.name,
                                    .what = "its strength of reflection darkens F0 alone: "
                                            "glossiness reflects grazing light in full",
                                    .found = {},
                                    .remedy = {}});
            to_glossiness(scene, material);
        }
    }
}

}  // namespace facet::scene
