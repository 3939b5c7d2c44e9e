// The lights of a scene as the tracer draws from them.
// SPDX-License-Identifier: MIT
#include "trace/lights.h"

#include "brdf/light_terms.h"
#include "math/color.h"

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

/// Lux at normal incidence from a point or spot light (KHR_lights_punctual, as the rasteriser's
/// light lists).
Vec3 illuminance(const Light& light, const Vec3& to_light, float distance2) {
    Terms terms;
    const float inverse_range2 =
        light.range_m > 0.0F ? 1.0F / (light.range_m * light.range_m) : 0.0F;
    Vec3 lux = terms.light_point(light.color * light.intensity, distance2, inverse_range2);
    if (light.kind == LightKind::spot) {
        const float cos_outer = std::cos(light.outer_cone_rad);
        const float scale = 1.0F / std::max(0.001F, std::cos(light.inner_cone_rad) - cos_outer);
        lux *= terms.light_spot(-math::dot(to_light, light.direction), scale, -cos_outer * scale);
    }
    return lux;
}

LightSample sample_point(const Light& light, const Vec3& to_center) {
    const float distance2 = std::max(math::dot(to_center, to_center), 1e-12F);
    LightSample out;
    out.distance_m = std::sqrt(distance2);
    out.direction = to_center / out.distance_m;
    out.light = illuminance(light, out.direction, distance2);
    return out;
}

/// A place of the light given from the point that is lit, drawn uniformly over `area` where its
/// normal is `normal`.
LightSample from_area(const Vec3& to_place, const Vec3& normal, float area) {
    const float distance2 = math::dot(to_place, to_place);
    LightSample out;
    out.has_size = true;
    if (!(distance2 > 0.0F)) return out;
    out.distance_m = std::sqrt(distance2);
    out.direction = to_place / out.distance_m;
    out.pdf = Terms{}.pdf_area(area, distance2, -math::dot(normal, out.direction));
    return out;
}

LightSample sample_shape(const Light& light, const scene::LightAxes& axes, const Vec3& to_center,
                         Vec2 u) {
    Terms terms;
    switch (light.kind) {
        case LightKind::sphere: {
            const float distance2 = math::dot(to_center, to_center);
            const Vec3 direction = terms.sample_sphere(to_center, light.radius_m, u);
            const float reach = terms.hit_sphere(to_center, light.radius_m, direction);
            // At the rim rounding may miss: the rim is as far as the tangent.
            const float tangent =
                std::sqrt(std::max(distance2 - light.radius_m * light.radius_m, 0.0F));
            return {direction,
                    reach > 0.0F ? reach : tangent,
                    {},
                    terms.pdf_sphere(distance2, light.radius_m),
                    true};
        }
        case LightKind::disk:
            return from_area(to_center + terms.sample_disk(axes.x, axes.y, light.radius_m, u),
                             axes.z, scene::area_m2(light));
        case LightKind::tube: {
            const Vec3 normal = terms.sample_tube_normal(to_center, axes.x, light.radius_m, u);
            const Vec3 place =
                to_center + axes.x * ((u.y - 0.5F) * light.width_m) + normal * light.radius_m;
            return from_area(place, normal,
                             terms.tube_area(to_center, axes.x, light.radius_m, light.width_m));
        }
        case LightKind::rect: {
            const auto view =
                terms.rect_view(to_center, axes.x, axes.y, axes.z, light.width_m, light.height_m);
            // Where the solid angle cancels in float, area is as good.
            constexpr float small_sr = 1e-3F;
            if (view.solid_angle < small_sr)
                return from_area(to_center + axes.x * ((u.x - 0.5F) * light.width_m) +
                                     axes.y * ((u.y - 0.5F) * light.height_m),
                                 axes.z, scene::area_m2(light));
            const Vec3 local = terms.sample_rect(view, u);
            const Vec3 place = axes.x * local.x + axes.y * local.y + axes.z * local.z;
            const float distance = math::length(place);
            return {place / distance, distance, {}, 1.0F / view.solid_angle, true};
        }
        case LightKind::directional:
        case LightKind::point:
        case LightKind::spot:
            break;
    }
    return {};
}

