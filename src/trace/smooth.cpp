// Smooths sparse samples of indirect light.
// SPDX-License-Identifier: MIT
#include "trace/smooth.h"

#include "math/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec3;

/// B3 spline, which the a-trous wavelet is made of.
constexpr std::array<float, 3> spline = {3.0F / 8.0F, 1.0F / 4.0F, 1.0F / 16.0F};
/// Normals this far apart (1 - cosine of 30 degrees) share no diffuse light.
constexpr float diffuse_bend = 0.134F;
/// Standard errors that two means may differ by and still be of one surface's even light.
constexpr float errors_apart = 8.0F;

/// 1 at 0, falling to 0 at 1, without an exponential.
float falling(float x) {
    const float left = std::max(0.0F, 1.0F - x * x);
    return left * left;
}

float likeness(const GatherPoint& p, const GatherPoint& q, float steps) {
    const Vec3 way = q.position_m - p.position_m;
    const float apart =
        std::max(std::fabs(math::dot(way, p.normal)), std::fabs(math::dot(way, q.normal)));
    return falling(apart / (p.spacing_m * steps));
}

struct LobeShares {
    float diffuse = 0.0F;
    float specular = 0.0F;
};
/// How much of the light of `q` may stand in for that of `p`, by their normals and roughness.
LobeShares lobe_shares(const GatherPoint& p, const GatherPoint& q) {
    const float turned = 1.0F - math::dot(p.normal, q.normal);
    // A lobe sees much the same while the normal turns by less than its width.
    const float bend = p.alpha + 0.01F;
    const float rougher = std::fabs(q.alpha - p.alpha) / (0.5F * p.alpha + 0.02F);
    return {falling(turned / diffuse_bend),
            falling(turned / (0.5F * bend * bend)) * falling(rougher)};
}

class Smoother {
public:
    Smoother(math::Extent size, const std::vector<GatherPoint>& points,
             std::vector<GatheredMeans>& means)
        : width_(static_cast<int>(size.width)),
          height_(static_cast<int>(size.height)),
          points_(points),
          means_(means),
          next_(means.size()) {}

