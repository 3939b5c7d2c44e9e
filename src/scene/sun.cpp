// The sun of an environment.
// SPDX-License-Identifier: MIT
#include "scene/sun.h"

#include "math/color.h"
#include "scene/environment_paint.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace facet::scene {
namespace {

constexpr float widest_rad = 4.0F * math::pi / 180.0F;  // from the brightest pixel
constexpr float least_share = 0.1F;                     // of all light
constexpr float glow_share = 0.05F;                     // of the brightest: belongs to the sun
constexpr float narrowest_rad = 0.53F * math::pi / 180.0F;

/// The pixels around one, and what they have.
class Patch {
public:
    explicit Patch(const image::Image& latlong)
        : map_(latlong.size), values_(latlong.as<float>()) {}

    [[nodiscard]] Vec3 nit(std::size_t at) const {
        return {values_[at * 3], values_[at * 3 + 1], values_[at * 3 + 2]};
    }
    [[nodiscard]] Vec3 direction(std::size_t at) const {
        return map_.direction(at % map_.size().width, at / map_.size().width);
    }
    [[nodiscard]] float solid_angle_sr(std::size_t at) const {
        return map_.solid_angle_sr(at / map_.size().width);
    }
    /// The brightest pixel, and the light of all, luminance times steradians.
    [[nodiscard]] std::size_t brightest(double& all) const {
        std::size_t best = 0;
        float most = -1.0F;
        all = 0.0;
        for (std::size_t row = 0; row < map_.size().height; ++row) {
            double sum = 0.0;
            for (std::size_t at = row * map_.size().width; at < (row + 1) * map_.size().width;
                 ++at) {
                const float y = math::luminance(nit(at));
                sum += static_cast<double>(y);
                if (y > most) {
                    most = y;
                    best = at;
                }
            }
            all += sum * static_cast<double>(map_.solid_angle_sr(row));
        }
        return best;
    }
    /// Calls of(pixel) for those within an angle of a direction.
    template <class Of>
    void around(const Vec3& axis, float angle_rad, const Of& of) const {
        const auto height = static_cast<float>(map_.size().height);
        const float polar = std::acos(std::clamp(axis.y, -1.0F, 1.0F));
        const auto row_of = [&](float angle) {
            return static_cast<std::size_t>(
                std::clamp(angle / math::pi * height, 0.0F, height - 1.0F));
        };
        const float least = std::cos(angle_rad);
        for (std::size_t row = row_of(polar - angle_rad); row <= row_of(polar + angle_rad); ++row)
            for (std::size_t column = 0; column < map_.size().width; ++column)
                if (math::dot(map_.direction(column, row), axis) >= least)
                    of(row * map_.size().width + column);
    }

private:
    LatLong map_;
    std::span<const float> values_;
};

}  // namespace

SplitEnvironment split_sun(const Environment& environment) {
    SplitEnvironment out{environment, std::nullopt};
    const image::Image& latlong = *environment.latlong;
    const Patch patch(latlong);
    double all = 0.0;
    const std::size_t brightest = patch.brightest(all);
    const float threshold = glow_share * math::luminance(patch.nit(brightest));
    if (!(threshold > 0.0F) || !std::isfinite(all)) return out;
    const Vec3 axis = patch.direction(brightest);
    std::vector<std::size_t> pixels;
    Vec3 ring(0.0F);  // what is around: the sky behind the sun
    float ring_sr = 0.0F;
    bool is_wider = false;
    patch.around(axis, 2.0F * widest_rad, [&](std::size_t at) {
        const bool is_bright = math::luminance(patch.nit(at)) > threshold;
        const bool is_near = math::dot(patch.direction(at), axis) >= std::cos(widest_rad);
        if (is_bright && is_near) pixels.push_back(at);
        is_wider = is_wider || (is_bright && !is_near);
        if (is_bright) return;
        ring += patch.nit(at) * patch.solid_angle_sr(at);
        ring_sr += patch.solid_angle_sr(at);
    });
    if (is_wider || !(ring_sr > 0.0F)) return out;
    ring /= ring_sr;
    Vec3 lux(0.0F);
    Vec3 middle(0.0F);
    float squares = 0.0F;
    for (const std::size_t at : pixels) {
        const Vec3 more = glm::max(patch.nit(at) - ring, Vec3(0.0F));
        const float y = math::luminance(more);
        lux += more * patch.solid_angle_sr(at);
        middle += patch.direction(at) * (y * patch.solid_angle_sr(at));
        squares += y * y * patch.solid_angle_sr(at);
    }
    const float illuminance = math::luminance(lux);
    if (!(static_cast<double>(illuminance) >= static_cast<double>(least_share) * all)) return out;
    auto rest = std::make_shared<image::Image>(latlong);
    const auto values = rest->as<float>();
    for (const std::size_t at : pixels)
        for (std::size_t c = 0; c < 3; ++c)
            values[at * 3 + c] = std::min(values[at * 3 + c], ring[static_cast<int>(c)]);
    // A disc of even light that gives the same, and is as concentrated.
    const float disc_sr = illuminance * illuminance / squares;
    const float width = 2.0F * std::acos(std::max(1.0F - disc_sr / (2.0F * math::pi), -1.0F));
    out.rest.latlong = std::move(rest);
    out.sun = Light{.name = "sun",
                    .kind = tables::LightKind::directional,
                    .color = lux / illuminance,
                    .intensity = illuminance,
                    .direction = -math::normalize(middle),
                    .angle_rad = std::max(width, narrowest_rad),
                    .of_environment = true};
    return out;
}

Light turned_sun(const Light& sun, float rotation_deg, float intensity) {
    Light out = sun;
    out.intensity *= intensity;
    const Mat4 turn = glm::rotate(Mat4(1.0F), glm::radians(rotation_deg), Vec3(0.0F, 1.0F, 0.0F));
    out.direction = Vec3(turn * math::Vec4(sun.direction, 0.0F));
    return out;
}

}  // namespace facet::scene
