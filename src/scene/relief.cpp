// Height maps as displacement (Cook 1984, "Shade Trees", section 5): rays find reliefs as they find
// any mesh, so shadows, occlusion and outlines are right in both renderers.
// SPDX-License-Identifier: MIT
#include "scene/relief.h"

#include "scene/deform.h"
#include "scene/split_edges.h"
#include "scene/wrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace facet::scene {
namespace {

using tables::TextureSlot;

/// Where a vertex is on the map, in texels.
Vec2 on_map(const Texture& map, math::Extent texels, Vec2 uv) {
    const Vec3 at = map.uv_from_uv * Vec3(uv, 1.0F);
    return Vec2(at) * Vec2(texels.width, texels.height);
}

/// What a map says: its first channel, 0 to 1.
class HeightMap {
public:
    HeightMap(const image::Image& pixels, const Texture& map) : pixels_(pixels), map_(map) {}

    /// The mean over a square around a place, sides and place in texels.
    [[nodiscard]] float mean(Vec2 at, float side) const {
        const int count = static_cast<int>(std::ceil(std::clamp(2.0F * side, 1.0F, 8.0F)));
        float sum = 0.0F;
        for (int y = 0; y < count; ++y)
            for (int x = 0; x < count; ++x) {
                const Vec2 share = (Vec2(x, y) + 0.5F) / static_cast<float>(count) - 0.5F;
                sum += bilinear(at + share * side);
            }
        return sum / static_cast<float>(count * count);
    }

private:
    [[nodiscard]] float bilinear(Vec2 at) const {
        const float x = tame(at.x) - 0.5F;
        const float y = tame(at.y) - 0.5F;
        const float left = std::floor(x);
        const float top = std::floor(y);
        const auto column = static_cast<int>(left);
        const auto row = static_cast<int>(top);
        const float upper = std::lerp(texel(column, row), texel(column + 1, row), x - left);
        const float lower = std::lerp(texel(column, row + 1), texel(column + 1, row + 1), x - left);
        return std::lerp(upper, lower, y - top);
    }
    [[nodiscard]] float texel(int column, int row) const {
        const auto width = static_cast<int>(pixels_.size.width);
        const auto height = static_cast<int>(pixels_.size.height);
        const auto x = static_cast<std::size_t>(wrapped(column, width, map_.wrap_u));
        const auto y = static_cast<std::size_t>(wrapped(row, height, map_.wrap_v));
        const std::size_t index = (y * pixels_.size.width + x) * pixels_.channels;
        return pixels_.sample == image::Sample::u8
                   ? static_cast<float>(pixels_.as<std::uint8_t>()[index]) / 255.0F
                   : static_cast<float>(pixels_.as<std::uint16_t>()[index]) / 65535.0F;
    }

    const image::Image& pixels_;
    const Texture& map_;
};

/// A mesh that wants a relief, with the map and its pixels.
struct Wanted {
    Mesh* mesh = nullptr;
    const Mesh* smooth = nullptr;
    const Material* material = nullptr;
    Texture map;
    std::shared_ptr<const image::Image> pixels;

