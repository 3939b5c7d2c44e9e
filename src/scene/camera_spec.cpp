// Cameras: what --camera says, framing a model, and the matrices of a view.
// SPDX-License-Identifier: MIT
#include "scene/camera_spec.h"

#include "base/text.h"
#include "scene/spec.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facet::scene {
namespace {

constexpr float default_fov_deg = 30.0F;
constexpr float margin = 1.08F;  // of the model's silhouette, so that it does not touch the edge
constexpr float near_share = 1e-3F;  // of the distance to the far end: depth keeps its precision
constexpr float smallest_extent_m = 1e-6F;
constexpr float largest_extent_m = 1e9F;  // beyond, distances squared leave float's range

/// What an orbit without a distance makes fit the picture: the box as it is seen, the box at every
/// azimuth (so that a turntable keeps its distance), or the sphere around it.
enum class Fit { view, turn, sphere };
const std::array<std::string, 3> fit_names = {"view", "turn", "sphere"};

struct Orbit {
    float azimuth_deg = 35.0F;
    float elevation_deg = 15.0F;
    std::optional<float> distance_m;
    std::optional<Vec3> target_m;
    Fit fit = Fit::view;
};

base::Result<Orbit> parse_orbit(std::string_view text) {
    static const std::array<std::string, 5> keys = {"azimuth", "elevation", "distance", "target",
                                                    "fit"};
    Orbit orbit;
    for (const std::string_view part : base::split(text, ',')) {
        if (base::trimmed(part).empty()) continue;
        const std::size_t equals = part.find('=');
        const std::string key(base::trimmed(part.substr(0, equals)));
        const std::string_view value =
            equals == std::string_view::npos ? "" : part.substr(equals + 1);
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            return usage_error("unknown key of orbit", key, base::suggestion(key, keys));
        if (key == "fit") {
            const auto* const name = std::ranges::find(fit_names, base::trimmed(value));
            if (name == fit_names.end())
                return usage_error("fit of orbit is view, turn or sphere", value,
                                   base::suggestion(value, fit_names));
            orbit.fit = static_cast<Fit>(name - fit_names.begin());
            continue;
        }
        const auto number = base::parse_number(base::trimmed(value));
        const auto vector = parse_vector(key, value, {-1e9, 1e9});
        const bool is_target = key == "target";
        const bool in_range =
            is_target ? vector.has_value()
                      : number && std::fabs(*number) <= 1e9 && (key != "distance" || *number > 0);
        if (!in_range)
            return usage_error(key + " of orbit is not " +
                                   (is_target           ? "x y z"
                                    : key == "distance" ? "metres above 0"
                                                        : "degrees"),
                               std::string(value),
                               "for example azimuth=35,elevation=15,target=0 1 0");
        if (is_target)
            orbit.target_m = *vector;
        else if (key == "azimuth")
            orbit.azimuth_deg = static_cast<float>(*number);
        else if (key == "elevation")
            orbit.elevation_deg = static_cast<float>(*number);
        else
            orbit.distance_m = static_cast<float>(*number);
    }
    return orbit;
}

/// Columns right, up, back of an eye that looks along -`back`; straight up and down keep +z's side.
math::Mat3 axes_of(const Orbit& orbit) {
    const Vec3 back = math::direction_from(orbit.azimuth_deg, orbit.elevation_deg);
    // The horizontal right of the azimuth: it exists at the poles too, where back x up does not.
    const float a = glm::radians(orbit.azimuth_deg);
    const Vec3 right(std::cos(a), 0.0F, -std::sin(a));
    return {right, math::cross(back, right), back};
}

std::array<Vec3, 8> corners(const math::Bounds& b) {
    std::array<Vec3, 8> out;
    for (std::size_t i = 0; i < 8; ++i)
        out[i] = {(i & 1U) != 0 ? b.high.x : b.low.x, (i & 2U) != 0 ? b.high.y : b.low.y,
                  (i & 4U) != 0 ? b.high.z : b.low.z};
    return out;
}

/// The distance from `target` at which every corner of the box is within the view and its margin.
float fitting_distance(const math::Bounds& bounds, const math::Mat3& axes, const Vec3& target,
                       float yfov_rad, float aspect) {
    const float tan_y = std::tan(yfov_rad * 0.5F) / margin;
    const float tan_x = tan_y * aspect;
    float distance = 0.0F;
    for (const Vec3& corner : corners(bounds)) {
        const Vec3 p = (corner - target) * axes;  // rows times vector: coordinates along the axes
        distance = std::max({distance, p.z + std::fabs(p.x) / tan_x, p.z + std::fabs(p.y) / tan_y});
    }
    return distance;
}

math::Bounds finite(const math::Bounds& b) {
    return {glm::clamp(b.low, Vec3(-largest_extent_m), Vec3(largest_extent_m)),
            glm::clamp(b.high, Vec3(-largest_extent_m), Vec3(largest_extent_m))};
}

/// The box that cameras are aimed at made finite and not empty.
math::Bounds framed_bounds(const Scene& scene) {
    math::Bounds b = finite(scene.aimed_bounds_m());
    if (b.is_empty()) return {Vec3(-0.5F), Vec3(0.5F)};
    if (b.diagonal() < smallest_extent_m) {
        b.low -= Vec3(smallest_extent_m);
        b.high += Vec3(smallest_extent_m);
    }
    return b;
}

/// Smallest and largest depth of a box.
Vec2 depths_of(const Camera& camera, const math::Bounds& bounds) {
    const Mat4 view = view_from_world(camera);
    Vec2 out(1e30F, 0.0F);
    for (const Vec3& corner : corners(bounds)) {
        const float depth = -(view * Vec4(corner, 1.0F)).z;
        out = {std::min(out.x, depth), std::max(out.y, depth)};
    }
    return out;
}

/// Near and far planes around `model` and all else that is seen, for cameras that do not come with
/// the file.
void set_depth_range(Camera& camera, const math::Bounds& model, const math::Bounds& seen) {
    const Vec2 of_model = depths_of(camera, model);
    const Vec2 of_seen = seen.is_empty() ? of_model : depths_of(camera, seen);
    const auto far = [](float depth) { return std::max(depth * 1.01F, smallest_extent_m); };
    camera.far_m = far(std::max(of_model.y, of_seen.y));
    // By the model alone: a lamp far away cuts nothing off that is near.
    camera.near_m = std::max(std::min(of_model.x, of_seen.x) * 0.99F, far(of_model.y) * near_share);
}

/// Where an orbit's eye is, when its distance is not given.
float fitted_distance(const Orbit& orbit, const math::Bounds& bounds, const Vec3& target,
                      float yfov_rad, float aspect) {
    if (orbit.fit == Fit::view)
        return fitting_distance(bounds, axes_of(orbit), target, yfov_rad, aspect);
    if (orbit.fit == Fit::sphere) {
        const float half = std::atan(std::tan(yfov_rad * 0.5F) * std::min(aspect, 1.0F) / margin);
        const float radius = bounds.diagonal() * 0.5F + math::length(bounds.center() - target);
        return radius / std::sin(half);
    }
    float distance = 0.0F;
    constexpr int step_deg = 5;
    for (int turn_deg = 0; turn_deg < 360; turn_deg += step_deg) {
        const Orbit turned{.azimuth_deg = static_cast<float>(turn_deg),
                           .elevation_deg = orbit.elevation_deg};
        distance =
            std::max(distance, fitting_distance(bounds, axes_of(turned), target, yfov_rad, aspect));
    }
    return distance;
}

Camera orbit_camera(const Scene& scene, const Orbit& orbit, float fov_deg, math::Extent size) {
    const math::Bounds bounds = framed_bounds(scene);
    const math::Mat3 axes = axes_of(orbit);
    const Vec3 target = orbit.target_m.value_or(bounds.center());
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    Camera camera{.name = "auto"};
    camera.yfov_rad = glm::radians(fov_deg > 0.0F ? fov_deg : default_fov_deg);
    const float distance = orbit.distance_m
                               ? *orbit.distance_m
                               : fitted_distance(orbit, bounds, target, camera.yfov_rad, aspect);
    camera.world_from_view = Mat4(axes);
    camera.world_from_view[3] = Vec4(target + axes[2] * distance, 1.0F);
    math::Bounds model = bounds;
    // What has moved since is to be seen too.
    if (const math::Bounds now = scene.bounds_m(); scene.aimed_m && !now.is_empty())
        for (const Vec3& corner : corners(finite(now))) model.add(corner);
    set_depth_range(camera, model, finite(scene.seen_bounds_m()));
    return camera;
}

std::string list_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) names.push_back(base::escaped(camera.name));
    return names.empty() ? "the file has no cameras; auto, or orbit:azimuth=35,elevation=15"
                         : "one of " + base::join(names, ", ") + ", auto, orbit:…";
}

}  // namespace

