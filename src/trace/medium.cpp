// What a path's ray is in.
// SPDX-License-Identifier: MIT
#include "trace/medium.h"

#include "trace/bsdf.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec3;

/// Paths are not ended by chance before this turn, and always after the last.
constexpr std::uint32_t first_roulette = 8;
constexpr std::uint32_t last_turn = 1024;

/// Henyey & Greenstein 1941, Eq. 2, by its inverse.
Vec3 scattered_way(const Vec3& direction, float anisotropy, math::Vec2 u) {
    float cosine = 1.0F - 2.0F * u.x;
    constexpr float even = 1e-3F;
    if (std::fabs(anisotropy) > even) {
        const float x =
            (1.0F - anisotropy * anisotropy) / (1.0F + anisotropy - 2.0F * anisotropy * u.x);
        cosine = (1.0F + anisotropy * anisotropy - x * x) / (2.0F * anisotropy);
    }
    cosine = std::clamp(cosine, -1.0F, 1.0F);
    const float sine = std::sqrt(1.0F - cosine * cosine);
    const float phi = 2.0F * math::pi * u.y;
    return LobeFrame(direction).world({sine * std::cos(phi), sine * std::sin(phi), cosine});
}

/// Fresnel 1823, at normal incidence. `ior`: over the index around.
float reflected_head_on(float ior) {
    const float ratio = (ior - 1.0F) / (ior + 1.0F);
    return ratio * ratio;
}

}  // namespace

Medium::Event Medium::travel(const Vec3& direction, float distance_m, const Vec3& throughput,
                             Sequence& sequence) {
    const Volume& volume = here();
    const Vec3 carried = glm::max(throughput * glm::max(volume.scattered, Vec3(1e-3F)), Vec3(0.0F));
    const float sum = carried.x + carried.y + carried.z;
    const Vec3 chance = sum > 0.0F ? carried / sum : Vec3(1.0F / 3.0F);
    const math::Vec2 u = sequence.next_pair();
    const int channel = u.x < chance.x ? 0 : u.x < chance.x + chance.y ? 1 : 2;
    const float per_m = volume.extinction_per_m[channel];
    Event out;
    out.distance_m = per_m > 0.0F ? -std::log(1.0F - u.y) / per_m : distance_m;
    const bool scatters = out.distance_m < distance_m;
    out.distance_m = std::min(out.distance_m, distance_m);
    const Vec3 left = glm::exp(-volume.extinction_per_m * out.distance_m);
    const Vec3 density = scatters ? left * volume.extinction_per_m : left;
    const float drawn = math::dot(chance, density);
    if (!(drawn > 0.0F)) {
        out.factor = Vec3(0.0F);
        return out;
    }
    out.factor = density / drawn;
    if (!scatters) return out;
    out.factor *= volume.scattered;
    if (++turns_ > first_roulette) {
        const Vec3 kept = throughput * out.factor;
        const float survival = std::min(1.0F, std::max({kept.x, kept.y, kept.z}));
        if (turns_ > last_turn || !(sequence.next() < survival)) {
            out.factor = Vec3(0.0F);
            return out;
        }
        out.factor /= survival;
    }
    out.direction = scattered_way(direction, volume.anisotropy, sequence.next_pair());
    return out;
}

std::size_t Medium::left_at(const Surface& surface) const {
    for (std::size_t i = depth_; i > 0; --i)
        if (volumes_[i].material == surface.material) return i;
    return depth_;  // entered through a surface of another material
}

void Medium::cross(const Surface& surface) {
    if (!surface.has_volume) return;
    if (surface.front && depth_ == most_nested) {
        ++beyond_;
    } else if (surface.front) {
        ++depth_;
        const bool scatters = surface.extinction_per_m != Vec3(0.0F);
        volumes_[depth_] = {.material = surface.material,
                            .extinction_per_m = surface.extinction_per_m,
                            .scattered = scatters ? surface.scattered : Vec3(0.0F),
                            .anisotropy = surface.scatter_anisotropy,
                            .ior = std::max(surface.ior, 1.0F)};
    } else if (beyond_ > 0) {
        --beyond_;
    } else if (depth_ > 0) {
        std::copy(volumes_.begin() + left_at(surface) + 1, volumes_.begin() + depth_ + 1,
                  volumes_.begin() + left_at(surface));
        --depth_;
    }
}

const Medium::Volume& Medium::around(const Surface& surface) const {
    if (surface.front || depth_ == 0) return here();
    return volumes_[left_at(surface) == depth_ ? depth_ - 1 : depth_];
}

Vec3 Medium::extinction_beyond(const Surface& surface) const {
    if (!surface.has_volume) return extinction_per_m();
    return surface.front ? surface.extinction_per_m : around(surface).extinction_per_m;
}

Vec3 Medium::meet(Surface& surface, Sequence& sequence) {
    Vec3 kept(1.0F);
    if (!surface.has_volume) return kept;
    if (surface.dispersion > 0.0F) {
        if (channel_ < 0) {
            channel_ = std::min(static_cast<int>(sequence.next() * 3.0F), 2);
            kept = Vec3(0.0F);
            kept[channel_] = 3.0F;
        }
        surface.ior =
            Lobes{}.dispersed_ior(surface.ior, surface.dispersion, static_cast<float>(channel_));
    }
    // Where another volume overlaps with its back, that one goes on and nothing bends.
    const bool goes_on = !surface.front && left_at(surface) != depth_;
    surface.ior_around = goes_on ? surface.ior : around(surface).ior;
    if (surface.front && surface.ior_around > 1.0F) {
        const float in_air = reflected_head_on(surface.ior);
        surface.dielectric_f0 *=
            reflected_head_on(surface.ior / surface.ior_around) / std::max(in_air, 1e-6F);
    }
    return kept;
}

}  // namespace facet::trace
