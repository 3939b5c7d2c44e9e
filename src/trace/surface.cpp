// What a ray finds where it meets a triangle.
// SPDX-License-Identifier: MIT
#include "trace/surface.h"

#include "scene/dielectric.h"
#include "scene/layers.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Mat3;
using math::Vec2;
using math::Vec3;
using math::Vec4;
using tables::TextureSlot;

/// The three vertices of a triangle and how much of each is at the point.
struct Corners {
    std::uint32_t a, b, c;
    float wa, wb, wc;

    template <class T>
    [[nodiscard]] T mix(const std::vector<T>& values) const {
        return values[a] * wa + values[b] * wb + values[c] * wc;
    }
};

Corners corners_of(const scene::Mesh& mesh, const Hit& hit) {
    const std::uint32_t* index = mesh.indices.data() + std::size_t{hit.triangle} * 3;
    return {index[0], index[1], index[2], 1.0F - hit.u - hit.v, hit.u, hit.v};
}

/// One point of a scene: what its mesh and its material are, and texture lookups.
class Point {
public:
    Point(const scene::Scene& scene, const Textures& textures, const Hit& hit)
        : instance(scene.instances[hit.instance]),
          mesh(scene.meshes[instance.mesh.index]),
          material(scene.material_of(instance)),
          corners(corners_of(mesh, hit)),
          textures_(textures) {}

    const scene::Instance& instance;
    const scene::Mesh& mesh;
    const scene::Material& material;
    const Corners corners;

    /// Ratio of the ray's width to the triangle, as halvings of a square texture over it; sample()
    /// adds the size.
    void set_footprint(float world_area2_m2, float width_m, float cosine) {
        width_ = width_m / std::max(cosine, 0.05F);
        area2_ = world_area2_m2;
    }
    [[nodiscard]] bool has(TextureSlot slot) const { return material.texture(slot).has_value(); }
    [[nodiscard]] Vec4 operator()(TextureSlot slot) const {
        const scene::Texture& texture = *material.texture(slot);
        const std::vector<Vec2>& uvs =
            texture.uv_set == 1 && !mesh.uv1.empty() ? mesh.uv1 : mesh.uv0;
        if (uvs.empty()) return Vec4(1.0F);
        const Vec3 uv = texture.uv_from_uv * Vec3(corners.mix(uvs), 1.0F);
        const auto space = tables::material_textures[static_cast<std::size_t>(slot)].space;
        return textures_.sample(texture, space, Vec2(uv), level(texture, uvs));
    }

private:
    [[nodiscard]] float level(const scene::Texture& texture, const std::vector<Vec2>& uvs) const {
        if (width_ <= 0.0F || area2_ <= 0.0F) return 0.0F;
        const Vec2 ab = uvs[corners.b] - uvs[corners.a];
        const Vec2 ac = uvs[corners.c] - uvs[corners.a];
        const Mat3& m = texture.uv_from_uv;
        const float scale = std::fabs(m[0][0] * m[1][1] - m[1][0] * m[0][1]);
        const math::Extent size = textures_.size(texture.image);
        const float texels2 = std::fabs(ab.x * ac.y - ab.y * ac.x) * scale *
                              static_cast<float>(size.width) * static_cast<float>(size.height);
        const float texels_wide2 = texels2 / area2_ * width_ * width_;
        return texels_wide2 > 1.0F ? 0.5F * std::log2(texels_wide2) : 0.0F;
    }

    const Textures& textures_;
    float width_ = 0.0F;
    float area2_ = 0.0F;
};

/// glsl/lib/material.glsl's mapped_normal, on the front side: of the normal map in `slot`.
Vec3 mapped_normal(const scene::Scene& scene, const Point& point, const Vec3& n, TextureSlot slot,
                   float scale) {
    const auto& texture = point.material.texture(slot);
    if (!texture || point.mesh.tangents.empty()) return n;
    if (scene.images[texture->image.index].pixels == nullptr) return n;
    const Vec2 xy = (Vec2(point(slot)) * 2.0F - 1.0F) * scale;
    const float z = std::sqrt(std::max(1.0F - math::dot(xy, xy), 1e-4F));
    const Vec4 tangent = point.corners.mix(point.mesh.tangents);
    const Vec3 across = Mat3(point.instance.world_from_object) * Vec3(tangent);
    const Vec3 t = across - n * math::dot(n, across);
    const float length = math::length(t);
    if (!(length > 1e-6F)) return n;
    const Vec3 unit = t / length;
    const Vec3 b = math::cross(n, unit) * tangent.w;
    return math::normalize(unit * xy.x + b * xy.y + n * z);
}

/// With the map in `slot`, turned to the viewer: after the sides.
Vec3 shading_normal(const scene::Scene& scene, const Mat3& normal_from_object, const Point& point,
                    TextureSlot slot, float scale, const Surface& s) {
    const Vec3 of_mesh =
        math::normalize(normal_from_object * point.corners.mix(point.mesh.normals));
    const Vec3 n = mapped_normal(scene, point, of_mesh, slot, scale) * (s.front ? 1.0F : -1.0F);
    return std::isfinite(n.x + n.y + n.z) ? n : s.face_normal;
}

