// Values between keyframes.
// SPDX-License-Identifier: MIT
#include "scene/keyframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace facet::scene {
namespace {

/// Where a time lies: between key `first` and the one after it, or at key `first`.
struct Place {
    std::size_t first = 0;
    double part = 0.0;    ///< [0, 1) of the way to the next
    double length_s = 0;  ///< of that way; 0: at the key
};

Place place_of(const Keyframes& keyframes, double time_s) {
    const std::vector<float>& times = keyframes.times_s;
    const auto after = std::upper_bound(
        times.begin(), times.end(), time_s,
        [](double wanted, float time) { return wanted < static_cast<double>(time); });
    if (after == times.begin()) return {};
    const auto first = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) return {.first = first};
    const auto begin_s = static_cast<double>(times[first]);
    const double length_s = static_cast<double>(*after) - begin_s;
    return {.first = first, .part = (time_s - begin_s) / length_s, .length_s = length_s};
}

/// A key's value, or one of the tangents beside it.
enum class Part : std::uint8_t { tangent_in, value, tangent_out };
const float* key(const Keyframes& keyframes, std::size_t index, Part part = Part::value) {
    const bool is_cubic = keyframes.interpolation == Interpolation::cubic;
    const std::size_t row = is_cubic ? index * 3 + static_cast<std::size_t>(part) : index;
    return keyframes.values.data() + row * keyframes.width;
}

/// Hermite's cubic with tangents per second (glTF 2.0, appendix C.5).
double cubic_at(const Keyframes& k, const Place& at, std::size_t i) {
    const double t = at.part;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const auto number = [&](std::size_t index, Part part) {
        return static_cast<double>(key(k, index, part)[i]);
    };
    return (2.0 * t3 - 3.0 * t2 + 1.0) * number(at.first, Part::value) +
           at.length_s * (t3 - 2.0 * t2 + t) * number(at.first, Part::tangent_out) +
           (3.0 * t2 - 2.0 * t3) * number(at.first + 1, Part::value) +
           at.length_s * (t3 - t2) * number(at.first + 1, Part::tangent_in);
}

using Quaternion = std::array<double, 4>;  // x y z w

double dot_of(const Quaternion& a, const Quaternion& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// No rotation where there is no length to scale.
Quaternion unit_of(const float* from) {
    Quaternion q;
    std::copy_n(from, 4, q.begin());
    const double size = std::sqrt(dot_of(q, q));
    if (!(size > 1e-12)) return {0, 0, 0, 1};
    for (double& x : q) x /= size;
    return q;
}

/// On the shorter of the two arcs (glTF 2.0, appendix C.4; Shoemake 1985).
Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
    const double cosine = dot_of(a, b);
    const double angle = std::acos(std::min(std::fabs(cosine), 1.0));
    constexpr double least_angle = 1e-6;  // below it the sines cancel, and the arc is straight
    const double sine = std::sin(angle);
    const double from = angle < least_angle ? 1.0 - t : std::sin((1.0 - t) * angle) / sine;
    const double to = angle < least_angle ? t : std::sin(t * angle) / sine;
    Quaternion out;
    for (std::size_t i = 0; i < 4; ++i) out[i] = from * a[i] + std::copysign(to, cosine) * b[i];
    return out;
}

}  // namespace

void sample(const Keyframes& keyframes, double time_s, std::span<float> out) {
    const Place at = place_of(keyframes, time_s);
    const float* const first = key(keyframes, at.first);
    if (at.length_s == 0.0 || keyframes.interpolation == Interpolation::step) {
        std::copy_n(first, out.size(), out.begin());
        return;
    }
    const float* const next = key(keyframes, at.first + 1);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto from = static_cast<double>(first[i]);
        const double linear = from + at.part * (static_cast<double>(next[i]) - from);
        const double value =
            keyframes.interpolation == Interpolation::cubic ? cubic_at(keyframes, at, i) : linear;
        constexpr double most = std::numeric_limits<float>::max();  // cubics may leave its range
        out[i] = static_cast<float>(std::clamp(value, -most, most));
    }
}

math::Quat sample_rotation(const Keyframes& keyframes, double time_s) {
    const Place at = place_of(keyframes, time_s);
    std::array<float, 4> value{};
    if (keyframes.interpolation == Interpolation::linear && at.length_s > 0.0) {
        const Quaternion q = slerp(unit_of(key(keyframes, at.first)),
                                   unit_of(key(keyframes, at.first + 1)), at.part);
        std::transform(q.begin(), q.end(), value.begin(),
                       [](double x) { return static_cast<float>(x); });
    } else {
        sample(keyframes, time_s, value);
    }
    const Quaternion q = unit_of(value.data());
    return {static_cast<float>(q[3]), static_cast<float>(q[0]), static_cast<float>(q[1]),
            static_cast<float>(q[2])};
}

}  // namespace facet::scene
