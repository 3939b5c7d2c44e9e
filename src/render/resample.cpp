// Pictures that no flat view is.
// SPDX-License-Identifier: MIT
#include "render/resample.h"

#include "base/thread_pool.h"
#include "frame/output/exposure.h"
#include "render/session.h"
#include "scene/projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::render {
namespace {

using math::Extent;
using math::Mat3;
using math::Vec2;
using math::Vec3;
using math::Vec4;

/// Pixels of a flat view for each of the picture's, where they are largest: what is resampled gets
/// blurred.
constexpr float finer = 1.5F;
/// Of a face of the cube around a panorama, so that its edge has neighbours.
constexpr float face_margin_px = 2.0F;
constexpr std::uint32_t most_face_px = 8192;

struct FlatView {
    scene::Camera camera;
    Extent size;
    Mat3 view_from_camera{1.0F};  ///< turns what the picture's camera sees
    Vec2 tangent{1.0F};           ///< of half the view, across and up
    image::Image radiance;

    /// Where a direction lies in it, in pixels from the top left.
    [[nodiscard]] Vec2 place(const Vec3& direction) const {
        const Vec2 at = Vec2(direction.x, -direction.y) / (-direction.z * tangent);
        return (at * 0.5F + 0.5F) * Vec2(size.width, size.height);
    }
};

/// Bilinear, clamped to the edge.
Vec4 texel(const image::Image& image, Vec2 at_px) {
    const auto values = image.as<float>();
    const Vec2 at = at_px - 0.5F;
    const Vec2 low = glm::floor(at);
    const Vec2 part = at - low;
    const auto width = static_cast<float>(image.size.width);
    const auto height = static_cast<float>(image.size.height);
    const auto pixel = [&](float x, float y) {
        const auto column = static_cast<std::size_t>(std::clamp(x, 0.0F, width - 1.0F));
        const auto row = static_cast<std::size_t>(std::clamp(y, 0.0F, height - 1.0F));
        const std::size_t i = (row * image.size.width + column) * 4;
        return Vec4(values[i], values[i + 1], values[i + 2], values[i + 3]);
    };
    return glm::mix(glm::mix(pixel(low.x, low.y), pixel(low.x + 1.0F, low.y), part.x),
                    glm::mix(pixel(low.x, low.y + 1.0F), pixel(low.x + 1.0F, low.y + 1.0F), part.x),
                    part.y);
}

/// The six sides of a cube around the camera, in the order that face_of() counts.
std::vector<FlatView> cube_views(const scene::Camera& camera, Extent picture) {
    const auto wanted =
        static_cast<float>(std::max(picture.width / 2, picture.height)) * (2.0F / math::pi) * finer;
    const std::uint32_t side =
        std::clamp(static_cast<std::uint32_t>(std::ceil(wanted)), 16U, most_face_px);
    const float tangent = 1.0F + 2.0F * face_margin_px / static_cast<float>(side);
    // Columns: right, up and back of each side as the camera sees them.
    const std::array<Mat3, 6> turns = {
        Mat3({0, 0, 1}, {0, 1, 0}, {-1, 0, 0}),  Mat3({0, 0, -1}, {0, 1, 0}, {1, 0, 0}),
        Mat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0}),  Mat3({1, 0, 0}, {0, 0, -1}, {0, 1, 0}),
        Mat3({-1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Mat3(1.0F)};
    std::vector<FlatView> views;
    for (const Mat3& turn : turns) {
        FlatView view{.camera = camera,
                      .size = {side, side},
                      .view_from_camera = glm::transpose(turn),
                      .tangent = Vec2(tangent),
                      .radiance = {}};
        view.camera.projection = scene::Projection::perspective;
        view.camera.yfov_rad = 2.0F * std::atan(tangent);
        view.camera.world_from_view = camera.world_from_view * math::Mat4(turn);
        views.push_back(std::move(view));
    }
    return views;
}

/// +x, -x, +y, -y, +z, -z.
std::size_t face_of(const Vec3& d) {
    const Vec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x > 0.0F ? 0 : 1;
    if (a.y >= a.z) return d.y > 0.0F ? 2 : 3;
    return d.z > 0.0F ? 4 : 5;
}

/// One view that has all that the lens bends into the picture.
FlatView wide_view(const scene::Camera& camera, Extent picture) {
    FlatView view{.camera = camera, .size = {}, .radiance = {}};
    view.camera.distortion = 0.0F;
    view.camera.aberration = 0.0F;
    const float wider = scene::overscan(camera);
    const Vec2 sides = glm::ceil(Vec2(picture.width, picture.height) * (wider * finer));
    view.size = {static_cast<std::uint32_t>(sides.x), static_cast<std::uint32_t>(sides.y)};
    const float half = std::tan(0.5F * camera.yfov_rad) * wider;
    view.camera.yfov_rad = 2.0F * std::atan(half);
    return view;
}

/// Where the taps of a pixel lie: a quarter off its middle.
constexpr std::array<Vec2, 4> taps = {Vec2(0.25F, 0.25F), Vec2(0.75F, 0.25F), Vec2(0.25F, 0.75F),
                                      Vec2(0.75F, 0.75F)};

/// `of(place)` gives radiance at a place of the picture, in pixels from its top left.
template <class Of>
image::Image resampled(const frame::Region& region, base::ThreadPool& pool, const Of& of) {
    image::Image out(region.size, 4, image::Sample::f32);
    const auto values = out.as<float>();
    pool.parallel_for(region.size.height, [&](std::size_t y) {
        for (std::size_t x = 0; x < region.size.width; ++x) {
            Vec4 sum(0.0F);
            for (const Vec2& tap : taps)
                sum += of(Vec2(static_cast<float>(region.x + x), static_cast<float>(region.y + y)) +
                          tap);
            for (std::size_t c = 0; c < 4; ++c)
                values[(y * region.size.width + x) * 4 + c] =
                    sum[static_cast<int>(c)] / static_cast<float>(taps.size());
        }
    });
    return out;
}

image::Image bent(const FlatView& view, const scene::Camera& camera, const Plan& plan,
                  base::ThreadPool& pool) {
    const Vec2 picture(plan.picture.width, plan.picture.height);
    const float wider = scene::overscan(camera);
    return resampled(plan.region, pool, [&](Vec2 at_px) {
        Vec4 out(0.0F);
        for (int c = 0; c < 3; ++c) {
            const Vec2 source = scene::source_of(camera, plan.picture, at_px, c);
            const Vec2 at = ((source / picture - 0.5F) / wider + 0.5F) *
                            Vec2(view.size.width, view.size.height);
            const Vec4 seen = texel(view.radiance, at);
            out[c] = seen[c];
            out.w += seen.w / 3.0F;
        }
        return out;
    });
}

image::Image panorama(const std::vector<FlatView>& views, Extent size, const frame::Region& region,
                      base::ThreadPool& pool) {
    const Vec2 picture(size.width, size.height);
    return resampled(region, pool, [&](Vec2 at_px) {
        const Vec3 direction = scene::panorama_direction(at_px / picture);
        const FlatView& view = views[face_of(direction)];
        return texel(view.radiance, view.place(view.view_from_camera * direction));
    });
}

/// Fills the view's radiance; its depth is the session's last.
base::Status draw_view(Session& session, std::uint32_t samples, FlatView& view) {
    if (auto s = session.look(view.camera, {0, 0, view.size}); !s) return s;
    session.begin_picture();
    for (std::uint32_t i = 0; i < samples; ++i)
        if (auto s = session.draw(i, samples); !s) return s;
    view.radiance = session.read_mean(samples);
    return {};
}

/// Radiance and window depth, pixel by pixel, of all views that count for the exposure.
struct Measured {
    std::vector<float> radiance;
    std::vector<float> depth;
};

base::Status draw_views(Session& session, std::uint32_t samples, std::vector<FlatView>& views,
                        Measured* measured) {
    for (FlatView& view : views) {
        if (auto s = draw_view(session, samples, view); !s) return s;
        if (measured == nullptr) continue;
        const auto values = view.radiance.as<float>();
        measured->radiance.insert(measured->radiance.end(), values.begin(), values.end());
        const std::vector<float> own = session.read_depth();
        for (std::size_t row = view.size.height; row-- > 0;)  // GL's begin at the bottom
            for (std::size_t x = 0; x < view.size.width; ++x)
                measured->depth.push_back(own[row * view.size.width + x]);
    }
    return {};
}

}  // namespace

