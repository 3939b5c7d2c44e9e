// The lobe through which a level of the prefiltered environment is seen, and a mixture that equals
// it. SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace facet::frame {

/// Weight of light at `theta_rad` from the normal for alpha = roughness^2, with n = v = l: D(h) n.l
/// with h half way, zero below the horizon; not normalised. Source: Karis 2013, "Pre-Filtered
/// Environment Map", where the density of sampling D (n.h) / (4 v.h) loses its cosines.
[[nodiscard]] double lobe_weight(double theta_rad, double alpha);

/// Mean of n.l over the facets of a GGX lobe seen from above: integral of D(h) (n.h) max(n.l, 0),
/// what the prefiltered cube's weights add up to.
[[nodiscard]] float lobe_cosine(float alpha);

/// A function of the angle from the normal at fixed angles; its integral over the sphere is 1.
using LobeTable = std::vector<double>;
[[nodiscard]] LobeTable tabulate(const std::function<double(double theta_rad)>& lobe);

/// Weights, none negative and 1 in sum, with which `parts` come nearest to `whole` in relative
/// terms.
[[nodiscard]] std::vector<float> mixture_of(const LobeTable& whole,
                                            std::span<const LobeTable> parts);

}  // namespace facet::frame
