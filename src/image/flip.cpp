// FLIP (Andersson et al. 2020, 2021): filtered colour difference, amplified where edges and points
// differ. SPDX-License-Identifier: MIT
#include "image/flip.h"

#include "math/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace facet::image {
namespace {

constexpr float pixels_per_degree = 67.0206F;
constexpr float q_c = 0.7F, p_c = 0.4F, p_t = 0.95F;  // Andersson et al. 2020, 4.1.3
constexpr float q_f = 0.5F;                           // 4.2
constexpr float feature_width_deg = 0.082F;           // 4.2

/// One number per pixel, [height, width].
using Plane = std::vector<float>;
using Planes = std::array<Plane, 3>;
using Triple = std::array<float, 3>;
/// Weights of offsets -n to n.
using Kernel = std::vector<float>;

constexpr Triple white{0.950428F, 1.0F, 1.088900F};  // D65, of the matrix below

Triple xyz_from_rgb(const Triple& c) {
    const math::Vec3 xyz = math::xyz_from_rec709({c[0], c[1], c[2]});
    return {xyz.x, xyz.y, xyz.z};
}
Triple rgb_from_xyz(const Triple& c) {
    const math::Vec3 rgb = math::rec709_from_xyz({c[0], c[1], c[2]});
    return {rgb.x, rgb.y, rgb.z};
}
/// Linearised CIELAB, YCxCz (Andersson et al. 2020, 4.1.1).
Triple ycxcz_from_xyz(const Triple& c) {
    const float x = c[0] / white[0], y = c[1] / white[1], z = c[2] / white[2];
    return {116.0F * y - 16.0F, 500.0F * (x - y), 200.0F * (y - z)};
}
Triple xyz_from_ycxcz(const Triple& c) {
    const float y = (c[0] + 16.0F) / 116.0F;
    return {(c[1] / 500.0F + y) * white[0], y * white[1], (y - c[2] / 200.0F) * white[2]};
}
/// CIELAB (CIE 15:2004, 8.2.1) with a and b scaled by 0.01 L, the Hunt effect (Andersson et al.
/// 2020, 4.1.2).
Triple hunt_lab(const Triple& rgb) {
    const Triple xyz = xyz_from_rgb(rgb);
    Triple f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float t = xyz[i] / white[i];
        constexpr float delta = 6.0F / 29.0F;
        f[i] = t > delta * delta * delta ? std::cbrt(t) : t / (3.0F * delta * delta) + 4.0F / 29.0F;
    }
    const float l = 116.0F * f[1] - 16.0F;
    return {l, 0.01F * l * 500.0F * (f[0] - f[1]), 0.01F * l * 200.0F * (f[1] - f[2])};
}
/// Abasi et al. 2020: city block in lightness, Euclid in chroma.
float hyab(const Triple& a, const Triple& b) {
    return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Kernel gaussian(float sigma_px, std::size_t radius) {
    Kernel out(2 * radius + 1);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float x = static_cast<float>(i) - static_cast<float>(radius);
        out[i] = std::exp(-x * x / (2.0F * sigma_px * sigma_px));
    }
    return out;
}
float sum_of(const Kernel& kernel) {
    float sum = 0.0F;
    for (const float weight : kernel) sum += weight;
    return sum;
}

/// Separable filter, the border pixel repeated outwards.
Plane filtered(const Plane& in, math::Extent size, const Kernel& across, const Kernel& down) {
    const std::size_t width = size.width, height = size.height;
    const std::size_t radius = across.size() / 2;
    Plane half(in.size());
    std::vector<float> row(width + 2 * radius);
    for (std::size_t y = 0; y < height; ++y) {
        const float* from = in.data() + y * width;
        std::copy_n(from, width, row.data() + radius);
        std::fill_n(row.data(), radius, from[0]);
        std::fill_n(row.data() + radius + width, radius, from[width - 1]);
        float* to = half.data() + y * width;
        std::fill_n(to, width, 0.0F);
        for (std::size_t k = 0; k < across.size(); ++k)
            for (std::size_t x = 0; x < width; ++x) to[x] += across[k] * row[x + k];
    }
    Plane out(in.size());
    for (std::size_t y = 0; y < height; ++y) {
        float* to = out.data() + y * width;
        for (std::size_t k = 0; k < down.size(); ++k) {
            const std::size_t at = std::min(y + k < radius ? 0 : y + k - radius, height - 1);
            const float* from = half.data() + at * width;
            for (std::size_t x = 0; x < width; ++x) to[x] += down[k] * from[x];
        }
    }
    return out;
}

