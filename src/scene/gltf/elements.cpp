// Elements of a sound accessor, decoded.
// SPDX-License-Identifier: MIT
#include "scene/gltf/elements.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace facet::scene::gltf {
namespace {

template <class Out, class In>
Out decode(In value, bool is_normalized) {
    if constexpr (std::is_same_v<Out, float> && std::is_integral_v<In>) {
        constexpr auto most = static_cast<float>(std::numeric_limits<In>::max());
        // The signed case maps -128 and -127 both to -1 (glTF 2.0, section 3.11).
        return is_normalized ? std::max(static_cast<float>(value) / most, -1.0F)
                             : static_cast<float>(value);
    } else {
        return static_cast<Out>(value);
    }
}

/// One element at `from` into `to`.
template <class In, class Out>
void read_element(const Accessor& a, const std::byte* from, Out* to) {
    for (std::size_t c = 0; c < a.components; ++c) {
        const std::size_t at =
            a.rows == 0 ? c * sizeof(In) : c / a.rows * a.column_stride + c % a.rows * sizeof(In);
        In value;
        std::memcpy(&value, from + at, sizeof(In));
        to[c] = decode<Out>(value, a.is_normalized);
    }
}

template <class In, class Out>
std::vector<Out> read_all(const Accessor& a) {
    std::vector<Out> out(a.count * a.components);
    if (!a.bytes.empty())
        for (std::size_t i = 0; i < a.count; ++i)
            read_element<In>(a, a.bytes.data() + i * a.stride, out.data() + i * a.components);
    const std::size_t packed =
        a.rows > 0 ? a.column_stride * (a.components / a.rows) : a.components * sizeof(In);
    for (std::size_t i = 0; i < a.sparse_indices.size(); ++i)
        read_element<In>(a, a.sparse_values.data() + i * packed,
                         out.data() + a.sparse_indices[i] * a.components);
    return out;
}

template <class Out>
std::vector<Out> read_as(const Accessor& a) {
    FACET_ASSERT(a.is_sound);
    switch (a.component) {
        case Component::i8:
            return read_all<std::int8_t, Out>(a);
        case Component::u8:
            return read_all<std::uint8_t, Out>(a);
        case Component::i16:
            return read_all<std::int16_t, Out>(a);
        case Component::u16:
            return read_all<std::uint16_t, Out>(a);
        case Component::u32:
            return read_all<std::uint32_t, Out>(a);
        case Component::f32:
            return read_all<float, Out>(a);
    }
    return {};
}

}  // namespace

std::vector<float> read_floats(const Accessor& a) { return read_as<float>(a); }

base::Status check_finite(std::span<const float> values, const std::string& where) {
    const auto bad = std::find_if(values.begin(), values.end(),
                                  [](float value) { return !std::isfinite(value); });
    if (bad == values.end()) return {};
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = where,
                       .what = "value is NaN or infinite",
                       .found = "number " + std::to_string(bad - values.begin()),
                       .remedy = "export the model again"});
}

std::vector<double> read_raw(const Accessor& a) { return read_as<double>(a); }

std::vector<std::uint32_t> read_unsigned(const Accessor& a) {
    FACET_ASSERT(a.is_sound);
    switch (a.component) {
        case Component::u8:
            return read_all<std::uint8_t, std::uint32_t>(a);
        case Component::u16:
            return read_all<std::uint16_t, std::uint32_t>(a);
        case Component::u32:
            return read_all<std::uint32_t, std::uint32_t>(a);
        case Component::i8:
        case Component::i16:
        case Component::f32:
            break;
    }
    return {};
}

}  // namespace facet::scene::gltf