base::Result<Resampled> draw_resampled(Session& session, base::ThreadPool& pool) {
    const scene::Camera camera = session.job().camera;
    const Plan plan = session.plan();
    std::vector<FlatView> views;
    if (plan.is_panorama)
        views = cube_views(camera, plan.picture);
    else
        views.push_back(wide_view(camera, plan.picture));
    Measured measured;
    const auto drawn =
        draw_views(session, plan.sample_count, views, plan.exposure ? nullptr : &measured);
    const auto back = session.look(camera, plan.region, plan.picture);  // after an error too
    if (!drawn) return tl::unexpected(drawn.error());
    if (!back) return tl::unexpected(back.error());
    return Resampled{plan.is_panorama ? panorama(views, plan.picture, plan.region, pool)
                                      : bent(views.front(), camera, plan, pool),
                     plan.exposure
                         ? *plan.exposure
                         : frame::auto_exposure(measured.radiance, measured.depth, 1, pool)};
}

base::Result<Around> draw_around(Session& session, const scene::Camera& camera, Extent size,
                                 std::uint32_t samples, base::ThreadPool& pool) {
    std::vector<FlatView> views = cube_views(camera, size);
    Around out;
    for (FlatView& view : views) {
        if (auto s = draw_view(session, samples, view); !s) return tl::unexpected(s.error());
        const std::vector<float> depth = session.read_depth();
        const auto surfaces = std::ranges::count_if(depth, [](float d) { return d < 1.0F; });
        out.covered += static_cast<double>(surfaces) /
                       (static_cast<double>(depth.size()) * static_cast<double>(views.size()));
    }
    out.radiance = panorama(views, size, {0, 0, size}, pool);
    return out;
}

}  // namespace facet::render