/// Contrast sensitivity: a1 sqrt(pi/b1) exp(-pi^2 x^2 / b1) + the same of a2, b2, x in degrees
/// (Andersson et al. 2020, Table 1 and 4.1.1), of sum 1.
struct Sensitivity {
    float a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{
    {{1.0F, 0.0047F, 0.0F, 1e-5F}, {1.0F, 0.0053F, 0.0F, 1e-5F}, {34.1F, 0.04F, 13.5F, 0.025F}}};

Plane seen(const Plane& in, math::Extent size, const Sensitivity& s) {
    // One radius for all, 3 deviations of the widest.
    const float sigma_deg = std::sqrt(0.04F / (2.0F * math::pi * math::pi));
    const auto radius = static_cast<std::size_t>(std::ceil(3.0F * sigma_deg * pixels_per_degree));
    Plane out(in.size());
    float total = 0.0F;
    for (const auto& [a, b] : {std::pair{s.a1, s.b1}, std::pair{s.a2, s.b2}}) {
        if (a == 0.0F) continue;
        const float sigma_px = std::sqrt(b / (2.0F * math::pi * math::pi)) * pixels_per_degree;
        const Kernel kernel = gaussian(sigma_px, radius);
        const float weight = a * std::sqrt(math::pi / b);
        const Plane part = filtered(in, size, kernel, kernel);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
        total += weight * sum_of(kernel) * sum_of(kernel);
    }
    for (float& value : out) value /= total;
    return out;
}

Planes to_ycxcz(const Image& image) {
    const auto from = image.as<float>();
    Planes out;
    for (Plane& plane : out) plane.resize(from.size() / 4);
    for (std::size_t i = 0; i < out[0].size(); ++i) {
        Triple rgb{};
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = math::linear_from_srgb(from[i * 4 + c]);
        const Triple opponent = ycxcz_from_xyz(xyz_from_rgb(rgb));
        for (std::size_t c = 0; c < 3; ++c) out[c][i] = opponent[c];
    }
    return out;
}

/// Colours as seen from the distance, ready for hyab().
std::vector<Triple> seen_colors(const Planes& ycxcz, math::Extent size) {
    Planes blurred;
    for (std::size_t c = 0; c < 3; ++c) blurred[c] = seen(ycxcz[c], size, sensitivities[c]);
    std::vector<Triple> out(blurred[0].size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        Triple rgb = rgb_from_xyz(xyz_from_ycxcz({blurred[0][i], blurred[1][i], blurred[2][i]}));
        for (float& channel : rgb) channel = std::clamp(channel, 0.0F, 1.0F);
        out[i] = hunt_lab(rgb);
    }
    return out;
}

/// Positive weights to sum 1, negative ones to -1 (of the kernel in two dimensions).
Kernel balanced(Kernel kernel, float other_sum) {
    float positive = 0.0F, negative = 0.0F;
    for (const float w : kernel) (w > 0.0F ? positive : negative) += w;
    for (float& w : kernel) w /= (w > 0.0F ? positive : -negative) * other_sum;
    return kernel;
}

/// Strength of edges (first derivative) or points (second) in normalised luminance (Andersson et
/// al. 2020, 4.2).
Plane features(const Plane& y, math::Extent size, int derivative) {
    const float sigma = 0.5F * feature_width_deg * pixels_per_degree;
    const auto radius = static_cast<std::size_t>(std::ceil(3.0F * sigma));
    const Kernel smooth = gaussian(sigma, radius);
    Kernel slope = smooth;
    for (std::size_t i = 0; i < slope.size(); ++i) {
        const float x = static_cast<float>(i) - static_cast<float>(radius);
        slope[i] *= derivative == 1 ? -x : x * x / (sigma * sigma) - 1.0F;
    }
    slope = balanced(slope, sum_of(smooth));
    Plane out = filtered(y, size, slope, smooth);
    const Plane vertical = filtered(y, size, smooth, slope);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(out[i], vertical[i]);
    return out;
}

/// Large colour errors are squeezed into [p_t, 1] (Andersson et al. 2020, 4.1.3).
float color_error(float distance, float largest) {
    const float powered = std::pow(distance, q_c);
    const float knee = p_c * largest;
    if (powered < knee) return p_t / knee * powered;
    return p_t + (powered - knee) / (largest - knee) * (1.0F - p_t);
}

/// ACES' curve by Narkowicz (2016) with its exposure bias of 0.6 taken out, as HDR-FLIP has it
/// (Andersson et al. 2021, Section 3.1): (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5).
constexpr float k0 = 0.6F * 0.6F * 2.51F, k1 = 0.6F * 0.03F;
constexpr float k3 = 0.6F * 0.6F * 2.43F, k4 = 0.6F * 0.59F, k5 = 0.14F;
constexpr float shown_at = 0.85F;  // Section 3.2

float tone_mapped(float x) {
    constexpr float large = 1e6F;  // the curve has long reached its end, and x^2 is finite
    const float v = std::min(x, large);
    return std::clamp((k0 * v * v + k1 * v) / (k3 * v * v + k4 * v + k5), 0.0F, 1.0F);
}
/// The value that the curve maps to shown_at.
float unmapped() {
    const float half = 0.5F * (k1 - k4 * shown_at) / (k0 - k3 * shown_at);
    const float end = -k5 * shown_at / (k0 - k3 * shown_at);
    return -half + std::sqrt(half * half - end);
}

Image exposed(const Image& linear, float stops) {
    Image out(linear.size, 4, Sample::f32);
    const float factor = std::exp2(stops);
    const auto from = linear.as<float>();
    const auto to = out.as<float>();
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = i % 4 == 3 ? from[i] : math::srgb_from_linear(tone_mapped(from[i] * factor));
    return out;
}

}  // namespace

