// Accessors: every offset, count, stride and sparse index checked before one element is read.
// SPDX-License-Identifier: MIT
#include "scene/gltf/asset.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cstring>
#include <limits>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

struct TypeRow {
    std::string_view name;
    std::size_t rows;
    std::size_t columns;
};
constexpr auto type_rows = std::to_array<TypeRow>({{"SCALAR", 1, 1},
                                                   {"VEC2", 2, 1},
                                                   {"VEC3", 3, 1},
                                                   {"VEC4", 4, 1},
                                                   {"MAT2", 2, 2},
                                                   {"MAT3", 3, 3},
                                                   {"MAT4", 4, 4}});

const TypeRow* type_row(std::string_view name) {
    for (const TypeRow& row : type_rows)
        if (row.name == name) return &row;
    return nullptr;
}

std::optional<Component> component_of(const Json& json) {
    switch (unsigned_at(json, "componentType").value_or(0)) {
        case 5120:
            return Component::i8;
        case 5121:
            return Component::u8;
        case 5122:
            return Component::i16;
        case 5123:
            return Component::u16;
        case 5125:
            return Component::u32;
        case 5126:
            return Component::f32;
        default:
            return std::nullopt;
    }
}

/// One accessor on its way into the table.
struct Reading {
    const Asset& asset;
    const Json& json;
    std::string where;
    Accessor& accessor;
    std::size_t element_size;  ///< without the padding after the last column
    const base::Limits& limits;
    Problems& problems;
};

/// Type, component, count; false where the rest cannot be judged.
bool read_shape(const Json& json, Accessor& accessor) {
    accessor.type = string_at(json, "type");
    const TypeRow* const row = type_row(accessor.type);
    const auto component = component_of(json);
    const auto count = unsigned_at(json, "count");
    if (row == nullptr || !component || !count || *count == 0) return false;
    const std::size_t size = component_bytes(*component);
    accessor.component = *component;
    accessor.components = row->rows * row->columns;
    accessor.count = *count;
    accessor.is_normalized = bool_at(json, "normalized").value_or(false);
    accessor.rows = row->columns > 1 ? row->rows : 0;
    // Columns of a matrix start at multiples of 4 bytes (glTF 2.0, section 3.6.2.4).
    accessor.column_stride = row->columns > 1 ? (row->rows * size + 3) / 4 * 4 : 0;
    accessor.stride = row->columns > 1 ? accessor.column_stride * row->columns : row->rows * size;
    return true;
}

bool check_alignment(Reading& r, std::uint64_t offset, const Json& view) {
    const std::size_t size = component_bytes(r.accessor.component);
    if (r.accessor.rows > 0 && offset % 4 != 0) {
        r.problems.error("ACCESSOR_MATRIX_ALIGNMENT", r.where + "/byteOffset",
                         "matrices are not aligned to 4 bytes", std::to_string(offset));
        return false;
    }
    bool is_aligned = true;
    if (offset % size != 0) {
        r.problems.error("ACCESSOR_OFFSET_ALIGNMENT", r.where + "/byteOffset",
                         fmt::format("offset is not a multiple of the component's {} bytes", size),
                         std::to_string(offset));
        is_aligned = false;
    }
    const std::uint64_t view_offset = unsigned_at(view, "byteOffset").value_or(0);
    if ((view_offset % size + offset % size) % size != 0) {
        r.problems.error(
            "ACCESSOR_TOTAL_OFFSET_ALIGNMENT", r.where,
            fmt::format("total offset is not a multiple of the component's {} bytes", size),
            fmt::format("{} + {}", view_offset, offset));
        is_aligned = false;
    }
    return is_aligned;
}

/// Last byte of the last element within the view; all by division, as nothing here may wrap.
bool fits(std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
          std::uint64_t element_size, std::uint64_t length) {
    if (offset > length || element_size > length - offset) return false;
    return count - 1 <= (length - offset - element_size) / stride;
}

