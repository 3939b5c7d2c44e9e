// What a path's ray is in.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/sequence.h"
#include "trace/surface.h"

namespace facet::trace {

class Medium {
public:
    [[nodiscard]] bool scatters() const { return scattered_ != math::Vec3(0.0F); }
    /// Share of light that is left after that way, where nothing scatters.
    [[nodiscard]] math::Vec3 left_after(float distance_m) const {
        return extinction_per_m_ == math::Vec3(0.0F) ? math::Vec3(1.0F)
                                                     : glm::exp(-extinction_per_m_ * distance_m);
    }

    /// What happens on the way to a surface.
    struct Event {
        math::Vec3 factor{1.0F};  ///< on the path's light; 0: it is at its end
        float distance_m = 0.0F;
        math::Vec3 direction{0.0F};  ///< on from there; 0: the surface is reached
    };
    /// `throughput`: the path's, by which a channel is chosen whose mean way is drawn; all channels
    /// that could have been drawn are weighed (Veach 1997, the balance heuristic). Dim paths end by
    /// chance.
    [[nodiscard]] Event travel(const math::Vec3& direction, float distance_m,
                               const math::Vec3& throughput, Sequence& sequence);

    /// The ray goes on to the surface's far side.
    void cross(const Surface& surface);
    /// What disperses light is met by one channel's light, of which there is that much more: the
    /// surface's index becomes that channel's. Returns the factor on the path's light.
    [[nodiscard]] math::Vec3 choose_channel(Surface& surface, Sequence& sequence);

private:
    math::Vec3 extinction_per_m_{0.0F};
    math::Vec3 scattered_{0.0F};
    float anisotropy_ = 0.0F;
    std::uint32_t turns_ = 0;
    int channel_ = -1;  ///< of dispersed light, the only one left
};

}  // namespace facet::trace
