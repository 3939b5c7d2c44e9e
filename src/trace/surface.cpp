// What a ray finds where it meets a triangle.
// SPDX-License-Identifier: MIT
#include "trace/surface.h"

#include "scene/dielectric.h"
#include "scene/lobes.h"
#include "trace/surface_layers.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Mat3;
using math::Vec2;
using math::Vec3;
using math::Vec4;
using tables::TextureSlot;

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
    const Vec3 off = s.face_normal * (frame.rounding_m * (spread.x + spread.y + spread.z));
    s.outside_m = s.position_m + off;
    s.beyond_m = s.position_m - off;
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
    const ShadingNormal shown =
        shading_normal(scene, normal_from_object, point,
                       {TextureSlot::normal_texture, point.material.values.normal_scale}, s);
    s.normal = shown.normal;
    s.bumps = shown.bumps;
    fill_layers(scene, normal_from_object, point, -direction, s);
    s.thin_roughness = s.roughness;
    s.roughness = with_bumps(s.roughness, s.bumps);
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
    s.roughness = s.thin_roughness = pixel.roughness;
    s.dielectric_f0 = pixel.dielectric_f0;
    s.specular = pixel.specular;
    const float length = math::length(normal);
    set_sides(s, normal / std::max(length, 1e-30F), from_eye.direction, frames[pixel.instance]);
    if (scene::has_layers(scene.material_of(scene.instances[pixel.instance]))) {
        const Hit hit{.instance = pixel.instance, .triangle = pixel.triangle, .u = u, .v = v};
        const Point point(scene, textures, hit);
        fill_layers(scene, frames[pixel.instance].normal_from_object, point, -from_eye.direction,
                    s);
        if (s.transmission > 0.0F && !s.has_volume && point.has(TextureSlot::normal_texture)) {
            Surface plain;
            fill_material(point, plain);
            s.thin_roughness = plain.roughness;
        }
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

Vec3 straight_share(const scene::Scene& scene, const Textures& textures, const Hit& hit,
                    const Vec3& direction) {
    const Point point(scene, textures, hit);
    const scene::Material& material = point.material;
    if (!scene::has_lobe(material, tables::Lobe::transmission) || scene::has_volume(material))
        return Vec3(0.0F);
    Surface s;
    fill_material(point, s);
    if (s.roughness * s.roughness >= mirror_alpha_max) return Vec3(0.0F);
    fill_transmission(point, s);
    const float cosine = std::fabs(math::dot(math::normalize(hit.normal), direction));
    const Vec3 f = Lobes{}.f_schlick(s.dielectric_f0, cosine) * s.specular;
    return s.base_color *
           (s.transmission * (1.0F - s.metallic) * (1.0F - std::max({f.x, f.y, f.z})));
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
