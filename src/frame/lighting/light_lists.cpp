// Which lights reach which part of the picture.
// SPDX-License-Identifier: MIT
#include "frame/lighting/light_lists.h"

#include "brdf/light_terms.h"
#include "scene/light_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::frame {
namespace {

using math::Vec2;
using math::Vec3;
using math::Vec4;

void push_area(std::vector<Vec4>& texels, const scene::Light& light) {
    const scene::LightAxes axes = scene::axes_of(light);
    const float half_width = 0.5F * light.width_m;
    switch (light.kind) {
        case tables::LightKind::rect:
            texels.emplace_back(axes.x * half_width, packed_kind::rect);
            texels.emplace_back(axes.y * (0.5F * light.height_m), 0.0F);
            return;
        case tables::LightKind::disk:
            texels.emplace_back(axes.x * light.radius_m, packed_kind::disk);
            texels.emplace_back(axes.y * light.radius_m, 0.0F);
            return;
        case tables::LightKind::sphere:
            texels.emplace_back(0.0F, 0.0F, 0.0F, packed_kind::sphere);
            texels.emplace_back(light.radius_m, 0.0F, 0.0F, 0.0F);
            return;
        case tables::LightKind::tube:
            texels.emplace_back(axes.x * half_width, packed_kind::tube);
            texels.emplace_back(axes.y * light.radius_m, 0.0F);
            return;
        case tables::LightKind::directional:
        case tables::LightKind::point:
        case tables::LightKind::spot:
        case tables::LightKind::ies:
            texels.emplace_back(0.0F, 0.0F, 0.0F, light.of_environment ? packed_kind::sun : 0.0F);
            texels.emplace_back(0.0F);
            return;
    }
}

/// Its axes, and where its profile is: another lamp of the same file shares it.
void push_profile(PackedLights& packed, const scene::Light& light) {
    const std::vector<float>& own = light.profile->shares;
    std::size_t index = 0;
    auto at = packed.profiles.begin();
    while (at != packed.profiles.end() && !std::equal(own.begin(), own.end(), at)) {
        at += static_cast<std::ptrdiff_t>(own.size());
        ++index;
    }
    if (at == packed.profiles.end())
        packed.profiles.insert(packed.profiles.end(), own.begin(), own.end());
    const scene::LightAxes axes = scene::profile_axes(light);
    packed.texels.emplace_back(axes.x, static_cast<float>(1 + index));
    packed.texels.emplace_back(axes.y, 0.0F);
}

void push(PackedLights& packed, const scene::Light& light) {
    std::vector<Vec4>& texels = packed.texels;
    const float inverse_range2 =
        light.range_m > 0.0F ? 1.0F / (light.range_m * light.range_m) : 0.0F;
    float scale = 0.0F;
    float offset = 1.0F;
    if (light.kind == tables::LightKind::spot) {
        const Vec2 edge = brdf::LightTerms<float>{}.spot_edge(std::cos(light.inner_cone_rad),
                                                              std::cos(light.outer_cone_rad));
        scale = edge.x;
        offset = edge.y;
    }
    texels.emplace_back(light.position_m, inverse_range2);
    texels.emplace_back(light.color * light.intensity, scale);
    texels.emplace_back(light.direction, offset);
    if (light.profile)
        push_profile(packed, light);
    else
        push_area(texels, light);
}

/// The box around what a tile shows, in world space.
math::Bounds tile_bounds(const math::Mat4& world_from_clip, Vec2 low, Vec2 high, float near,
                         float far) {
    math::Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec4 clip((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                        ((corner & 4) != 0 ? far : near) * 2.0F - 1.0F, 1.0F);
        const Vec4 world = world_from_clip * clip;
        bounds.add(Vec3(world) / world.w);
    }
    return bounds;
}

bool touches(const math::Bounds& box, const Vec4& position_inverse_range2) {
    if (position_inverse_range2.w <= 0.0F) return true;
    const Vec3 center(position_inverse_range2);
    const Vec3 nearest = glm::clamp(center, box.low, box.high);
    const Vec3 gap = center - nearest;
    return math::dot(gap, gap) * position_inverse_range2.w <= 1.0F;
}

/// Some of the box is on the side that a flat light shines to.
bool is_before(const math::Bounds& box, const Vec4* light) {
    if (light[3].w != packed_kind::rect && light[3].w != packed_kind::disk) return true;
    const Vec3 normal(light[2]);
    const Vec3 farthest(normal.x > 0.0F ? box.high.x : box.low.x,
                        normal.y > 0.0F ? box.high.y : box.low.y,
                        normal.z > 0.0F ? box.high.z : box.low.z);
    return math::dot(normal, farthest - Vec3(light[0])) > 0.0F;
}

/// Tiles a light can reach at all, from the corners of the box around its sphere.
struct TileRange {
    std::uint32_t x0, y0, x1, y1;  ///< half open
};
TileRange tile_range(const Vec4& position_inverse_range2, const math::Mat4& clip_from_world,
                     math::Extent size, std::uint32_t across, std::uint32_t down) {
    const TileRange all{0, 0, across, down};
    if (position_inverse_range2.w <= 0.0F) return all;
    const float range = 1.0F / std::sqrt(position_inverse_range2.w);
    Vec2 low(1e30F);
    Vec2 high(-1e30F);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 offset((corner & 1) != 0 ? range : -range, (corner & 2) != 0 ? range : -range,
                          (corner & 4) != 0 ? range : -range);
        const Vec4 clip = clip_from_world * Vec4(Vec3(position_inverse_range2) + offset, 1.0F);
        if (clip.w <= 1e-6F) return all;  // reaches behind the eye
        const Vec2 ndc = Vec2(clip) / clip.w;
        low = glm::min(low, ndc);
        high = glm::max(high, ndc);
    }
    const auto tile = [](float ndc, std::uint32_t pixels, std::uint32_t count, float round) {
        const float px =
            (ndc * 0.5F + 0.5F) * static_cast<float>(pixels) / static_cast<float>(tile_px);
        return static_cast<std::uint32_t>(std::clamp(px + round, 0.0F, static_cast<float>(count)));
    };
    return {tile(low.x, size.width, across, 0.0F), tile(low.y, size.height, down, 0.0F),
            tile(high.x, size.width, across, 1.0F), tile(high.y, size.height, down, 1.0F)};
}

