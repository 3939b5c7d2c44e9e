// One light and one point.
// SPDX-License-Identifier: MIT
#include "trace/light_shapes.h"

#include "brdf/light_terms.h"
#include "scene/light_at.h"
#include "trace/geometry.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;
using scene::Light;
using tables::LightKind;
using Terms = brdf::LightTerms<float>;

/// Below this a rectangle's solid angle cancels in float, and area is as good.
constexpr float small_sr = 1e-3F;

/// Of the sphere, one unit away, that fills a directional light's cone.
float sun_radius(const Light& light) { return std::sin(0.5F * light.angle_rad); }

}  // namespace

Vec3 directional_way(const Light& light, Vec2 u) {
    if (light.angle_rad <= 0.0F) return -light.direction;
    return Terms{}.sample_sphere(-light.direction, sun_radius(light), u);
}

LightSample sample_directional(const Light& light, Vec2 u) {
    LightSample out{.direction = directional_way(light, u),
                    .distance_m = Ray{}.far_m,
                    .light = light.color * light.intensity};
    if (light.angle_rad <= 0.0F) return out;
    // Drawn to the rim, where a look may miss it.
    out.has_pdf = true;
    out.pdf = Terms{}.pdf_sphere(1.0F, sun_radius(light));
    out.light *= out.pdf;
    return out;
}

float directional_pdf(const Light& light, const Vec3& to_light) {
    const float radius = sun_radius(light);
    return Terms{}.hit_sphere(-light.direction, radius, to_light) > 0.0F
               ? Terms{}.pdf_sphere(1.0F, radius)
               : 0.0F;
}

LightSample sample_point(const Light& light, const Vec3& to_center) {
    const float distance2 = std::max(math::dot(to_center, to_center), 1e-12F);
    LightSample out;
    out.distance_m = std::sqrt(distance2);
    out.direction = to_center / out.distance_m;
    out.light = scene::illuminance_lux(light, out.direction, distance2);
    return out;
}

LightSample sample_area(const Vec3& to_place, const Vec3& normal, float area) {
    const float distance2 = math::dot(to_place, to_place);
    LightSample out;
    out.has_pdf = true;
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
            return sample_area(to_center + terms.sample_disk(axes.x, axes.y, light.radius_m, u),
                               axes.z, scene::area_m2(light));
        case LightKind::tube: {
            const Vec3 normal = terms.sample_tube_normal(to_center, axes.x, light.radius_m, u);
            const Vec3 place =
                to_center + axes.x * ((u.y - 0.5F) * light.width_m) + normal * light.radius_m;
            return sample_area(place, normal,
                               terms.tube_area(to_center, axes.x, light.radius_m, light.width_m));
        }
        case LightKind::rect: {
            const auto view =
                terms.rect_view(to_center, axes.x, axes.y, axes.z, light.width_m, light.height_m);
            // Where the solid angle cancels in float, area is as good.
            if (view.solid_angle < small_sr)
                return sample_area(to_center + axes.x * ((u.x - 0.5F) * light.width_m) +
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
        case LightKind::ies:
            break;
    }
    return {};
}

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
        case LightKind::ies:
            return distance;
    }
    if (distance > 0.0F)
        pdf = terms.pdf_area(scene::area_m2(light), distance * distance,
                             -math::dot(axes.z, direction));
    return distance;
}

}  // namespace facet::trace