    [[nodiscard]] std::vector<Vec2> places_texels() const {
        std::vector<Vec2> out;
        out.reserve(smooth->positions_m.size());
        for (const Vec2& uv : smooth->uv(map.uv_set)) out.push_back(on_map(map, pixels->size, uv));
        return out;
    }
};

std::optional<Wanted> wanted(const Scene& scene, Mesh& mesh) {
    const Material& material = scene.materials[mesh.material.index];
    const auto& map = material.texture(TextureSlot::height_texture);
    if (!map || material.values.height_scale_m == 0.0F) return std::nullopt;
    const auto& pixels = scene.images[map->image.index].pixels;
    const Mesh& smooth = mesh.relief ? mesh.relief->smooth : mesh;
    if (pixels == nullptr || pixels->size.pixels() == 0 || pixels->sample == image::Sample::f32 ||
        smooth.indices.empty() || smooth.uv(map->uv_set).size() != smooth.positions_m.size())
        return std::nullopt;
    return Wanted{&mesh, &smooth, &material, *map, pixels};
}

/// The longest edges, in texels, with which all meshes stay within most_relief_triangles, or none
/// is split. Half of a texel's square has a diagonal of the root of two.
float spacing_of(const std::vector<Wanted>& all) {
    std::vector<std::pair<const Wanted*, std::vector<Vec2>>> places;
    std::size_t unsplit = 0;
    for (const Wanted& one : all) {
        places.emplace_back(&one, one.places_texels());
        unsplit += one.smooth->indices.size() / 3;
    }
    const auto enough = static_cast<double>(std::max(unsplit, most_relief_triangles));
    for (float spacing = std::sqrt(2.0F);; spacing *= 2.0F) {
        double count = 0.0;
        for (const auto& [one, at] : places) count += split_count(*one->smooth, at, spacing);
        // Edges whose length is not finite are not split: there is an end.
        if (count <= enough) return spacing;
    }
}

/// As FineMesh has them: each the number of its first vertex.
std::vector<std::uint32_t> group_normals(const std::vector<Vec3>& normals,
                                         const std::vector<std::uint32_t>& places) {
    std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> firsts;
    std::vector<std::uint32_t> out;
    out.reserve(normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const Vec3& n = normals[v];
        out.push_back(firsts.try_emplace({places[v], n.x, n.y, n.z}, static_cast<std::uint32_t>(v))
                          .first->second);
    }
    return out;
}

/// `most` triangles, but for what one round of halving adds.
std::shared_ptr<const FineMesh> refine(const Wanted& from, float spacing_texels, std::size_t most) {
    auto fine = std::make_shared<FineMesh>();
    fine->mesh = *from.smooth;
    fine->mesh.relief = nullptr;
    std::vector<Vec2> at = from.places_texels();
    fine->places = split_edges(fine->mesh, at, spacing_texels, most);
    fine->normal_groups = group_normals(fine->mesh.normals, fine->places);
    const HeightMap heights(*from.pixels, from.map);
    fine->heights.reserve(at.size());
    // From vertex to vertex both ways, along the sides of which edges are the diagonals: what is
    // finer than triangles can show would be teeth on them under low light.
    for (const Vec2& place : at)
        fine->heights.push_back(heights.mean(place, spacing_texels * std::sqrt(2.0F)));
    return fine;
}

/// Moves vertices out, those of a place by the mean of their ways.
void displace(const FineMesh& fine, float scale_m, Mesh& mesh) {
    std::vector<Vec4> ways(mesh.positions_m.size(), Vec4(0.0F));  // w counts
    for (std::size_t v = 0; v < mesh.positions_m.size(); ++v)
        ways[fine.places[v]] += Vec4(mesh.normals[v] * (fine.heights[v] * scale_m), 1.0F);
    for (std::size_t v = 0; v < mesh.positions_m.size(); ++v) {
        const Vec4& way = ways[fine.places[v]];
        mesh.positions_m[v] += Vec3(way) / way.w;
    }
}

/// Normals of the displaced surface: the mean of a group's faces, weighted by area.
void follow_surface(const FineMesh& fine, Mesh& mesh) {
    std::vector<Vec3> sums(mesh.normals.size(), Vec3(0.0F));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 face = scaled_face_normal(mesh, i) * (mesh.is_mirrored ? -1.0F : 1.0F);
        for (std::size_t c = i; c < i + 3; ++c) sums[fine.normal_groups[mesh.indices[c]]] += face;
    }
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        const Vec3& sum = sums[fine.normal_groups[v]];
        const float size = math::length(sum);
        if (!(size > 0.0F) || !std::isfinite(size)) continue;
        mesh.normals[v] = sum / size;
        if (mesh.tangents.empty()) continue;
        const Vec3 tangent(mesh.tangents[v]);
        const Vec3 level = tangent - mesh.normals[v] * math::dot(mesh.normals[v], tangent);
        if (math::length(level) > 1e-6F)
            mesh.tangents[v] = Vec4(math::normalize(level), mesh.tangents[v].w);
    }
}

/// Whether the mesh became another. `most`: see refine().
bool raise(const Wanted& from, float spacing_texels, std::size_t most) {
    const std::shared_ptr<const Relief> old = from.mesh->relief;
    const float scale_m = from.material->values.height_scale_m;
    const bool has_fine = old && old->map == from.map && old->pixels == from.pixels &&
                          old->spacing_texels == spacing_texels;
    const bool keeps_normals = from.material->texture(TextureSlot::normal_texture).has_value();
    if (has_fine && old->scale_m == scale_m && old->keeps_normals == keeps_normals) return false;
    auto relief = std::make_shared<Relief>(
        Relief{.smooth = *from.smooth,
               .map = from.map,
               .pixels = from.pixels,
               .scale_m = scale_m,
               .spacing_texels = spacing_texels,
               .keeps_normals = keeps_normals,
               .fine = has_fine ? old->fine : refine(from, spacing_texels, most)});
    relief->smooth.relief = nullptr;
    Mesh mesh = relief->fine->mesh;
    displace(*relief->fine, scale_m, mesh);
    if (!keeps_normals) follow_surface(*relief->fine, mesh);
    mesh.bounds_m = {};
    for (const Vec3& position : mesh.positions_m) mesh.bounds_m.add(position);
    mesh.relief = std::move(relief);
    *from.mesh = std::move(mesh);
    return true;
}

}  // namespace

bool lower_relief(Mesh& mesh) {
    if (!mesh.relief) return false;
    const std::shared_ptr<const Relief> relief = mesh.relief;  // outlives the mesh that holds it
    mesh = relief->smooth;
    return true;
}

bool raise_reliefs(Scene& scene) {
    bool changed = false;
    std::vector<Wanted> all;
    for (Mesh& mesh : scene.meshes) {
        if (auto one = wanted(scene, mesh))
            all.push_back(std::move(*one));
        else
            changed = lower_relief(mesh) || changed;
    }
    if (all.empty()) return changed;
    const float spacing_texels = spacing_of(all);
    std::size_t left = most_relief_triangles;
    for (const Wanted& one : all) {
        changed = raise(one, spacing_texels, left) || changed;
        // Edges that are halved for a neighbour's sake are in no estimate.
        left -= std::min(left, one.mesh->indices.size() / 3);
    }
    return changed;
}

}  // namespace facet::scene