std::uint32_t count_of(std::uint32_t pixels, std::uint32_t each) {
    return (pixels + each - 1) / each;
}

/// What is seen through a tile: a box around all of it, and boxes around its parts.
struct TileBoxes {
    math::Bounds whole;
    std::vector<math::Bounds> cells;
};

std::vector<TileBoxes> tile_boxes(const math::Mat4& clip_from_world, math::Extent size,
                                  const CellDepths* depths) {
    const std::uint32_t each = depths == nullptr ? tile_px : cell_px;
    const std::uint32_t tiles_across = count_of(size.width, tile_px);
    const std::uint32_t across = count_of(size.width, each);
    const std::uint32_t down = count_of(size.height, each);
    const math::Mat4 world_from_clip = math::inverse(clip_from_world);
    const auto ndc = [each](std::uint32_t cell, std::uint32_t pixels) {
        return static_cast<float>(cell * each) / static_cast<float>(pixels) * 2.0F - 1.0F;
    };
    std::vector<TileBoxes> out(std::size_t{tiles_across} * count_of(size.height, tile_px));
    for (std::uint32_t y = 0; y < down; ++y)
        for (std::uint32_t x = 0; x < across; ++x) {
            const std::size_t cell = std::size_t{y} * across + x;
            const float near = depths == nullptr ? 0.0F : depths->near[cell];
            const float far = depths == nullptr ? 1.0F : depths->far[cell];
            if (far < near) continue;  // nothing is seen there
            const math::Bounds box =
                tile_bounds(world_from_clip, {ndc(x, size.width), ndc(y, size.height)},
                            {ndc(x + 1, size.width), ndc(y + 1, size.height)}, near, far);
            TileBoxes& tile =
                out[std::size_t{y * each / tile_px} * tiles_across + x * each / tile_px];
            tile.cells.push_back(box);
            tile.whole.add(box.low);
            tile.whole.add(box.high);
        }
    return out;
}