    void even_variances(int apart, base::ThreadPool& pool) {
        rows(pool, [&](int x, int y, std::size_t at) {
            float diffuse = 0.0F;
            float specular = 0.0F;
            float weights = 0.0F;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    const int nx = x + i * apart;
                    const int ny = y + j * apart;
                    if (nx < 0 || ny < 0 || nx >= width_ || ny >= height_) continue;
                    const std::size_t other = index(nx, ny);
                    if (!points_[other].is_surface || means_[other].has_specular <= 0.0F) continue;
                    const float w = (i == 0 ? 2.0F : 1.0F) * (j == 0 ? 2.0F : 1.0F);
                    diffuse += w * means_[other].diffuse_variance;
                    specular += w * means_[other].specular_variance;
                    weights += w;
                }
            next_[at] = means_[at];
            if (weights <= 0.0F) return;
            next_[at].diffuse_variance = diffuse / weights;
            next_[at].specular_variance = specular / weights;
        });
        std::swap(means_, next_);
    }

    void pass(int step, base::ThreadPool& pool) {
        rows(pool, [&](int x, int y, std::size_t at) { next_[at] = filtered(x, y, at, step); });
        std::swap(means_, next_);
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    template <class Of>
    void rows(base::ThreadPool& pool, const Of& of) {
        pool.parallel_for(static_cast<std::size_t>(height_), [&](std::size_t row) {
            const int y = static_cast<int>(row);
            for (int x = 0; x < width_; ++x)
                if (const std::size_t at = index(x, y); points_[at].is_surface) of(x, y, at);
        });
    }

    struct Sums {
        GatheredMeans mean;
        float diffuse = 0.0F;  ///< of weights
        float specular = 0.0F;

        void add_diffuse(const GatheredMeans& m, float w) {
            mean.sky += m.sky * w;
            mean.open += m.open * w;
            mean.rest += m.rest * w;
            mean.diffuse_variance += m.diffuse_variance * w * w;
            diffuse += w;
        }
        void add_specular(const GatheredMeans& m, float w) {
            mean.specular += m.specular * w;
            mean.specular_sky += m.specular_sky * w;
            mean.specular_open += m.specular_open * w;
            mean.specular_known += m.specular_known * w;
            mean.specular_variance += m.specular_variance * w * w;
            specular += w;
        }
        void finish(const GatheredMeans& own) {
            const float d = diffuse > 0.0F ? 1.0F / diffuse : 0.0F;
            mean.sky *= d;
            mean.open *= d;
            mean.rest *= d;
            mean.diffuse_variance *= d * d;
            mean.has_diffuse = diffuse > 0.0F ? 1.0F : 0.0F;
            const float s = specular > 0.0F ? 1.0F / specular : 0.0F;
            mean.specular *= s;
            mean.specular_sky *= s;
            mean.specular_open *= s;
            mean.specular_known *= s;
            mean.specular_variance *= s * s;
            mean.has_specular = specular > 0.0F ? 1.0F : 0.0F;
            if (diffuse <= 0.0F) mean.diffuse_variance = own.diffuse_variance;
            if (specular <= 0.0F) mean.specular_variance = own.specular_variance;
        }
    };

    [[nodiscard]] GatheredMeans filtered(int x, int y, std::size_t at, int step) const {
        const GatherPoint& point = points_[at];
        const GatheredMeans& own = means_[at];
        const float own_diffuse = math::luminance(own.sky + own.rest);
        const float own_specular = math::luminance(own.specular);
        // Few samples may agree by chance: the doubt of both counts.
        const auto even = [](float difference, float variance, float other) {
            return falling(difference /
                           (errors_apart * std::sqrt(0.5F * (variance + other)) + 1e-20F));
        };
        Sums sums;
        constexpr float center = spline[0] * spline[0];
        if (own.has_diffuse > 0.0F) sums.add_diffuse(own, center);
        if (own.has_specular > 0.0F) sums.add_specular(own, center);
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) {
                const int nx = x + i * step;
                const int ny = y + j * step;
                if ((i == 0 && j == 0) || nx < 0 || ny < 0 || nx >= width_ || ny >= height_)
                    continue;
                const std::size_t other = index(nx, ny);
                const GatherPoint& q = points_[other];
                if (!q.is_surface) continue;
                const float place = spline[static_cast<std::size_t>(std::abs(i))] *
                                    spline[static_cast<std::size_t>(std::abs(j))] *
                                    likeness(point, q, static_cast<float>(step));
                if (place <= 0.0F) continue;
                const GatheredMeans& m = means_[other];
                const LobeShares share = lobe_shares(point, q);
                if (m.has_diffuse > 0.0F) {
                    const float l = math::luminance(m.sky + m.rest);
                    const float w =
                        place * share.diffuse *
                        (own.has_diffuse > 0.0F
                             ? even(l - own_diffuse, own.diffuse_variance, m.diffuse_variance)
                             : 1.0F);
                    sums.add_diffuse(m, w);
                }
                if (m.has_specular <= 0.0F) continue;
                const float l = math::luminance(m.specular);
                const float w =
                    place * share.specular *
                    (own.has_specular > 0.0F
                         ? even(l - own_specular, own.specular_variance, m.specular_variance)
                         : 1.0F);
                sums.add_specular(m, w);
            }
        sums.finish(own);
        return sums.mean;
    }

    int width_;
    int height_;
    const std::vector<GatherPoint>& points_;
    std::vector<GatheredMeans>& means_;
    std::vector<GatheredMeans> next_;
};

}  // namespace

std::vector<Helpers> helpers_of(math::Extent size, const std::vector<GatherPoint>& points,
                                base::ThreadPool& pool) {
    std::vector<Helpers> out(points.size());
    const auto width = static_cast<std::ptrdiff_t>(size.width);
    const auto height = static_cast<std::ptrdiff_t>(size.height);
    pool.parallel_for(size.height, [&](std::size_t row) {
        const auto y = static_cast<std::ptrdiff_t>(row);
        for (std::ptrdiff_t x = 0; x < width; ++x) {
            const GatherPoint& p = points[static_cast<std::size_t>(y * width + x)];
            if (!p.is_surface) continue;
            Helpers& helpers = out[static_cast<std::size_t>(y * width + x)];
            for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(y - 1, 0);
                 j <= std::min(y + 1, height - 1); ++j)
                for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(x - 1, 0);
                     i <= std::min(x + 1, width - 1); ++i) {
                    const GatherPoint& q = points[static_cast<std::size_t>(j * width + i)];
                    if ((i == x && j == y) || !q.is_surface) continue;
                    const float place = likeness(p, q, 1.0F);
                    const LobeShares share = lobe_shares(p, q);
                    helpers.diffuse += place * share.diffuse;
                    helpers.specular += place * share.specular;
                }
        }
    });
    return out;
}

void even_variances(math::Extent size, const std::vector<GatherPoint>& points,
                    std::vector<GatheredMeans>& means, std::uint32_t apart,
                    base::ThreadPool& pool) {
    Smoother(size, points, means).even_variances(static_cast<int>(apart), pool);
}

void smooth(math::Extent size, const std::vector<GatherPoint>& points,
            std::vector<GatheredMeans>& means, std::uint32_t passes, base::ThreadPool& pool) {
    Smoother smoother(size, points, means);
    for (std::uint32_t i = 0; i < passes; ++i) smoother.pass(1 << i, pool);
}

}  // namespace facet::trace
