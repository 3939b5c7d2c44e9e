// Common dielectrics by their index: dielectrics.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

struct Dielectric {
    std::string_view name;
    float ior;
    std::string_view source;
};
inline constexpr auto dielectrics = std::to_array<Dielectric>({
#define DIELECTRIC(name, ior, source) {#name, ior##F, source},
#include "tables/dielectrics.def"
});

}  // namespace facet::tables
