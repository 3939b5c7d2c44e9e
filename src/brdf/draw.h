// Directions of light drawn at a surface, with what the BRDF is there: what `facet brdf sample`
// prints and lessons estimate by. SPDX-License-Identifier: MIT
#pragma once

#include "brdf/query.h"
#include "brdf/terms.h"

#include <array>
#include <cstdint>
#include <random>

namespace facet::brdf {

/// By which law directions are drawn.
enum class Sampler { uniform, cosine, brdf };
inline constexpr std::array<std::string_view, 3> samplers{"uniform", "cosine", "brdf"};

/// One direction, z along the normal. `pdf` and `value` are 0 below the surface, and where the law
/// goes nowhere.
struct Drawn {
    Terms<double>::real3 l{0.0};
    double pdf = 0.0;    ///< 1/sr
    double value = 0.0;  ///< the whole BRDF, 1/sr
    /// What the direction counts for in an estimate of integral(f cos dl).
    [[nodiscard]] double weight() const { return pdf > 0.0 ? value * l.z / pdf : 0.0; }
};

class Draws {
public:
    /// `queries` are of `choice` and outlive this. Roughness and n.v of the surface are above 0.
    Draws(const tables::BrdfChoice& choice, const QuerySurface& surface, Queries& queries,
          std::uint32_t seed);
    [[nodiscard]] Drawn next(Sampler sampler);

private:
    [[nodiscard]] double random() { return static_cast<double>(engine_()) / 4294967296.0; }

    Terms<double> terms_;
    QuerySurface surface_;
    Queries& queries_;
    Terms<double>::real3 v_;
    Terms<double>::BrdfView view_;
    Terms<double>::BrdfSampler sampler_;
    std::mt19937 engine_;
};

}  // namespace facet::brdf
