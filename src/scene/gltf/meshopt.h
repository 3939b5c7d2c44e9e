// meshoptimizer's codecs (EXT_meshopt_compression, KHR_meshopt_compression); meshopt.cpp alone
// names the library.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace facet::scene::gltf {

/// The ratified one first: a view has one of them.
inline constexpr auto meshopt_extensions =
    std::to_array<std::string_view>({"KHR_meshopt_compression", "EXT_meshopt_compression"});

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential, color };

/// One compressed view as its extension describes it.
struct MeshoptStream {
    MeshoptMode mode = MeshoptMode::attributes;
    MeshoptFilter filter = MeshoptFilter::none;
    std::size_t count = 0;         ///< elements; of triangles: corners
    std::size_t stride_bytes = 0;  ///< of an element as decoded
    std::span<const std::byte> bytes;
};

/// What mode and filter ask of stride and count (KHR_meshopt_compression, "JSON schema updates").
/// Errors: input_invalid; `where` is the member to blame.
[[nodiscard]] base::Status check_shape(const MeshoptStream& stream);

/// count * stride_bytes bytes. Precondition: check_shape, and that these bytes may be taken.
/// Errors: feature_missing (version 1 of attributes, the filter COLOR, a build without the
/// library), input_invalid.
[[nodiscard]] base::Result<base::Bytes> decode(const MeshoptStream& stream);

}  // namespace facet::scene::gltf
