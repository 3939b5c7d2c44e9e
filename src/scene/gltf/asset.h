// A glTF file as read: its document, its buffers, and tables of what was found to be sound in them.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/limits.h"
#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet::scene::gltf {

enum class Component : std::uint16_t {
    i8 = 5120,
    u8 = 5121,
    i16 = 5122,
    u16 = 5123,
    u32 = 5125,
    f32 = 5126
};

[[nodiscard]] constexpr std::size_t component_bytes(Component component) noexcept {
    switch (component) {
        case Component::i8:
        case Component::u8:
            return 1;
        case Component::i16:
        case Component::u16:
            return 2;
        case Component::u32:
        case Component::f32:
            return 4;
    }
    return 4;
}

/// Bytes of one buffer. Not `is_sound` where they could not be had.
struct Buffer {
    bool is_sound = false;
    base::Bytes owned;                 ///< empty where `bytes` views the GLB
    std::span<const std::byte> bytes;  ///< exactly byteLength of them
};

struct View {
    bool is_sound = false;
    bool is_lossy = false;  ///< decoded by a filter: near what was encoded, bounds too
    base::Bytes decoded;    ///< of a compressed view; else empty
    std::span<const std::byte> bytes;
    std::size_t stride = 0;  ///< 0: none given
};

/// An accessor whose every element lies within its buffer. Where not `is_sound` nothing may be
/// read.
struct Accessor {
    bool is_sound = false;
    std::string type;  ///< "VEC3"
    Component component = Component::f32;
    std::size_t components = 0;  ///< of an element; 9 for MAT3
    std::size_t count = 0;
    bool is_normalized = false;
    std::span<const std::byte> bytes;  ///< from the first element on; empty: all zeros
    std::size_t stride = 0;            ///< between elements, padding of matrix columns included
    std::size_t column_stride = 0;     ///< between columns of a matrix, 0 for others
    std::size_t rows = 0;              ///< of a matrix column, 0 for others
    std::vector<std::uint32_t> sparse_indices;  ///< strictly increasing, below count
    std::span<const std::byte> sparse_values;   ///< tightly packed elements
    std::optional<std::uint32_t> view;
    bool is_lossy = false;  ///< of numbers near those encoded, as the bounds may be
};

/// Where a file came from and what it may read.
struct Origin {
    std::string label;                            ///< what messages call it
    std::optional<std::filesystem::path> folder;  ///< of relative URIs; none for standard input
    std::vector<std::filesystem::path> allowed_folders;
};

struct Asset {
    Origin origin;
    base::Bytes file;
    bool is_glb = false;
    Json json;
    std::optional<std::span<const std::byte>> bin;
    std::vector<Buffer> buffers;
    std::vector<View> views;
    std::vector<Accessor> accessors;
    std::vector<base::Bytes> decoded;  ///< that accessors of compressed primitives view
    std::vector<std::string>
        image_mimes;  ///< by image: what its bytes are, where they were looked at
    std::vector<std::filesystem::path> reads;
    std::size_t memory_left = 0;  ///< of limits.memory_bytes, after what was allocated so far
};

/// Splits and parses `file`; everything wrong goes to `problems`. The asset views its own copy of
/// the file.
[[nodiscard]] std::optional<Asset> open_asset(base::Bytes file, Origin origin,
                                              const base::Limits& limits, Problems& problems);

/// Bytes that `uri` names, beneath the asset's folder, or decoded from the URI itself.
[[nodiscard]] base::Result<base::Bytes> read_uri(Asset& asset, const std::string& uri,
                                                 std::size_t max_bytes);

/// Fills the tables from the document, in this order. Each checks what it uses.
void read_buffers(Asset& asset, const base::Limits& limits, Problems& problems);
void read_views(Asset& asset, Problems& problems);
/// Views with a compressed form get what that holds; plain bytes beside it only where it needs a
/// feature that is missing.
void decode_views(Asset& asset, Problems& problems);
void read_accessors(Asset& asset, const base::Limits& limits, Problems& problems);
/// Accessors of compressed primitives get what their streams hold. A strip becomes a list, in the
/// document too.
void decode_primitives(Asset& asset, Problems& problems);

}  // namespace facet::scene::gltf