bool read_dense(Reading& r) {
    Accessor& a = r.accessor;
    const auto view_index = index_at(r.json, "bufferView");
    if (find(r.json, "bufferView") == nullptr) return true;  // zeros
    const Json* const view =
        view_index ? element_at(r.asset.json, "bufferViews", *view_index) : nullptr;
    if (view == nullptr) return false;
    a.view = view_index;
    a.is_lossy = r.asset.views[*view_index].is_lossy;
    if (find(r.json, "byteOffset") != nullptr && !unsigned_at(r.json, "byteOffset")) return false;
    const std::uint64_t offset = unsigned_at(r.json, "byteOffset").value_or(0);
    bool is_sound = check_alignment(r, offset, *view);
    if (const auto stride = unsigned_at(*view, "byteStride"); stride && *stride > 0) {
        if (*stride < a.stride) {
            r.problems.error("ACCESSOR_SMALL_BYTESTRIDE", r.where,
                             "stride is smaller than an element",
                             fmt::format("{} of {} bytes", *stride, a.stride));
            return false;
        }
        a.stride = *stride;
    }
    const auto length = unsigned_at(*view, "byteLength");
    if (!length) return false;
    if (!fits(offset, a.count, a.stride, r.element_size, *length)) {
        r.problems.error(
            "ACCESSOR_TOO_LONG", find(r.json, "byteOffset") ? r.where + "/byteOffset" : r.where,
            "accessor leaves its buffer view",
            fmt::format("offset {}, {} elements {} bytes apart, but view {} has {} bytes", offset,
                        a.count, a.stride, *view_index, *length));
        return false;
    }
    if (const View& sound = r.asset.views[*view_index]; sound.is_sound)
        a.bytes = sound.bytes.subspan(offset);
    else
        is_sound = false;
    return is_sound;
}

/// Bytes of one of the two tables of a sparse accessor; empty where they are not sound.
std::span<const std::byte> sparse_table(Reading& r, const char* key, std::size_t count,
                                        std::size_t size, std::size_t alignment) {
    const Json* const table = find_path(r.json, std::string("sparse/") + key);
    const auto view_index = table != nullptr ? index_at(*table, "bufferView") : std::nullopt;
    if (!view_index || *view_index >= r.asset.views.size()) return {};
    const std::string where = r.where + "/sparse/" + key;
    const Json& view = *element_at(r.asset.json, "bufferViews", *view_index);
    const std::uint64_t offset = unsigned_at(*table, "byteOffset").value_or(0);
    const std::uint64_t length = unsigned_at(view, "byteLength").value_or(0);
    if (find(view, "byteStride") != nullptr)
        r.problems.error("BUFFER_VIEW_INVALID_BYTE_STRIDE", where + "/bufferView",
                         "sparse data must be tightly packed");
    if ((offset % alignment + unsigned_at(view, "byteOffset").value_or(0) % alignment) %
            alignment !=
        0) {
        r.problems.error("ACCESSOR_TOTAL_OFFSET_ALIGNMENT", where, "sparse data is not aligned",
                         std::to_string(offset));
        return {};
    }
    if (!fits(offset, count, size, size, length)) {
        r.problems.error("ACCESSOR_TOO_LONG", where + "/byteOffset",
                         "sparse data leaves its buffer view",
                         fmt::format("offset {}, {} elements of {} bytes, but view {} has {} bytes",
                                     offset, count, size, *view_index, length));
        return {};
    }
    const View& sound = r.asset.views[*view_index];
    return sound.is_sound ? sound.bytes.subspan(offset, count * size)
                          : std::span<const std::byte>{};
}