/// Distance along a unit direction to a light with a size, or -1; and the density of sample_shape
/// there.
float hit_shape(const Light& light, const scene::LightAxes& axes, const Vec3& to_center,
                const Vec3& direction, float& pdf) {
    Terms terms;
    float distance = -1.0F;
    switch (light.kind) {
        case LightKind::sphere:
            pdf = terms.pdf_sphere(math::dot(to_center, to_center), light.radius_m);
            return terms.hit_sphere(to_center, light.radius_m, direction);
        case LightKind::disk:
            distance = terms.hit_disk(to_center, axes.z, light.radius_m, direction);
            break;
        case LightKind::rect: {
            distance = terms.hit_rect(to_center, axes.x, axes.y, axes.z, light.width_m,
                                      light.height_m, direction);
            if (distance <= 0.0F) return distance;
            const auto view =
                terms.rect_view(to_center, axes.x, axes.y, axes.z, light.width_m, light.height_m);
            constexpr float small_sr = 1e-3F;
            if (view.solid_angle >= small_sr) {
                pdf = 1.0F / view.solid_angle;
                return distance;
            }
            break;
        }
        case LightKind::tube: {
            distance = terms.hit_tube(to_center, axes.x, light.radius_m, light.width_m, direction);
            if (distance <= 0.0F) return distance;
            const Vec3 from_center = direction * distance - to_center;
            const Vec3 normal =
                (from_center - axes.x * math::dot(from_center, axes.x)) / light.radius_m;
            pdf = terms.pdf_area(terms.tube_area(to_center, axes.x, light.radius_m, light.width_m),
                                 distance * distance, -math::dot(normal, direction));
            return distance;
        }
        case LightKind::directional:
        case LightKind::point:
        case LightKind::spot:
            return distance;
    }
    if (distance > 0.0F)
        pdf = terms.pdf_area(scene::area_m2(light), distance * distance,
                             -math::dot(axes.z, direction));
    return distance;
}

bool has_size(const Light& light) {
    return tables::light_kinds[static_cast<std::size_t>(light.kind)].area;
}

}  // namespace

Lights::Lights(const scene::Scene& scene, const Textures& textures)
    : scene_(&scene), textures_(&textures) {
    for (const Light& light : scene.lights) {
        axes_.push_back(scene::axes_of(light));
        any_with_size_ = any_with_size_ || has_size(light);
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
        const float nit = math::luminance(emission_at(scene, textures, middle)) +
                          0.1F * math::luminance(emission_factor(scene, middle));
        weights.push_back(nit * e.area_m2);
        emitted_ += weights.back();
        bounds.add(position_at(scene, middle));
    }
    if (emitters_.empty()) return;
    emitter_shares_ = Distribution(std::span<const float>(weights));
    emitters_center_m_ = bounds.center();
    emitters_radius2_m2_ = 0.25F * bounds.diagonal() * bounds.diagonal();
}

void Lights::add_emitters(const scene::Scene& scene, std::uint32_t instance) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[instance].mesh.index];
    if (scene.materials[mesh.material.index].unlit) return;
    if (emission_factor(scene, {.instance = instance}) == Vec3(0.0F)) return;
    first_emitter_[instance] = emitters_.size();
    for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Vec3 a = position_at(scene, {.instance = instance, .triangle = t});
        const Vec3 b = position_at(scene, {.instance = instance, .triangle = t, .u = 1.0F});
        const Vec3 c = position_at(scene, {.instance = instance, .triangle = t, .v = 1.0F});
        emitters_.push_back({instance, t, 0.5F * math::length(math::cross(b - a, c - a))});
    }
}

float Lights::weight(const Light& light, const Vec3& position_m) const {
    if (light.kind == LightKind::directional) return math::luminance(light.color) * light.intensity;
    const Vec3 to_center = light.position_m - position_m;
    const float distance2 = math::dot(to_center, to_center);
    if (!has_size(light)) return math::luminance(sample_point(light, to_center).light);
    const float area = scene::area_m2(light);
    return math::luminance(light.color) * light.intensity * area /
           std::max(distance2, 0.25F * area);
}