bool lights_any(const TileBoxes& tile, const Vec4* light) {
    const auto is_lit = [&](const math::Bounds& box) {
        return touches(box, light[0]) && is_before(box, light);
    };
    return !tile.cells.empty() && is_lit(tile.whole) && std::ranges::any_of(tile.cells, is_lit);
}

}  // namespace

PackedLights pack_lights(std::span<const scene::Light> lights, bool with_rays) {
    PackedLights packed;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!with_rays || (scene::area_m2(lights[i]) <= 0.0F && !lights[i].stands_in))
            packed.order.push_back(i);
    const auto order_of = [&](std::size_t i) {
        if (lights[i].kind == tables::LightKind::directional) return 0;
        return scene::area_m2(lights[i]) > 0.0F ? 2 : 1;
    };
    std::ranges::stable_sort(packed.order, {}, order_of);
    for (const std::size_t index : packed.order) {
        push(packed, lights[index]);
        packed.lights.push_back(lights[index]);
        if (lights[index].kind == tables::LightKind::directional) ++packed.directional_count;
        if (scene::area_m2(lights[index]) > 0.0F) ++packed.area_count;
    }
    packed.count = static_cast<std::uint32_t>(packed.texels.size() / light_texels);
    return packed;
}

CellDepths cell_depths(std::span<const float> depth, math::Extent size) {
    const std::uint32_t across = count_of(size.width, cell_px);
    const std::uint32_t down = count_of(size.height, cell_px);
    CellDepths out{std::vector<float>(std::size_t{across} * down, 1.0F),
                   std::vector<float>(std::size_t{across} * down, 0.0F)};
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t c = 0; c < across; ++c) {
            const float* row = depth.data() + std::size_t{y} * size.width;
            const std::size_t cell = std::size_t{y / cell_px} * across + c;
            const std::uint32_t end = std::min(size.width, (c + 1) * cell_px);
            for (std::uint32_t x = c * cell_px; x < end; ++x) {
                out.near[cell] = std::min(out.near[cell], row[x]);
                out.far[cell] = std::max(out.far[cell], row[x] < 1.0F ? row[x] : 0.0F);
            }
        }
    return out;
}

LightLists build_light_lists(const PackedLights& lights, const math::Mat4& clip_from_world,
                             math::Extent size, const CellDepths* depths) {
    const std::uint32_t across = count_of(size.width, tile_px);
    const std::uint32_t down = count_of(size.height, tile_px);
    const std::vector<TileBoxes> boxes = tile_boxes(clip_from_world, size, depths);
    std::vector<std::vector<std::uint16_t>> lists(boxes.size());
    for (std::uint32_t i = lights.directional_count; i < lights.count; ++i) {
        const Vec4* const light = &lights.texels[std::size_t{i} * light_texels];
        const TileRange range = tile_range(light[0], clip_from_world, size, across, down);
        for (std::uint32_t y = range.y0; y < range.y1; ++y)
            for (std::uint32_t x = range.x0; x < range.x1; ++x) {
                const std::size_t t = std::size_t{y} * across + x;
                if (lights_any(boxes[t], light)) lists[t].push_back(static_cast<std::uint16_t>(i));
            }
    }
    LightLists out{.tiles_across = across};
    for (const auto& list : lists) {
        out.tiles.push_back(static_cast<std::uint32_t>(out.indices.size()));
        const auto areas = static_cast<std::uint32_t>(std::ranges::count_if(
            list, [&](std::uint16_t i) { return i >= lights.count - lights.area_count; }));
        out.tiles.push_back(static_cast<std::uint32_t>(list.size()) - areas + (areas << 16U));
        out.indices.insert(out.indices.end(), list.begin(), list.end());
    }
    if (out.indices.empty()) out.indices.push_back(0);  // a texture buffer cannot be empty
    return out;
}

}  // namespace facet::frame
