// The lights of a scene as the tracer draws from them.
// SPDX-License-Identifier: MIT
#include "trace/lights.h"

#include "brdf/light_terms.h"
#include "math/color.h"
#include "scene/light_at.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;
using scene::Light;
using tables::LightKind;
using Terms = brdf::LightTerms<float>;

constexpr std::size_t no_emitter = ~std::size_t{0};
constexpr std::uint32_t no_light = ~0U;

bool is_sized(const Light& light) {
    return tables::light_kinds[static_cast<std::size_t>(light.kind)].area;
}

/// Of a triangle in world space: twice its area long, on its front side, as Hit::normal.
Vec3 area_normal(const scene::Scene& scene, std::uint32_t instance, std::uint32_t triangle) {
    const Vec3 a = position_at(scene, {.instance = instance, .triangle = triangle});
    const Vec3 b = position_at(scene, {.instance = instance, .triangle = triangle, .u = 1.0F});
    const Vec3 c = position_at(scene, {.instance = instance, .triangle = triangle, .v = 1.0F});
    return math::cross(b - a, c - a);
}

}  // namespace

Lights::Lights(const scene::Scene& scene, const Textures& textures, const Light* sun)
    : scene_(&scene), textures_(&textures) {
    // The mesh that a light stands in for is drawn from itself.
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].stands_in) continue;
        lights_.push_back(scene.lights[i]);
        places_.push_back(i);
    }
    if (sun != nullptr) {
        lights_.push_back(*sun);
        places_.push_back(scene.lights.size());
    }
    for (const Light& light : lights_) {
        axes_.push_back(scene::axes_of(light));
        if (is_sized(light)) ++sized_count_;
        if (light.kind == LightKind::directional && light.angle_rad > 0.0F) has_suns_ = true;
    }
    first_emitter_.assign(scene.instances.size(), no_emitter);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) add_emitters(scene, i);
    std::vector<float> weights;
    math::Bounds bounds;
    for (const Emitter& e : emitters_) {
        const Hit middle{
            .instance = e.instance, .triangle = e.triangle, .u = 1.0F / 3.0F, .v = 1.0F / 3.0F};
        // A texture may be dark in the middle alone: a tenth of the factor keeps the triangle in
        // the draw.
        const float nit =
            math::luminance(emission_at(scene, textures, middle)) +
            0.1F * math::luminance(emission_factor(scene.material_of(scene.instances[e.instance])));
        weights.push_back(nit * e.area_m2);
        emitted_ += weights.back();
        bounds.add(position_at(scene, middle));
    }
    if (emitters_.empty()) return;
    ++sized_count_;
    emitter_shares_ = Distribution(std::span<const float>(weights));
    emitters_center_m_ = bounds.center();
    emitters_radius2_m2_ = 0.25F * bounds.diagonal() * bounds.diagonal();
}

void Lights::add_emitters(const scene::Scene& scene, std::uint32_t instance) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[instance].mesh.index];
    const scene::Material& material = scene.material_of(scene.instances[instance]);
    if (material.unlit || emission_factor(material) == Vec3(0.0F)) return;
    first_emitter_[instance] = emitters_.size();
    for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t)
        emitters_.push_back({instance, t, 0.5F * math::length(area_normal(scene, instance, t))});
}

float Lights::weight(const Light& light, const Vec3& position_m) const {
    if (light.kind == LightKind::directional) return math::luminance(light.color) * light.intensity;
    const Vec3 to_center = light.position_m - position_m;
    const float distance2 = math::dot(to_center, to_center);
    if (!is_sized(light)) return math::luminance(sample_point(light, to_center).light);
    const float area = scene::area_m2(light);
    return math::luminance(light.color) * light.intensity * area *
           scene::range_window(light, distance2) / std::max(distance2, 0.25F * area);
}

float Lights::mesh_weight(const Vec3& position_m) const {
    const Vec3 way = emitters_center_m_ - position_m;
    return emitted_ / std::max({math::dot(way, way), emitters_radius2_m2_, 1e-12F});
}

bool Lights::has_size(std::size_t light) const {
    return light >= lights_.size() || is_sized(lights_[light]);
}

Lights::Choice Lights::choose(const Vec3& position_m, float u, Among among) const {
    Choice out;
    float chosen_weight = 0.0F;
    for (std::size_t i = 0; i < count(); ++i) {
        if (among == Among::sized && !has_size(i)) continue;
        const float w =
            i < lights_.size() ? weight(lights_[i], position_m) : mesh_weight(position_m);
        if (!(w > 0.0F)) continue;
        out.total_weight += w;
        // A reservoir of one (Chao 1982); the number is stretched and used again.
        const float share = w / out.total_weight;
        if (u < share) {
            out.light = i;
            chosen_weight = w;
            u /= share;
        } else {
            u = (u - share) / (1.0F - share);
        }
    }
    out.probability = out.total_weight > 0.0F ? chosen_weight / out.total_weight : 0.0F;
    return out;
}

