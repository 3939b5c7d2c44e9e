// What a path's ray is in.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/sequence.h"
#include "trace/surface.h"

#include <array>

namespace facet::trace {

/// Volumes within volumes: each is left where a surface of its material is, so that what floats in
/// a drink, or overlaps with its glass, is in that again outside.
class Medium {
public:
    [[nodiscard]] bool scatters() const { return here().scattered != math::Vec3(0.0F); }
    [[nodiscard]] const math::Vec3& extinction_per_m() const { return here().extinction_per_m; }
    /// On the surface's far side.
    [[nodiscard]] math::Vec3 extinction_beyond(const Surface& surface) const;

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
    /// Gives the surface of a volume the index that light meets there: in what is around it, and of
    /// one channel's light, of which there is that much more, where it disperses. Returns the
    /// factor on the path's light.
    [[nodiscard]] math::Vec3 meet(Surface& surface, Sequence& sequence);

private:
    /// One volume; air where nothing is set.
    struct Volume {
        std::uint32_t material = 0;
        math::Vec3 extinction_per_m{0.0F};
        math::Vec3 scattered{0.0F};
        float anisotropy = 0.0F;
        float ior = 1.0F;
    };
    [[nodiscard]] const Volume& here() const { return volumes_[depth_]; }
    /// The place in volumes_ of the one that the back of a surface is of: the innermost, where the
    /// path entered none of its material.
    [[nodiscard]] std::size_t left_at(const Surface& surface) const;
    /// What is around the volume whose surface that is.
    [[nodiscard]] const Volume& around(const Surface& surface) const;

    static constexpr std::size_t most_nested = 4;
    std::array<Volume, most_nested + 1> volumes_{};  ///< air, and what the path entered
    std::size_t depth_ = 0;
    std::size_t beyond_ = 0;  ///< volumes entered that there was no room for
    std::uint32_t turns_ = 0;
    int channel_ = -1;  ///< of dispersed light, the only one left
};

}  // namespace facet::trace
