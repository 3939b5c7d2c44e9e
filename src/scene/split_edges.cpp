// Triangles split until their edges are short, without cracks.
// SPDX-License-Identifier: MIT
#include "scene/split_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace facet::scene {
namespace {

/// Two numbers in either order.
std::uint64_t edge_of(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

std::vector<std::uint32_t> number_places(const std::vector<Vec3>& positions) {
    std::map<std::tuple<float, float, float>, std::uint32_t> numbers;
    std::vector<std::uint32_t> out;
    out.reserve(positions.size());
    for (const Vec3& p : positions)
        // A place has the number of its first vertex.
        out.push_back(numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(out.size()))
                          .first->second);
    return out;
}

template <class T>
void add_middle(std::vector<T>& values, std::uint32_t a, std::uint32_t b) {
    if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5F);
}

Vec3 middle_direction(const Vec3& a, const Vec3& b) {
    const Vec3 sum = a + b;
    return math::length(sum) > 1e-6F ? math::normalize(sum) : a;
}

class Splitter {
public:
    Splitter(Mesh& mesh, std::vector<Vec2>& at, float longest)
        : mesh_(mesh), at_(at), longest_(longest), places_(number_places(mesh.positions_m)) {}

    /// Whether an edge was too long.
    bool pass() {
        halved_.clear();
        middles_.clear();
        for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
            const auto [a, b] = edge(i);
            const float length = math::length(at_[a] - at_[b]);
            if (length > longest_ && std::isfinite(length))
                halved_.try_emplace(edge_of(places_[a], places_[b]), none);
        }
        if (halved_.empty()) return false;
        std::vector<std::uint32_t> before = std::exchange(mesh_.indices, {});
        mesh_.indices.reserve(before.size() * 4);
        for (std::size_t first = 0; first < before.size(); first += 3)
            split({before[first], before[first + 1], before[first + 2]});
        return true;
    }
    std::vector<std::uint32_t> take_places() { return std::move(places_); }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> edge(std::size_t i) const {
        return {mesh_.indices[i], mesh_.indices[i % 3 == 2 ? i - 2 : i + 1]};
    }

    /// The vertex in the middle of an edge that is halved, else `none`.
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto halved = halved_.find(edge_of(places_[a], places_[b]));
        if (halved == halved_.end()) return none;
        const auto next = static_cast<std::uint32_t>(mesh_.positions_m.size());
        const auto [found, is_new] = middles_.try_emplace(edge_of(a, b), next);
        if (!is_new) return found->second;
        add_middle(mesh_.positions_m, a, b);
        mesh_.normals.push_back(middle_direction(mesh_.normals[a], mesh_.normals[b]));
        if (!mesh_.tangents.empty())
            mesh_.tangents.push_back(
                Vec4(middle_direction(Vec3(mesh_.tangents[a]), Vec3(mesh_.tangents[b])),
                     mesh_.tangents[a].w));
        add_middle(mesh_.uv0, a, b);
        add_middle(mesh_.uv1, a, b);
        add_middle(mesh_.colors, a, b);
        add_middle(at_, a, b);
        if (halved->second == none) halved->second = next;
        places_.push_back(halved->second);
        return next;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    void split(std::array<std::uint32_t, 3> v) {
        std::array<std::uint32_t, 3> m{};
        for (std::size_t i = 0; i < 3; ++i) m[i] = middle(v[i], v[(i + 1) % 3]);
        const auto count = std::count_if(m.begin(), m.end(), [](auto x) { return x != none; });
        if (count == 0) return add(v[0], v[1], v[2]);
        if (count == 3) {
            add(v[0], m[0], m[2]);
            add(m[0], v[1], m[1]);
            add(m[2], m[1], v[2]);
            return add(m[0], m[1], m[2]);
        }
        // Turned so that the first edge is halved, and of two the other is the second.
        while (m[0] == none || (count == 2 && m[1] == none)) {
            std::rotate(v.begin(), v.begin() + 1, v.end());
            std::rotate(m.begin(), m.begin() + 1, m.end());
        }
        if (count == 1) {
            add(v[0], m[0], v[2]);
            return add(m[0], v[1], v[2]);
        }
        add(m[0], v[1], m[1]);
        // The shorter way across what is left, a square.
        if (math::length(at_[v[0]] - at_[m[1]]) < math::length(at_[m[0]] - at_[v[2]])) {
            add(v[0], m[0], m[1]);
            return add(v[0], m[1], v[2]);
        }
        add(v[0], m[0], v[2]);
        add(m[0], m[1], v[2]);
    }

    Mesh& mesh_;
    std::vector<Vec2>& at_;
    float longest_;
    std::vector<std::uint32_t> places_;                         ///< by vertex
    std::unordered_map<std::uint64_t, std::uint32_t> halved_;   ///< by places: the middle's
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;  ///< by vertices: the middle one
};

}  // namespace

std::vector<std::uint32_t> split_edges(Mesh& mesh, std::vector<Vec2>& at, float longest,
                                       std::size_t enough) {
    Splitter splitter(mesh, at, longest);
    while (mesh.indices.size() / 3 < enough && splitter.pass()) {
    }
    return splitter.take_places();
}

double split_count(const Mesh& mesh, const std::vector<Vec2>& at, float longest) {
    double count = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<double, 3> halvings{};
        for (std::size_t e = 0; e < 3; ++e) {
            const float length =
                math::length(at[mesh.indices[i + e]] - at[mesh.indices[i + (e + 1) % 3]]);
            if (length > longest && std::isfinite(length))
                halvings[e] = std::min(std::ceil(std::log2(length / longest)), 16.0F);
        }
        // Where three edges are halved there are four triangles, then three of two, two of one.
        std::sort(halvings.begin(), halvings.end());
        count += std::exp2(2.0 * halvings[0]) * std::pow(3.0, halvings[1] - halvings[0]) *
                 std::exp2(halvings[2] - halvings[1]);
    }
    return count;
}

}  // namespace facet::scene