bool is_orbit(std::string_view spec) { return spec == "orbit" || spec.starts_with("orbit:"); }

base::Result<Camera> resolve_camera(const Scene& scene, const std::string& spec, float fov_deg,
                                    math::Extent size) {
    if (is_orbit(spec)) {
        const auto orbit = parse_orbit(spec.size() > 6 ? std::string_view(spec).substr(6) : "");
        if (!orbit) return tl::unexpected(orbit.error());
        return orbit_camera(scene, *orbit, fov_deg, size);
    }
    if (spec == "auto" && scene.cameras.empty()) return orbit_camera(scene, {}, fov_deg, size);
    std::size_t index = scene.cameras.size();
    if (spec == "auto") index = 0;
    for (std::size_t i = 0; i < scene.cameras.size() && index == scene.cameras.size(); ++i)
        if (scene.cameras[i].name == spec || scene.cameras[i].node == spec) index = i;
    const auto number = base::parse_integer(spec);
    if (index == scene.cameras.size() && number && *number >= 0 &&
        static_cast<std::size_t>(*number) < scene.cameras.size())
        index = static_cast<std::size_t>(*number);
    if (index == scene.cameras.size()) return usage_error("no such camera", spec, list_of(scene));
    Camera camera = scene.cameras[index];
    if (fov_deg > 0.0F) camera.yfov_rad = glm::radians(fov_deg);
    return camera;
}

