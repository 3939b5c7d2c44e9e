// A camera that moves while its shutter is open.
// SPDX-License-Identifier: MIT
#include "scene/motion.h"

#include "base/text.h"
#include "scene/spec.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <vector>

namespace facet::scene {

base::Result<CameraMotion> parse_motion(const std::string& text, const Vec3& pivot_m) {
    static const std::vector<std::string> keys = {"move", "turn", "orbit"};
    CameraMotion motion{.pivot_m = pivot_m};
    const auto pairs = parse_key_values(text);
    if (!pairs) return tl::unexpected(pairs.error());
    for (const KeyValue& pair : *pairs) {
        if (std::ranges::find(keys, pair.key) == keys.end())
            return usage_error("unknown key of a camera's motion", pair.key,
                               suggestion(pair.key, keys));
        if (pair.key == "move") {
            const auto move = parse_vector(pair.key, pair.value, {-1e6, 1e6});
            if (!move) return tl::unexpected(move.error());
            motion.move_m = *move;
            continue;
        }
        const auto degrees = parse_in_range(pair.key, pair.value, {-360, 360});
        if (!degrees) return tl::unexpected(degrees.error());
        (pair.key == "turn" ? motion.turn_rad : motion.orbit_rad) = glm::radians(*degrees);
    }
    return motion;
}

Camera camera_at(const Camera& camera, float time) {
    const CameraMotion& motion = camera.motion;
    const float part = time - 0.5F;
    const Vec3 up(0.0F, 1.0F, 0.0F);
    Mat4 moved = glm::translate(Mat4(1.0F), motion.pivot_m);
    moved = glm::rotate(moved, motion.orbit_rad * part, up);
    moved = glm::translate(moved, -motion.pivot_m) * camera.world_from_view;
    moved = glm::translate(moved, motion.move_m * part);
    Camera out = camera;
    out.world_from_view = glm::rotate(moved, motion.turn_rad * part, up);
    return out;
}

bool moves(const Camera& camera) {
    return camera.motion.move_m != Vec3(0.0F) || camera.motion.turn_rad != 0.0F ||
           camera.motion.orbit_rad != 0.0F;
}

}  // namespace facet::scene
