// What few surfaces have.
// SPDX-License-Identifier: MIT
#include "trace/surface_layers.h"

#include "scene/dielectric.h"
#include "scene/lobes.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Mat3;
using math::Vec2;
using math::Vec3;
using math::Vec4;
using tables::TextureSlot;

/// glsl/lib/material.glsl's, on the front side: n is the mesh's, xy of a normal map, scaled.
Vec3 mapped_normal(const Point& point, const Vec3& n, const Vec2& xy) {
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

/// Whether the normal map in `slot` is looked up.
bool has_normals(const scene::Scene& scene, const Point& point, TextureSlot slot) {
    const auto& texture = point.material.texture(slot);
    return texture && !point.mesh.tangents.empty() && !point.mesh.uv0.empty() &&
           scene.images[texture->image.index].pixels != nullptr;
}

}  // namespace

ShadingNormal shading_normal(const scene::Scene& scene, const Mat3& normal_from_object,
                             const Point& point, const NormalSlot& map, const Surface& s) {
    Vec3 n = math::normalize(normal_from_object * point.corners.mix(point.mesh.normals));
    float bumps = 0.0F;
    if (has_normals(scene, point, map.slot)) {
        const Vec4 texel = point(map.slot);
        n = mapped_normal(point, n, (Vec2(texel) * 2.0F - 1.0F) * map.scale);
        bumps = texel.w * std::fabs(map.scale);
    }
    n *= s.front ? 1.0F : -1.0F;
    return {std::isfinite(n.x + n.y + n.z) ? n : s.face_normal, bumps};
}

float with_bumps(float roughness, float bumps) {
    const float alpha = roughness * roughness;
    return bumps > 0.0F ? std::sqrt(std::min(std::sqrt(alpha * alpha + bumps * bumps), 1.0F))
                        : roughness;
}

void fill_transmission(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.transmission = v.transmission;
    if (point.has(TextureSlot::transmission_texture))
        s.transmission *= point(TextureSlot::transmission_texture).x;
    s.ior = v.ior;
    s.dispersion = v.dispersion;
}

namespace {

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
    const ShadingNormal shown =
        shading_normal(scene, normal_from_object, point,
                       {TextureSlot::clearcoat_normal_texture, v.clearcoat_normal_scale}, s);
    s.coat_normal = shown.normal;
    s.coat_roughness = with_bumps(s.coat_roughness, shown.bumps);
}

void fill_volume(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.has_volume = true;
    s.extinction_per_m = scene::extinction_per_m(v);
    s.scattered = scene::scattered_share(v);
    s.scatter_anisotropy = v.scatter_anisotropy;
}

void fill_diffuse_transmission(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.diffuse_transmission = v.diffuse_transmission;
    s.diffuse_transmission_color = v.diffuse_transmission_color;
    if (point.has(TextureSlot::diffuse_transmission_texture))
        s.diffuse_transmission *= point(TextureSlot::diffuse_transmission_texture).w;
    if (point.has(TextureSlot::diffuse_transmission_color_texture))
        s.diffuse_transmission_color *=
            Vec3(point(TextureSlot::diffuse_transmission_color_texture));
}

/// glsl/lib/material.glsl's.
float with_bumps_along(float strength, float roughness, float bumps) {
    if (!(bumps > 0.0F)) return strength;
    const float alpha = roughness * roughness;
    const float along = alpha + (1.0F - alpha) * strength * strength;
    const float wide = std::sqrt(alpha * alpha + bumps * bumps);
    const float excess = std::sqrt(along * along + bumps * bumps) - wide;
    return std::sqrt(std::clamp(excess / std::max(1.0F - wide, 1e-6F), 0.0F, 1.0F));
}

/// glsl/lib/material.glsl's fetch_anisotropy.
void fill_anisotropy(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    if (point.mesh.tangents.empty()) return;
    Vec2 way(std::cos(v.anisotropy_rotation_rad), std::sin(v.anisotropy_rotation_rad));
    float strength = v.anisotropy;
    if (point.has(TextureSlot::anisotropy_texture)) {
        const Vec4 texel = point(TextureSlot::anisotropy_texture);
        const Vec2 t = Vec2(texel) * 2.0F - 1.0F;
        way = {way.x * t.x - way.y * t.y, way.y * t.x + way.x * t.y};
        strength *= texel.z;
    }
    const Vec4 tangent = point.corners.mix(point.mesh.tangents);
    const Vec3 along = Mat3(point.instance.world_from_object) * Vec3(tangent);
    const Vec3 t = along - s.normal * math::dot(s.normal, along);
    // Of the mesh's own side, as mapped_normal's: the normal may be turned to the viewer.
    const Vec3 b = math::cross(s.normal, t) * (s.front ? tangent.w : -tangent.w);
    const Vec3 turned = t * way.x + b * way.y;
    const float length = math::length(turned);
    if (!(length > 1e-6F)) return;
    s.tangent = turned / length;
    s.anisotropy = with_bumps_along(strength, s.roughness, s.bumps);
}

void fill_film(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.film = v.iridescence;
    s.film_ior = v.iridescence_ior;
    s.film_nm = v.iridescence_thickness_max_nm;
    if (point.has(TextureSlot::iridescence_texture))
        s.film *= point(TextureSlot::iridescence_texture).x;
    if (point.has(TextureSlot::iridescence_thickness_texture))
        s.film_nm = v.iridescence_thickness_min_nm +
                    (v.iridescence_thickness_max_nm - v.iridescence_thickness_min_nm) *
                        point(TextureSlot::iridescence_thickness_texture).y;
}

void fill_sheen(const Point& point, Surface& s) {
    const tables::MaterialValues& v = point.material.values;
    s.sheen_color = v.sheen_color;
    s.sheen_roughness = v.sheen_roughness;
    if (point.has(TextureSlot::sheen_color_texture))
        s.sheen_color *= Vec3(point(TextureSlot::sheen_color_texture));
    if (point.has(TextureSlot::sheen_roughness_texture))
        s.sheen_roughness *= point(TextureSlot::sheen_roughness_texture).w;
}

/// After the normal.
void fill_ramp(const Point& point, const Vec3& to_eye, Surface& s) {
    const float cosine = std::clamp(math::dot(s.normal, to_eye), 0.0F, 1.0F);
    s.has_ramp = true;
    s.reflected = Vec3(point.at_share(TextureSlot::fresnel_ramp_texture, cosine));
}

}  // namespace

void fill_layers(const scene::Scene& scene, const Mat3& normal_from_object, const Point& point,
                 const Vec3& to_eye, Surface& s) {
    const auto has = [&](tables::Lobe lobe) { return scene::has_lobe(point.material, lobe); };
    if (has(tables::Lobe::clearcoat)) fill_coat(scene, normal_from_object, point, s);
    if (has(tables::Lobe::sheen)) fill_sheen(point, s);
    if (has(tables::Lobe::transmission)) fill_transmission(point, s);
    if (has(tables::Lobe::diffuse_transmission)) fill_diffuse_transmission(point, s);
    if (scene::has_volume(point.material)) fill_volume(point, s);
    if (has(tables::Lobe::anisotropy)) fill_anisotropy(point, s);
    if (has(tables::Lobe::iridescence)) fill_film(point, s);
    if (has(tables::Lobe::fresnel_ramp)) fill_ramp(point, to_eye, s);
}

}  // namespace facet::trace
