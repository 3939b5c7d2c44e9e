// Draco's codec (KHR_draco_mesh_compression); draco.cpp alone names the library.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"
#include "scene/gltf/asset.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace facet::scene::gltf {

/// An attribute as the accessor wants it.
struct DracoAttribute {
    std::uint32_t id = 0;  ///< the unique id in the stream
    std::size_t components = 0;
    Component component = Component::f32;
    std::string where;  ///< of its entry, for messages
};

/// A compressed primitive, and what the file's accessors say of it.
struct DracoStream {
    std::span<const std::byte> bytes;
    std::string where;
    std::vector<DracoAttribute> attributes;
    std::size_t point_count = 0;
    std::size_t index_count = 0;
    bool is_strip = false;         ///< index_count is of a strip, else of a list
    std::size_t memory_bytes = 0;  ///< that decoding may take
};

struct DracoMesh {
    std::vector<std::uint32_t> indices;   ///< three a triangle, below point_count
    std::vector<base::Bytes> attributes;  ///< in their order: [point_count, components], packed
};

/// The stream's own counts are held against the accessors' before memory is taken for them.
/// Errors: feature_missing (another version than 2.2, a build without the library), limit_reached,
/// input_invalid.
[[nodiscard]] base::Result<DracoMesh> decode_draco(const DracoStream& stream);

}  // namespace facet::scene::gltf
