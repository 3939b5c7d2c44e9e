// What a path writes down beside its sum.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/path.h"

#include <type_traits>

namespace facet::trace {

/// Light belongs to the lobe of the first surface that sends it to the viewer, by that lobe's share
/// of the BRDF in the direction it came from.
enum class Books : std::uint8_t { none, by_path, gathered };
/// Where light comes from.
enum class From : std::uint8_t { sky, light, surface };

template <Books books>
class Ledger {
public:
    using Book = std::conditional_t<books == Books::gathered, Gathered, LightPaths>;
    explicit Ledger(Book* book) : book_(book) {}

    void add([[maybe_unused]] const math::Vec3& nit,
             [[maybe_unused]] math::Vec3 LightPaths::*way) const {
        if constexpr (books == Books::by_path) book_->*way += nit;
    }
    /// Light that reaches the first surface `at_once`, or by way of others.
    void write([[maybe_unused]] const math::Vec3& nit,
               [[maybe_unused]] const Bsdf::DiffuseShares& shares, [[maybe_unused]] From from,
               [[maybe_unused]] bool at_once) const {
        const math::Vec3& share =
            at_once && from == From::light ? shares.of_light : shares.of_environment;
        if constexpr (books == Books::by_path) {
            if (at_once && from == From::light)
                book_->add_direct(nit, share);
            else
                book_->add_indirect(nit, share);
        } else if constexpr (books == Books::gathered) {
            const bool is_sky = at_once && from == From::sky;
            (is_sky ? book_->diffuse_sky : book_->diffuse_rest) += nit * share;
            (is_sky ? book_->specular_sky : book_->specular_rest) += nit - nit * share;
        }
    }
    /// What would come of the sky if nothing were in its way.
    void add_open(const math::Vec3& nit, const Bsdf::DiffuseShares& shares) const {
        book_->diffuse_open += nit * shares.of_environment;
        book_->specular_open += nit - nit * shares.of_environment;
    }

private:
    Book* book_;
};

}  // namespace facet::trace
