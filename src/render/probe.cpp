// A probe: light that a place in the scene gets from the scene itself.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"
#include "render/resample.h"
#include "render/session.h"

#include <cmath>
#include <utility>

namespace facet::render {
namespace {

constexpr math::Extent probe_size{512, 256};
constexpr std::uint32_t probe_samples = 2;
/// Light that surfaces send each other: the second capture sees what the first one lit.
constexpr int captures = 2;
/// Where surfaces fill less of what is seen, most of it is far away, and not on the scene's box.
constexpr double least_covered = 0.5;

/// Radiance of a picture with coverage; nothing where nothing was drawn.
std::shared_ptr<const image::Image> without_alpha(const image::Image& rgba) {
    auto out = std::make_shared<image::Image>(rgba.size, 3, image::Sample::f32);
    const auto from = rgba.as<float>();
    const auto to = out->as<float>();
    for (std::size_t i = 0; i < to.size(); ++i) {
        const float value = from[i / 3 * 4 + i % 3];
        to[i] = std::isfinite(value) ? value : 0.0F;
    }
    return out;
}

}  // namespace

base::Status Session::capture_probe() {
    const scene::Camera camera = job_->camera;
    const Plan plan = plan_;
    const auto sun = baked_.front().maps.sun;
    scene::Camera eye;
    const math::Bounds bounds = job_->scene.bounds_m();
    const math::Vec3 place =
        plan_.probe_m.value_or(bounds.is_empty() ? math::Vec3(0.0F) : bounds.center());
    eye.world_from_view[3] = math::Vec4(place, 1.0F);
    eye.near_m = std::max(1e-4F * bounds.diagonal(), 1e-6F);
    plan_.background = {};
    plan_.aovs.clear();
    plan_.has_probe = false;
    const bool held_still = std::exchange(holds_still_, true);
    baked_.front().maps.sun.reset();  // a light of its own
    const auto draws = scene_.draws;
    std::erase_if(scene_.draws, [](const frame::Draw& draw) { return draw.light.has_value(); });
    const brdf::AlbedoTable table = brdf::albedo_table(plan_.brdf);
    base::Status status;
    for (int i = 0; i < captures && status; ++i) {
        auto around = draw_around(*this, eye, probe_size, probe_samples, *pool_);
        if (!around) {
            status = tl::unexpected(around.error());
            break;
        }
        base::Warnings warnings;  // of light that the picture has anyway
        auto maps = frame::upload_environment(*gl_, {"probe", without_alpha(around->radiance)}, {},
                                              table.texels, table.size, *pool_, warnings);
        if (!maps) {
            status = tl::unexpected(maps.error());
            break;
        }
        if (around->covered > least_covered)
            maps->box = frame::EnvironmentMaps::Box{bounds.low, bounds.high, place};
        probe_maps_ = std::make_unique<frame::EnvironmentMaps>(std::move(*maps));
    }
    scene_.draws = draws;
    baked_.front().maps.sun = sun;
    holds_still_ = held_still;
    plan_ = plan;
    auto back = look(camera, plan.region, plan.picture);
    if (back) begin_picture();
    return status ? back : status;
}

}  // namespace facet::render