float Lights::mesh_weight(const Vec3& position_m) const {
    const Vec3 way = emitters_center_m_ - position_m;
    return emitted_ / std::max({math::dot(way, way), emitters_radius2_m2_, 1e-12F});
}

Lights::Choice Lights::choose(const Vec3& position_m, float u) const {
    Choice out;
    float chosen_weight = 0.0F;
    for (std::size_t i = 0; i < count(); ++i) {
        const float w = i < scene_->lights.size() ? weight(scene_->lights[i], position_m)
                                                  : mesh_weight(position_m);
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
    if (choice.light >= scene_->lights.size()) return sample_mesh(position_m, u, pick);
    const Light& light = scene_->lights[choice.light];
    if (light.kind == LightKind::directional)
        return {-light.direction, 1e30F, light.color * light.intensity, 0.0F, false};
    const Vec3 to_center = light.position_m - position_m;
    if (!has_size(light)) return sample_point(light, to_center);
    LightSample out = sample_shape(light, axes_[choice.light], to_center, u);
    out.light = light.color * light.intensity;
    return out;
}

LightSample Lights::sample_mesh(const Vec3& position_m, Vec2 u, float pick) const {
    const auto draw = emitter_shares_.draw(pick);
    const Emitter& e = emitters_[draw.cell];
    // Uniform over the triangle (Turk 1990).
    const float root = std::sqrt(u.x);
    const Hit at{
        .instance = e.instance, .triangle = e.triangle, .u = root * (1.0F - u.y), .v = root * u.y};
    const Vec3 a = position_at(*scene_, {.instance = e.instance, .triangle = e.triangle});
    const Vec3 b =
        position_at(*scene_, {.instance = e.instance, .triangle = e.triangle, .u = 1.0F});
    const Vec3 c =
        position_at(*scene_, {.instance = e.instance, .triangle = e.triangle, .v = 1.0F});
    Vec3 normal = math::cross(b - a, c - a);
    normal /= std::max(math::length(normal), 1e-30F);
    const Vec3 to_place = position_at(*scene_, at) - position_m;
    if (is_double_sided(*scene_, e.instance) && math::dot(normal, to_place) > 0.0F)
        normal = -normal;
    LightSample out = from_area(to_place, normal, e.area_m2);
    out.pdf *= draw.share;
    if (out.pdf > 0.0F) out.light = emission_at(*scene_, *textures_, at);
    return out;
}

Vec3 Lights::met(const Ray& ray, float pdf, float total_weight) const {
    Vec3 sum(0.0F);
    if (!any_with_size_) return sum;
    for (std::size_t i = 0; i < scene_->lights.size(); ++i) {
        const Light& light = scene_->lights[i];
        if (!has_size(light)) continue;
        float own = 0.0F;
        const float distance =
            hit_shape(light, axes_[i], light.position_m - ray.origin, ray.direction, own);
        if (distance <= 0.0F || distance > ray.far_m) continue;
        const float chosen = chance(weight(light, ray.origin), total_weight);
        sum += light.color * (light.intensity * power_share(pdf, own * chosen));
    }
    return sum;
}

float Lights::mesh_pdf(const Hit& hit, const Ray& ray, const Vec3& radiance_nit,
                       float total_weight) const {
    const std::size_t first = first_emitter_[hit.instance];
    if (first == no_emitter || radiance_nit == Vec3(0.0F)) return 0.0F;
    const float area2 = math::length(hit.normal);
    const float cosine = std::fabs(math::dot(hit.normal, ray.direction)) / std::max(area2, 1e-30F);
    const std::size_t emitter = first + hit.triangle;
    const float pdf =
        Terms{}.pdf_area(emitters_[emitter].area_m2, hit.distance_m * hit.distance_m, cosine);
    return pdf * emitter_shares_.share(static_cast<std::uint32_t>(emitter)) *
           chance(mesh_weight(ray.origin), total_weight);
}

}  // namespace facet::trace