/// glsl/lib/material.glsl's fetch_coat. After the sides.
void fill_coat(const scene::Scene& scene, const Mat3& normal_from_object, const Point& point,
               Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.coat = v.clearcoat;
    s.coat_roughness = v.clearcoat_roughness;
    if (point.has(TextureSlot::clearcoat_texture))
        s.coat *= point(TextureSlot::clearcoat_texture).x;
    if (point.has(TextureSlot::clearcoat_roughness_texture))
        s.coat_roughness *= point(TextureSlot::clearcoat_roughness_texture).y;
    s.coat_normal =
        shading_normal(scene, normal_from_object, point, TextureSlot::clearcoat_normal_texture,
                       v.clearcoat_normal_scale, s);
}

void fill_layers(const scene::Scene& scene, const Mat3& normal_from_object, const Point& point,
                 Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    if (scene::has_clearcoat(point.material)) fill_coat(scene, normal_from_object, point, s);
    if (!scene::has_sheen(point.material)) return;
    s.sheen_color = v.sheen_color;
    s.sheen_roughness = v.sheen_roughness;
    if (point.has(TextureSlot::sheen_color_texture))
        s.sheen_color *= Vec3(point(TextureSlot::sheen_color_texture));
    if (point.has(TextureSlot::sheen_roughness_texture))
        s.sheen_roughness *= point(TextureSlot::sheen_roughness_texture).w;
}

Vec4 base_color_opacity(const Point& point) {
    const scene::Material& material = point.material;
    const tables::MaterialValues& v = material.values;
    Vec4 base(v.base_color, material.alpha_mode == scene::AlphaMode::opaque ? 1.0F : v.opacity);
    if (!point.mesh.colors.empty()) base *= point.corners.mix(point.mesh.colors);
    if (point.has(TextureSlot::base_color_texture)) base *= point(TextureSlot::base_color_texture);
    return base;
}

/// Radiance emitted, nit.
Vec3 emission(const Point& point) {
    const Vec3 factor = emission_factor(point.material);
    if (factor == Vec3(0.0F) || !point.has(TextureSlot::emissive_texture)) return factor;
    return factor * Vec3(point(TextureSlot::emissive_texture));
}

Vec3 position_m(const scene::Instance& instance, const scene::Mesh& mesh, const Corners& corners) {
    return Vec3(instance.world_from_object * Vec4(corners.mix(mesh.positions_m), 1.0F));
}

/// After the roughness, which the texture of a glossiness changes.
void fill_specular(const Point& point, Surface& s) {
    s.dielectric_f0 = scene::dielectric_f0(point.material.values);
    s.specular = point.material.values.specular;
    if (point.has(TextureSlot::specular_color_texture)) {
        const Vec4 tint = point(TextureSlot::specular_color_texture);
        s.dielectric_f0 *= Vec3(tint);
        if (point.material.has_glossiness) s.roughness = 1.0F - (1.0F - s.roughness) * tint.w;
    }
    s.dielectric_f0 = glm::min(s.dielectric_f0, Vec3(1.0F));
    if (point.has(TextureSlot::specular_texture))
        s.specular *= point(TextureSlot::specular_texture).w;
}

void fill_material(const Point& point, Surface& s) {
    const scene::Material& material = point.material;
    const tables::MaterialValues& v = material.values;
    const Vec4 base = base_color_opacity(point);
    s.base_color = glm::clamp(Vec3(base), 0.0F, 1.0F);
    s.opacity =
        material.alpha_mode == scene::AlphaMode::blend ? std::clamp(base.w, 0.0F, 1.0F) : 1.0F;
    s.metallic = v.metallic;
    s.roughness = v.roughness;
    if (point.has(TextureSlot::metallic_roughness_texture)) {
        const Vec4 orm = point(TextureSlot::metallic_roughness_texture);
        s.metallic *= orm.z;
        s.roughness *= orm.y;
    }
    if (scene::has_specular(material)) fill_specular(point, s);
    if (point.has(TextureSlot::occlusion_texture))
        s.ao = 1.0F + (point(TextureSlot::occlusion_texture).x - 1.0F) * v.ao_strength;
    s.emissive_nit = emission(point);
    s.unlit = material.unlit;
}

/// Turns normals to the viewer, and finds the place beside the position that is free of its
/// triangle. `face`: unit, on the front side.
void set_sides(Surface& s, const Vec3& face, const Vec3& direction, const InstanceFrame& frame) {
    s.front = math::dot(face, direction) <= 0.0F;
    s.face_normal = s.front ? face : -face;
    // As far along the normal as the error may lie along every axis (Pharr, Jakob & Humphreys 2023,
    // Section 6.8.6).
    const Vec3 spread = glm::abs(s.face_normal);
    s.outside_m =
        s.position_m + s.face_normal * (frame.rounding_m * (spread.x + spread.y + spread.z));
}

}  // namespace