base::Result<std::string> turned_orbit(const std::string& spec, double degrees) {
    Orbit orbit;
    if (is_orbit(spec)) {
        const auto parsed = parse_orbit(spec.size() > 6 ? std::string_view(spec).substr(6) : "");
        if (!parsed) return tl::unexpected(parsed.error());
        orbit = *parsed;
    } else if (spec != "auto") {
        return usage_error("only auto and orbit:… can be turned around the model", spec,
                           "orbit:azimuth=35,elevation=15");
    }
    const double azimuth_deg = std::fmod(static_cast<double>(orbit.azimuth_deg) + degrees, 360.0);
    std::string out = fmt::format("orbit:azimuth={},elevation={}", static_cast<float>(azimuth_deg),
                                  orbit.elevation_deg);
    if (orbit.target_m)
        out += fmt::format(",target={} {} {}", orbit.target_m->x, orbit.target_m->y,
                           orbit.target_m->z);
    if (orbit.distance_m) return out + fmt::format(",distance={}", *orbit.distance_m);
    const Fit fit = orbit.fit == Fit::view ? Fit::turn : orbit.fit;
    return out + ",fit=" + fit_names[static_cast<std::size_t>(fit)];
}

float middle_depth_m(const Camera& camera, const Scene& scene) {
    const math::Bounds bounds = framed_bounds(scene);
    const float depth = -(view_from_world(camera) * Vec4(bounds.center(), 1.0F)).z;
    return depth > camera.near_m ? depth : std::max(camera.near_m * 2.0F, smallest_extent_m);
}

void set_projection(Camera& camera, const Scene& scene, std::string_view projection) {
    const float depth = middle_depth_m(camera, scene);
    if (projection == "panorama") {
        camera.projection = Projection::panorama;
    } else if (projection == "orthographic" && camera.projection == Projection::perspective) {
        camera.projection = Projection::orthographic;
        camera.ymag_m = depth * std::tan(0.5F * camera.yfov_rad);
    } else if (projection == "perspective" && camera.projection == Projection::orthographic) {
        camera.projection = Projection::perspective;
        camera.yfov_rad = 2.0F * std::atan(camera.ymag_m / depth);
        camera.near_m = std::max(camera.near_m, depth * near_share);
    }
}

Mat4 view_from_world(const Camera& camera) { return math::inverse(camera.world_from_view); }

Mat4 clip_from_view(const Camera& camera, math::Extent size, Vec2 jitter_px) {
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    const float aspect = width / height;
    const float near = camera.near_m;
    Mat4 m(0.0F);
    if (camera.projection == Projection::perspective) {
        const float scale = 1.0F / std::tan(camera.yfov_rad * 0.5F);
        m[0][0] = scale / aspect;
        m[1][1] = scale;
        const bool infinite = camera.far_m <= near;
        m[2][2] = infinite ? -1.0F : -(camera.far_m + near) / (camera.far_m - near);
        m[2][3] = -1.0F;
        m[3][2] = infinite ? -2.0F * near : -2.0F * camera.far_m * near / (camera.far_m - near);
    } else {
        const float far = camera.far_m > near ? camera.far_m : near + 1e4F;
        m[0][0] = 1.0F / (camera.ymag_m * aspect);
        m[1][1] = 1.0F / camera.ymag_m;
        m[2][2] = -2.0F / (far - near);
        m[3][2] = -(far + near) / (far - near);
        m[3][3] = 1.0F;
    }
    // A sample right of the centre sees what lies right of it: the picture moves left, by pixels of
    // width 2/w.
    Mat4 jitter(1.0F);
    jitter[3][0] = -2.0F * jitter_px.x / width;
    jitter[3][1] = 2.0F * jitter_px.y / height;
    return jitter * m;
}

}  // namespace facet::scene
