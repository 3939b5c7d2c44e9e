// Smooths sparse samples of indirect light over the surfaces that they belong to.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace facet::trace {

/// One place that light was gathered for.
struct GatherPoint {
    math::Vec3 position_m{0.0F};
    math::Vec3 normal{0.0F};
    float spacing_m = 0.0F;  ///< distance to the next place on a surface that faces the eye
    float alpha = 1.0F;      ///< width of the specular lobe
    bool is_surface = false;
};

/// Means of what was drawn there, with the material left out; and of the two lobes' luminance the
/// variance of the mean.
struct GatheredMeans {
    math::Vec3 sky{0.0F};
    math::Vec3 open{0.0F};
    math::Vec3 rest{0.0F};
    math::Vec3 specular{0.0F};        ///< all of it
    math::Vec3 specular_sky{0.0F};    ///< part of it
    math::Vec3 specular_open{0.0F};   ///< what that part would be if nothing stood in the way
    math::Vec3 specular_known{0.0F};  ///< the same, from more draws
    float diffuse_variance = 0.0F;
    float specular_variance = 0.0F;
    float has_diffuse = 0.0F;   ///< 0 where nothing is known of that lobe's light: the surface has
    float has_specular = 0.0F;  ///< no such lobe, or nothing was drawn
};

/// Neighbours of a place whose light may stand in for its own, by
/// lobe: 0 to 8.
struct Helpers {
    float diffuse = 0.0F;
    float specular = 0.0F;
};
[[nodiscard]] std::vector<Helpers> helpers_of(math::Extent size,
                                              const std::vector<GatherPoint>& points,
                                              base::ThreadPool& pool);

/// Variances of few samples say little: each becomes the mean of those around it, `apart` places
/// away.
void even_variances(math::Extent size, const std::vector<GatherPoint>& points,
                    std::vector<GatheredMeans>& means, std::uint32_t apart, base::ThreadPool& pool);

/// As many as reach over what few paths leave uneven: 62 places.
inline constexpr std::uint32_t smooth_passes = 5;

/// Passes of an edge-avoiding a-trous filter whose taps are 1, 2, 4, ... places apart (Dammertz et
/// al. 2010), steered by position, normal and the samples' own variance (Schied et al. 2017,
/// "Spatiotemporal Variance-Guided Filtering", Section 4.4). `points` and `means` are [height,
/// width].
void smooth(math::Extent size, const std::vector<GatherPoint>& points,
            std::vector<GatheredMeans>& means, std::uint32_t passes, base::ThreadPool& pool);

}  // namespace facet::trace