std::vector<InstanceFrame> instance_frames(const scene::Scene& scene) {
    std::vector<InstanceFrame> frames;
    frames.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances) {
        const Mat3 m(instance.world_from_object);
        // What cancels in M p + t has been as large as |M| |p| + |t|; sixteen roundings of that
        // bound the error of the corners, of the sum over them, and of Embree's plane.
        const math::Bounds& box = scene.meshes[instance.mesh.index].bounds_m;
        const Vec3 largest = glm::max(glm::abs(box.low), glm::abs(box.high));
        const Vec3 sum = glm::abs(m[0]) * largest.x + glm::abs(m[1]) * largest.y +
                         glm::abs(m[2]) * largest.z + glm::abs(Vec3(instance.world_from_object[3]));
        constexpr float roundings = 16.0F * 1.1920929e-7F;
        frames.push_back({math::normal_matrix(m), std::max({sum.x, sum.y, sum.z}) * roundings});
    }
    return frames;
}

Surface surface_at(const scene::Scene& scene, const std::vector<InstanceFrame>& frames,
                   const Textures& textures, const Hit& hit, const Vec3& direction, float cone_m) {
    Point point(scene, textures, hit);
    Surface s;
    s.instance = hit.instance;
    s.material = point.mesh.material.index;
    // From the corners, not along the ray: the error does not grow with the distance.
    s.position_m = position_m(point.instance, point.mesh, point.corners);
    const float area2 = math::length(hit.normal);
    const Vec3 face = hit.normal / std::max(area2, 1e-30F);
    set_sides(s, face, direction, frames[hit.instance]);
    point.set_footprint(area2, cone_m, std::fabs(math::dot(face, direction)));
    fill_material(point, s);
    const Mat3& normal_from_object = frames[hit.instance].normal_from_object;
    s.normal = shading_normal(scene, normal_from_object, point, TextureSlot::normal_texture,
                              point.material.values.normal_scale, s);
    fill_layers(scene, normal_from_object, point, s);
    return s;
}

Surface seen_surface(const scene::Scene& scene, const std::vector<InstanceFrame>& frames,
                     const Textures& textures, const SeenPixel& pixel, const Ray& from_eye) {
    const auto corner = [&](float u, float v) {
        return position_at(
            scene, {.instance = pixel.instance, .triangle = pixel.triangle, .u = u, .v = v});
    };
    const Vec3 a = corner(0.0F, 0.0F);
    const Vec3 ab = corner(1.0F, 0.0F) - a;
    const Vec3 ac = corner(0.0F, 1.0F) - a;
    const Vec3 normal = math::cross(ab, ac);
    const float across = math::dot(normal, from_eye.direction);
    float u = 1.0F / 3.0F;
    float v = u;
    if (across != 0.0F) {
        const float distance = math::dot(normal, a - from_eye.origin) / across;
        const Vec3 r = from_eye.origin + from_eye.direction * distance - a;
        const float area2 = math::dot(normal, normal);
        u = math::dot(math::cross(r, ac), normal) / area2;
        v = math::dot(math::cross(ab, r), normal) / area2;
        u = std::isfinite(u) ? std::clamp(u, 0.0F, 1.0F) : 0.0F;
        v = std::isfinite(v) ? std::clamp(v, 0.0F, 1.0F - u) : 0.0F;
    }
    Surface s;
    s.instance = pixel.instance;
    s.material = scene.meshes[scene.instances[pixel.instance].mesh.index].material.index;
    s.position_m = corner(u, v);
    s.normal = pixel.normal;
    s.base_color = pixel.base_color;
    s.metallic = pixel.metallic;
    s.roughness = pixel.roughness;
    s.dielectric_f0 = pixel.dielectric_f0;
    s.specular = pixel.specular;
    const float length = math::length(normal);
    set_sides(s, normal / std::max(length, 1e-30F), from_eye.direction, frames[pixel.instance]);
    if (scene::has_layers(scene.material_of(scene.instances[pixel.instance]))) {
        const Hit hit{.instance = pixel.instance, .triangle = pixel.triangle, .u = u, .v = v};
        fill_layers(scene, frames[pixel.instance].normal_from_object, {scene, textures, hit}, s);
    }
    return s;
}

float coverage_at(const scene::Scene& scene, const Textures& textures, const Hit& hit) {
    const Point point(scene, textures, hit);
    const scene::Material& material = point.material;
    if (material.alpha_mode == scene::AlphaMode::opaque) return 1.0F;
    const float opacity = std::clamp(base_color_opacity(point).w, 0.0F, 1.0F);
    if (material.alpha_mode == scene::AlphaMode::blend) return opacity;
    return opacity < material.values.alpha_cutoff ? 0.0F : 1.0F;
}

Vec3 emission_factor(const scene::Material& material) {
    return material.values.emissive * material.values.emissive_strength;
}

Vec3 emission_at(const scene::Scene& scene, const Textures& textures, const Hit& hit) {
    return emission({scene, textures, hit});
}

Vec3 position_at(const scene::Scene& scene, const Hit& hit) {
    const scene::Instance& instance = scene.instances[hit.instance];
    const scene::Mesh& mesh = scene.meshes[instance.mesh.index];
    return position_m(instance, mesh, corners_of(mesh, hit));
}

}  // namespace facet::trace