Image flip_map(const Image& a, const Image& b) {
    Planes of_a = to_ycxcz(a);
    Planes of_b = to_ycxcz(b);
    const auto colors_a = seen_colors(of_a, a.size);
    const auto colors_b = seen_colors(of_b, b.size);
    for (Plane* plane : {&of_a[0], &of_b[0]})
        for (float& y : *plane) y = (y + 16.0F) / 116.0F;
    const Plane edges_a = features(of_a[0], a.size, 1), edges_b = features(of_b[0], b.size, 1);
    const Plane points_a = features(of_a[0], a.size, 2), points_b = features(of_b[0], b.size, 2);
    const float largest =
        std::pow(hyab(hunt_lab({0.0F, 1.0F, 0.0F}), hunt_lab({0.0F, 0.0F, 1.0F})), q_c);
    Image map(a.size, 1, Sample::f32);
    const auto errors = map.as<float>();
    for (std::size_t i = 0; i < colors_a.size(); ++i) {
        const float color = color_error(hyab(colors_a[i], colors_b[i]), largest);
        const float feature =
            std::max(std::fabs(edges_a[i] - edges_b[i]), std::fabs(points_a[i] - points_b[i]));
        const float amplify = std::pow(std::clamp(feature / std::sqrt(2.0F), 0.0F, 1.0F), q_f);
        errors[i] = std::pow(color, 1.0F - amplify);
    }
    return map;
}

std::vector<float> flip_exposures(const Image& reference) {
    std::vector<float> luminances;
    const auto values = reference.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4)
        luminances.push_back(math::luminance({values[i], values[i + 1], values[i + 2]}));
    if (luminances.empty()) return {};
    const float brightest = *std::max_element(luminances.begin(), luminances.end());
    if (!(brightest > 0.0F)) return {};
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    // A picture that is half black has no median to expose for: sixteen stops are all that a screen
    // tells apart.
    const float median = std::max(*middle, brightest * std::exp2(-16.0F));
    const float start = std::log2(unmapped() / brightest);
    const float stop = std::log2(unmapped() / median);
    const auto count = static_cast<std::size_t>(std::max(2.0F, std::ceil(stop - start)));
    std::vector<float> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(start +
                      (stop - start) * static_cast<float>(i) / static_cast<float>(count - 1));
    return out;
}

Image hdr_flip_map(const Image& reference, const Image& test) {
    Image largest(reference.size, 1, Sample::f32);
    const auto out = largest.as<float>();
    const std::vector<float> exposures = flip_exposures(reference);
    for (const float stops : exposures) {
        const Image map = flip_map(exposed(reference, stops), exposed(test, stops));
        const auto errors = map.as<float>();
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::max(out[i], errors[i]);
    }
    if (exposures.empty()) {
        const auto values = test.as<float>();
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = values[i * 4] + values[i * 4 + 1] + values[i * 4 + 2] > 0.0F ? 1.0F : 0.0F;
    }
    return largest;
}

double mean_of(const Image& map) {
    double sum = 0.0;
    for (const float value : map.as<float>()) sum += static_cast<double>(value);
    return map.bytes.empty() ? 0.0 : sum / static_cast<double>(map.as<float>().size());
}

}  // namespace facet::image
