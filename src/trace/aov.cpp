// Further outputs of the reference.
// SPDX-License-Identifier: MIT
#include "trace/aov.h"

#include "trace/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;

/// AOVs have no noise but the edges': as many as the rasteriser's finest quality half.
constexpr std::uint32_t most_samples = 16;

/// Perceptual roughness that the rasteriser's lights shade with at least (lib/shading_bounds.glsl);
/// the terms are those of its picture, where a mirror's D has no end.
constexpr float roughness_min = 0.05F;

/// The terms of the BRDF in the light of the key light; glsl/frame/aov/aov.frag's add_key_light.
void add_key_light(const World& world, const Vec3& v, AovSurface& surface) {
    const Vec3 l = world.key_light.direction_from(surface.position_m);
    const Vec3 sum = v + l;
    const Vec3 h = sum / std::sqrt(std::max(math::dot(sum, sum), 1e-12F));
    surface.n_dot_v = std::clamp(math::dot(surface.normal, v), n_dot_v_min, 1.0F);
    surface.n_dot_l = std::clamp(math::dot(surface.normal, l), 0.0F, 1.0F);
    surface.n_dot_h = std::clamp(math::dot(surface.normal, h), 0.0F, 1.0F);
    surface.v_dot_h = std::clamp(math::dot(v, h), 0.0F, 1.0F);
    Lobes terms = world.model.lights;
    auto s = terms.brdf_surface(surface.albedo, surface.metallic,
                                std::max(surface.roughness, roughness_min));
    s.dielectric_f0 = surface.dielectric_f0;
    s.specular = surface.specular;
    const auto view =
        terms.brdf_view(s, surface.n_dot_v, world.model.albedo(surface.n_dot_v, s.roughness));
    surface.brdf = terms.brdf_terms(view, surface.n_dot_l, surface.n_dot_h, surface.v_dot_h);
}

/// The first surface that is not blended. False where there is none.
bool first_surface(const World& world, Ray ray, const Cone& cone, const Vec3& forward,
                   AovSurface& out) {
    const Vec3 eye = ray.origin;
    for (std::uint32_t i = 0; i < most_passed; ++i) {
        Hit hit;
        if (!world.geometry.intersect(ray, Viewer::camera, hit)) return false;
        const scene::Instance& instance = world.scene.instances[hit.instance];
        if (world.scene.material_of(instance).alpha_mode == scene::AlphaMode::blend) {
            ray = behind(ray, hit);
            continue;
        }
        const Surface s = surface_at(world.scene, world.frames, world.textures, hit, ray.direction,
                                     cone.width_at(hit.distance_m));
        out = {.albedo = s.base_color,
               .normal = s.normal,
               .metallic = s.metallic,
               .roughness = s.roughness,
               .dielectric_f0 = s.dielectric_f0,
               .specular = s.specular,
               .ao = s.ao,
               .emissive = s.emissive_nit,
               .position_m = s.position_m,
               .depth_m = math::dot(s.position_m - eye, forward),
               .object_id = instance.object_id,
               .material_id = s.material + 1};
        return true;
    }
    return false;
}

/// Writes one pixel of every layer.
class PixelAovs {
public:
    PixelAovs(const World& world, const CameraRays& camera, const TraceSettings& settings,
              const std::vector<tables::Aov>& aovs)
        : world_(world),
          camera_(camera),
          settings_(settings),
          samples_(std::min(settings.samples, most_samples)),
          aovs_(aovs),
          with_key_light_(tables::any_of_kind(aovs, tables::AovKind::key_light)),
          forward_(camera.forward()) {}

    void write(std::uint32_t x, std::uint32_t y, std::vector<image::Layer>& layers) const {
        const std::size_t at = std::size_t{y} * settings_.size.width + x;
        const Vec2 corner(settings_.x + x, settings_.y + y);
        std::vector<Vec3> sums(aovs_.size(), Vec3(0.0F));
        const std::uint32_t pixel = (settings_.y + y) * settings_.picture.width + settings_.x + x;
        for (std::uint32_t i = 0; i < samples_; ++i) {
            Sequence sequence(pixel, i, settings_.seed);
            AovSurface surface;
            if (!look(corner + sequence.next_pair(), surface)) continue;
            for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += aov_value(aovs_[k], surface);
        }
        AovSurface center;
        const bool found = look(corner + 0.5F, center);
        for (std::size_t k = 0; k < sums.size(); ++k) {
            Vec3 value = sums[k] / static_cast<float>(samples_);
            if (tables::row(aovs_[k]).average == tables::Average::nearest)
                value = found ? aov_value(aovs_[k], center) : nothing(aovs_[k]);
            const std::size_t channels = layers[k].image.channels;
            for (std::size_t c = 0; c < channels; ++c)
                layers[k].image.as<float>()[at * channels + c] = value[static_cast<int>(c)];
        }
    }

private:
    bool look(Vec2 at_px, AovSurface& surface) const {
        const Ray ray = camera_.ray(at_px);
        const Cone cone{camera_.cone_at_eye_m(), camera_.cone_spread()};
        if (!first_surface(world_, ray, cone, forward_, surface)) return false;
        if (with_key_light_) add_key_light(world_, -ray.direction, surface);
        return true;
    }
    static Vec3 nothing(tables::Aov aov) {
        return Vec3(aov == tables::Aov::depth ? std::numeric_limits<float>::infinity() : 0.0F);
    }

    const World& world_;
    const CameraRays& camera_;
    const TraceSettings& settings_;
    std::uint32_t samples_;
    const std::vector<tables::Aov>& aovs_;
    bool with_key_light_;
    Vec3 forward_;
};

}  // namespace

std::vector<image::Layer> trace_aovs(const World& world, const CameraRays& camera,
                                     const TraceSettings& settings,
                                     const std::vector<tables::Aov>& asked,
                                     base::ThreadPool& pool) {
    std::vector<tables::Aov> aovs;
    for (const tables::Aov aov : asked)
        if (tables::row(aov).kind != tables::AovKind::light_path) aovs.push_back(aov);
    std::vector<image::Layer> layers;
    for (const tables::Aov aov : aovs) {
        const tables::AovRow& row = tables::row(aov);
        const auto channels = static_cast<std::uint32_t>(row.channels.size());
        layers.push_back(
            image::layer_of(row.key, row.channels, {settings.size, channels, image::Sample::f32}));
    }
    if (layers.empty()) return layers;
    const PixelAovs pixels(world, camera, settings, aovs);
    pool.parallel_for(settings.size.height, [&](std::size_t y) {
        for (std::uint32_t x = 0; x < settings.size.width; ++x)
            pixels.write(x, static_cast<std::uint32_t>(y), layers);
    });
    return layers;
}

}  // namespace facet::trace
