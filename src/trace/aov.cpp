// Further outputs of the reference.
// SPDX-License-Identifier: MIT
#include "trace/aov.h"

#include "trace/sequence.h"

#include <cmath>
#include <limits>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;

/// More passed blended surfaces than this are taken for the background.
constexpr int most_passed = 64;

/// The first surface that is not blended. False where there is none.
bool first_surface(const World& world, Ray ray, const Cone& cone, const Vec3& forward,
                   AovSurface& out) {
    const Vec3 eye = ray.origin;
    for (int i = 0; i < most_passed; ++i) {
        Hit hit;
        if (!world.geometry.intersect(ray, Viewer::camera, hit)) return false;
        const scene::Instance& instance = world.scene.instances[hit.instance];
        const scene::Mesh& mesh = world.scene.meshes[instance.mesh.index];
        if (world.scene.materials[mesh.material.index].alpha_mode == scene::AlphaMode::blend) {
            ray.near_m = std::nextafter(hit.distance_m, 1e30F) * (1.0F + 1e-6F);
            continue;
        }
        const float cone_m = cone.width_m + cone.spread * hit.distance_m;
        const Surface s =
            surface_at(world.scene, world.frames, world.textures, hit, ray.direction, cone_m);
        out = {.albedo = s.base_color,
               .normal = s.normal,
               .metallic = s.metallic,
               .roughness = s.roughness,
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

const tables::AovRow& row_of(tables::Aov aov) {
    return tables::aovs[static_cast<std::size_t>(aov)];
}

/// Writes one pixel of every layer.
class PixelAovs {
public:
    PixelAovs(const World& world, const CameraRays& camera, const AovSpec& spec)
        : world_(world), camera_(camera), spec_(spec), forward_(camera.forward()) {}

    void write(std::uint32_t x, std::uint32_t y, std::vector<image::Layer>& layers) const {
        const std::size_t at = std::size_t{y} * spec_.size.width + x;
        const Vec2 corner(spec_.x + x, spec_.y + y);
        std::vector<Vec3> sums(spec_.aovs.size(), Vec3(0.0F));
        const std::uint32_t pixel = (spec_.y + y) * spec_.picture.width + spec_.x + x;
        for (std::uint32_t i = 0; i < spec_.samples; ++i) {
            Sequence sequence(pixel, i, spec_.seed);
            AovSurface surface;
            if (!look(corner + sequence.next_pair(), surface)) continue;
            for (std::size_t k = 0; k < sums.size(); ++k)
                sums[k] += aov_value(spec_.aovs[k], surface);
        }
        AovSurface center;
        const bool found = look(corner + 0.5F, center);
        for (std::size_t k = 0; k < sums.size(); ++k) {
            Vec3 value = sums[k] / static_cast<float>(spec_.samples);
            if (row_of(spec_.aovs[k]).average == tables::Average::nearest)
                value = found ? aov_value(spec_.aovs[k], center) : nothing(spec_.aovs[k]);
            const std::size_t channels = layers[k].image.channels;
            for (std::size_t c = 0; c < channels; ++c)
                layers[k].image.as<float>()[at * channels + c] = value[static_cast<int>(c)];
        }
    }

private:
    bool look(Vec2 at_px, AovSurface& surface) const {
        return first_surface(world_, camera_.ray(at_px),
                             {camera_.cone_at_eye_m(), camera_.cone_spread()}, forward_, surface);
    }
    static Vec3 nothing(tables::Aov aov) {
        return Vec3(aov == tables::Aov::depth ? std::numeric_limits<float>::infinity() : 0.0F);
    }

    const World& world_;
    const CameraRays& camera_;
    const AovSpec& spec_;
    Vec3 forward_;
};

}  // namespace

std::vector<image::Layer> trace_aovs(const World& world, const CameraRays& camera,
                                     const AovSpec& spec, base::ThreadPool& pool) {
    std::vector<image::Layer> layers;
    for (const tables::Aov aov : spec.aovs) {
        const tables::AovRow& row = row_of(aov);
        image::Layer layer{.name = std::string(row.key), .channels = {}, .image = {}};
        for (const char channel : row.channels) layer.channels.emplace_back(1, channel);
        layer.image = image::Image(spec.size, static_cast<std::uint32_t>(row.channels.size()),
                                   image::Sample::f32);
        layers.push_back(std::move(layer));
    }
    if (layers.empty()) return layers;
    const PixelAovs pixels(world, camera, spec);
    pool.parallel_for(spec.size.height, [&](std::size_t y) {
        for (std::uint32_t x = 0; x < spec.size.width; ++x)
            pixels.write(x, static_cast<std::uint32_t>(y), layers);
    });
    return layers;
}

}  // namespace facet::trace