LightSample Lights::sample(const Choice& choice, const Vec3& position_m, Vec2 u, float pick) const {
    if (choice.light >= lights_.size()) return sample_mesh(position_m, u, pick);
    const Light& light = lights_[choice.light];
    const Vec3 to_center = light.position_m - position_m;
    LightSample out;
    if (light.kind == LightKind::directional) {
        out = sample_directional(light, u);
    } else if (!is_sized(light)) {
        out = sample_point(light, to_center);
    } else {
        out = sample_shape(light, axes_[choice.light], to_center, u);
        out.light = light.color *
                    (light.intensity * scene::range_window(light, math::dot(to_center, to_center)));
    }
    out.casts_shadow = light.casts_shadow;
    return out;
}

Vec3 Lights::irradiance(const Vec3& position_m, const Vec3& normal) const {
    constexpr int places = 8;  // along each side
    Vec3 sum(0.0F);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const bool is_wide = is_sized(lights_[i]) || lights_[i].angle_rad > 0.0F;
        const int steps = is_wide ? places : 1;
        for (int k = 0; k < steps * steps; ++k) {
            const Vec2 u = (Vec2(k % steps, k / steps) + 0.5F) / static_cast<float>(steps);
            const LightSample s = sample({i, 1.0F, 0.0F}, position_m, u, 0.0F);
            const float cosine = math::dot(s.direction, normal);
            if (!(cosine > 0.0F) || (s.has_pdf && !(s.pdf > 0.0F))) continue;
            sum +=
                s.light * (cosine / (s.has_pdf ? s.pdf : 1.0F) / static_cast<float>(steps * steps));
        }
    }
    return sum;
}

LightSample Lights::sample_mesh(const Vec3& position_m, Vec2 u, float pick) const {
    const auto draw = emitter_shares_.draw(pick);
    const Emitter& e = emitters_[draw.cell];
    // Uniform over the triangle (Turk 1990).
    const float root = std::sqrt(u.x);
    const Hit at{
        .instance = e.instance, .triangle = e.triangle, .u = root * (1.0F - u.y), .v = root * u.y};
    Vec3 normal = area_normal(*scene_, e.instance, e.triangle);
    normal /= std::max(math::length(normal), 1e-30F);
    const Vec3 to_place = position_at(*scene_, at) - position_m;
    const scene::Material& material = scene_->material_of(scene_->instances[e.instance]);
    if (material.double_sided && math::dot(normal, to_place) > 0.0F) normal = -normal;
    LightSample out = sample_area(to_place, normal, e.area_m2);
    out.pdf *= draw.share;
    if (out.pdf > 0.0F)
        out.light = emission_at(*scene_, *textures_, at) * coverage_at(*scene_, *textures_, at);
    return out;
}

Vec3 Lights::met(const Ray& ray, const DrawnWay& drawn, const Vec3& extinction_per_m,
                 const Hit* at_end) const {
    Vec3 sum(0.0F);
    const bool has_suns = drawn.among == Among::all && has_suns_;
    if (sized_count_ == 0 && !has_suns) return sum;
    std::size_t shape_of = no_light;
    if (at_end != nullptr) shape_of = scene_->instances[at_end->instance].light.value_or(no_light);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Light& light = lights_[i];
        const bool is_sun = light.kind == LightKind::directional;
        if (is_sun ? !has_suns : !is_sized(light)) continue;
        // Nothing hides it: it was met when the ray set out.
        if (!light.casts_shadow && ray.near_m > 0.0F) continue;
        float own = 0.0F;
        float distance = 0.0F;
        const Vec3 to_center = light.position_m - ray.origin;
        if (is_sun) {
            own = directional_pdf(light, ray.direction);
            distance = own > 0.0F ? Ray{}.far_m : 0.0F;
        } else {
            distance = hit_shape(light, axes_[i], to_center, ray.direction, own);
        }
        // A light's triangles lie on its surface or a little within.
        const bool is_at_end = places_[i] == shape_of;
        const float far_m = light.casts_shadow && !is_at_end ? ray.far_m : Ray{}.far_m;
        if (distance <= ray.near_m || distance > far_m) continue;
        const float chosen = chance(weight(light, ray.origin), drawn.total_weight);
        float share = light.intensity * power_share(drawn.density(), own * chosen);
        share *= is_sun ? own : scene::range_window(light, math::dot(to_center, to_center));
        // What a sun shines through without an end has no far side to dim it by.
        const Vec3 left = is_sun ? Vec3(1.0F) : left_after(extinction_per_m, distance - ray.near_m);
        sum += light.color * share * left;
    }
    return sum;
}

float Lights::mesh_share(const Hit& hit, const Ray& ray, const DrawnWay& drawn) const {
    const std::size_t first = first_emitter_[hit.instance];
    if (first == no_emitter) return 1.0F;
    const float area2 = math::length(hit.normal);
    const float cosine = std::fabs(math::dot(hit.normal, ray.direction)) / std::max(area2, 1e-30F);
    const std::size_t emitter = first + hit.triangle;
    const float pdf = Terms{}.pdf_area(emitters_[emitter].area_m2, ray.far_m * ray.far_m, cosine);
    return power_share(drawn.density(),
                       pdf * emitter_shares_.share(static_cast<std::uint32_t>(emitter)) *
                           chance(mesh_weight(ray.origin), drawn.total_weight));
}

}  // namespace facet::trace
