// The rendering equation by drawing directions: what a white furnace sends back, estimated.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/query.h"

#include <cstdint>
#include <string_view>

namespace facet::teach {

struct Ask;

/// By which law directions are drawn.
enum class Sampler { uniform, cosine, brdf };
[[nodiscard]] bool is_sampler(std::string_view name);

struct Sampling {
    tables::BrdfChoice choice;
    brdf::QuerySurface surface;
    Sampler sampler = Sampler::cosine;
    std::uint32_t samples = 16;
};
[[nodiscard]] Sampling sampling_of(const Ask& ask);

/// (1/N) sum f(l) (n.l) / p(l), light of radiance 1 from everywhere. The same number for the same
/// seed. Source: Pharr, Jakob & Humphreys 2023, Section 2.1.3.
[[nodiscard]] double estimate(brdf::Queries& queries, const Sampling& sampling, std::uint32_t seed);

/// Root mean square error of many such estimates over their true value.
[[nodiscard]] double relative_error(brdf::Queries& queries, const Sampling& sampling, double truth);

}  // namespace facet::teach