bool read_sparse_indices(Reading& r, std::span<const std::byte> bytes, std::size_t size,
                         std::size_t count) {
    r.accessor.sparse_indices.resize(count);
    const std::string where = r.where + "/sparse/indices";
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t index = 0;
        std::memcpy(&index, bytes.data() + i * size, size);  // little-endian, as glTF is
        if (index >= r.accessor.count) {
            r.problems.error("ACCESSOR_SPARSE_INDEX_OOB", where, "sparse index is out of range",
                             fmt::format("{} at {}, but there are {}", index, i, r.accessor.count));
            return false;
        }
        if (i > 0 && index <= r.accessor.sparse_indices[i - 1]) {
            r.problems.error(
                "ACCESSOR_SPARSE_INDICES_NON_INCREASING", where, "sparse indices do not increase",
                fmt::format("{} at {} after {}", index, i, r.accessor.sparse_indices[i - 1]));
            return false;
        }
        r.accessor.sparse_indices[i] = index;
    }
    return true;
}

bool read_sparse(Reading& r) {
    const Json* const sparse = find(r.json, "sparse");
    if (sparse == nullptr) return true;
    const auto count = unsigned_at(*sparse, "count");
    if (!count || *count == 0) return false;
    const bool is_too_many = *count > r.accessor.count;
    if (is_too_many)
        r.problems.error("ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", r.where + "/sparse/count",
                         "more sparse elements than elements",
                         fmt::format("{}, but there are {}", *count, r.accessor.count));
    const Json* const indices = find(*sparse, "indices");
    const auto component = indices != nullptr ? component_of(*indices) : std::nullopt;
    if (!component || *component == Component::i8 || *component == Component::i16 ||
        *component == Component::f32)
        return false;
    const std::size_t size = component_bytes(*component);
    const std::size_t own_size = component_bytes(r.accessor.component);
    const auto index_bytes = sparse_table(r, "indices", *count, size, size);
    const std::size_t packed =
        r.accessor.rows > 0 ? r.accessor.column_stride * (r.accessor.components / r.accessor.rows)
                            : r.element_size;
    r.accessor.sparse_values = sparse_table(r, "values", *count, packed, own_size);
    if (is_too_many || index_bytes.empty() || r.accessor.sparse_values.empty()) return false;
    return read_sparse_indices(r, index_bytes, size, *count);
}

void read_accessor(Asset& asset, std::size_t index, const base::Limits& limits,
                   Problems& problems) {
    const Json& json = *element_at(asset.json, "accessors", index);
    Accessor& accessor = asset.accessors[index];
    if (!read_shape(json, accessor)) return;
    const std::string where = pointer_text("accessors", index);
    if (accessor.count > limits.vertices) {
        problems.add({.code = "ACCESSOR_TOO_LONG",
                      .pointer = where + "/count",
                      .what = "too many elements",
                      .found = fmt::format("{}, limit {}", accessor.count, limits.vertices),
                      .remedy = "raise --max-vertices",
                      .error = ErrorCode::limit_reached});
        return;
    }
    // What decoding it will take at most: four floats or one index an element.
    const std::size_t needed = accessor.count * accessor.components * 4;
    if (needed > asset.memory_left) {
        problems.add({.code = "ACCESSOR_TOO_LONG",
                      .pointer = where + "/count",
                      .what = "accessors need more memory than allowed",
                      .found = fmt::format("{} bytes more, {} left", needed, asset.memory_left),
                      .remedy = "raise --max-memory",
                      .error = ErrorCode::limit_reached});
        return;
    }
    asset.memory_left -= needed;
    const std::size_t tail =
        accessor.rows > 0
            ? accessor.column_stride - accessor.rows * component_bytes(accessor.component)
            : 0;
    Reading reading{asset, json, where, accessor, accessor.stride - tail, limits, problems};
    const bool is_dense_sound = read_dense(reading);
    accessor.is_sound = read_sparse(reading) && is_dense_sound;
}

}  // namespace

void read_accessors(Asset& asset, const base::Limits& limits, Problems& problems) {
    asset.accessors.resize(count_at(asset.json, "accessors"));
    for (std::size_t i = 0; i < asset.accessors.size(); ++i)
        read_accessor(asset, i, limits, problems);
}

}  // namespace facet::scene::gltf
