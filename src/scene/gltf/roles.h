// What an accessor or buffer view is used for; it may only be one thing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace facet::scene::gltf {

enum class Role : std::uint8_t { none, vertices, indices, bind_matrices, animation, image };

[[nodiscard]] std::string_view name_of(Role role);

}  // namespace facet::scene::gltf
