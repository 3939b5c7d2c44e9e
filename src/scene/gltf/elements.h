// Elements of a sound accessor as numbers: strides and sparse values undone.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/asset.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace facet::scene::gltf {

/// Whether the file says anything about the elements; where not, all are zeros and nothing to
/// judge.
[[nodiscard]] inline bool has_data(const Accessor& accessor) {
    return !accessor.bytes.empty() || !accessor.sparse_indices.empty();
}
/// [count, components] floats; normalised integers become [0, 1] or [-1, 1], others keep their
/// value (glTF 2.0, section 3.6.2.2). Matrices by columns. Precondition: is_sound.
[[nodiscard]] std::vector<float> read_floats(const Accessor& accessor);
/// Errors: input_invalid at `where` (NaN or infinity).
[[nodiscard]] base::Status check_finite(std::span<const float> values, const std::string& where);
/// [count, components] numbers as they are stored, not normalised. Precondition: is_sound.
[[nodiscard]] std::vector<double> read_raw(const Accessor& accessor);
/// [count * components] whole numbers. Precondition: is_sound, an unsigned component type.
[[nodiscard]] std::vector<std::uint32_t> read_unsigned(const Accessor& accessor);

}  // namespace facet::scene::gltf
