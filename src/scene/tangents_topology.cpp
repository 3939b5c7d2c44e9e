// Which corners of a mesh are one vertex, and which triangles meet at an edge.
// SPDX-License-Identifier: MIT
#include "scene/tangents_topology.h"

#include <array>
#include <bit>

namespace facet::scene::tangents {
namespace {

/// Finalizer of SplitMix64 (Steele et al. 2014): every bit of the input reaches every bit of the
/// output.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ x >> 27) * 0x94D049BB133111EBULL;
    return x ^ x >> 31;
}

using Key = std::array<float, 8>;

Key key_of(const Mesh& mesh, const std::vector<Vec2>& uv, std::size_t v) {
    const Vec3& p = mesh.positions_m[v];
    const Vec3& n = mesh.normals[v];
    // + 0 turns -0 into 0, which equals it.
    return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F,     n.x + 0.0F,
            n.y + 0.0F, n.z + 0.0F, uv[v].x + 0.0F, uv[v].y + 0.0F};
}

std::uint64_t hash_of(const Key& key) {
    std::uint64_t hash = 0;
    for (const float x : key)
        hash = mixed(hash + 0x9E3779B97F4A7C15ULL + std::bit_cast<std::uint32_t>(x));
    return hash;
}

/// Power of two with room to spare, for open addressing.
std::size_t table_size(std::size_t count) { return std::bit_ceil(count * 2 + 2); }

}  // namespace

std::vector<std::uint32_t> weld_vertices(const Mesh& mesh, const std::vector<Vec2>& uv) {
    const std::size_t count = mesh.positions_m.size();
    std::vector<std::uint32_t> weld(count);
    std::vector<std::uint32_t> table(table_size(count), none);
    const std::size_t mask = table.size() - 1;
    for (std::size_t v = 0; v < count; ++v) {
        const Key key = key_of(mesh, uv, v);
        std::size_t slot = hash_of(key) & mask;
        while (table[slot] != none && key_of(mesh, uv, table[slot]) != key)
            slot = (slot + 1) & mask;
        if (table[slot] == none) table[slot] = static_cast<std::uint32_t>(v);
        weld[v] = table[slot];
    }
    return weld;
}

namespace {

/// Corners that wait for the triangle across their edge, first come first served. A list for each
/// directed edge, so that a million triangles over one edge cost no more than a million over as
/// many.
class Waiting {
public:
    explicit Waiting(std::size_t corner_count)
        : next_(corner_count, none), slots_(table_size(corner_count)) {}

    void add(std::uint64_t edge, std::uint32_t corner) {
        Slot& slot = find(edge);
        (slot.first == none ? slot.first : next_[slot.last]) = corner;
        slot.edge = edge;
        slot.last = corner;
        slot.is_used = true;
    }
    /// `none` where nobody waits.
    std::uint32_t take(std::uint64_t edge) {
        Slot& slot = find(edge);
        const std::uint32_t corner = slot.first;
        if (corner != none) slot.first = next_[corner];
        return corner;
    }

private:
    struct Slot {
        std::uint64_t edge = 0;
        std::uint32_t first = none;
        std::uint32_t last = none;
        bool is_used = false;
    };
    Slot& find(std::uint64_t edge) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = mixed(edge) & mask;
        while (slots_[at].is_used && slots_[at].edge != edge) at = (at + 1) & mask;
        return slots_[at];
    }
    std::vector<std::uint32_t> next_;
    std::vector<Slot> slots_;
};

}  // namespace

std::vector<std::uint32_t> find_neighbors(const std::vector<std::uint32_t>& indices,
                                          const std::vector<std::uint32_t>& weld) {
    const auto count = static_cast<std::uint32_t>(indices.size());
    std::vector<std::uint32_t> neighbors(count, none);
    Waiting waiting(count);
    for (std::uint32_t corner = 0; corner < count; ++corner) {
        const std::uint64_t start = weld[indices[corner]];
        const std::uint64_t end = weld[indices[corner % 3 == 2 ? corner - 2 : corner + 1]];
        if (start == end) continue;
        const std::uint32_t other = waiting.take(end << 32 | start);
        if (other == none) {
            waiting.add(start << 32 | end, corner);
            continue;
        }
        neighbors[corner] = other;
        neighbors[other] = corner;
    }
    return neighbors;
}

}  // namespace facet::scene::tangents
