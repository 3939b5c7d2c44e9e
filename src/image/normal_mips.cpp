// Mip levels of normal maps.
// SPDX-License-Identifier: MIT
#include "image/normal_mips.h"

#include "base/assert.h"
#include "image/mip_taps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facet::image {
namespace {

/// Two points a side between the middles of neighbouring texels stand for all between them: Gauss's
/// rule, exact for the square of what is linear along each side. Each is nearer to one of the two
/// texels, whose share comes first.
constexpr float near_share = 0.78867513F;
constexpr float next_share = 1.0F - near_share;

/// Variance that rounding to 8 bits adds to a surface drawn between texels: two components, steps
/// of 2 / 255, squares / 12, and 4 / 9 of that is left by interpolation. It is no bump.
constexpr float rounding_variance = 2.0F * (2.0F / 255.0F) * (2.0F / 255.0F) / 12.0F * 4.0F / 9.0F;

/// x and y of one row of normals, and x^2 + y^2.
struct NormalRow {
    std::vector<float> x, y, steep2;
    explicit NormalRow(std::size_t width) : x(width), y(width), steep2(width) {}
    void clear() {
        for (std::vector<float>* row : {&x, &y, &steep2}) std::fill(row->begin(), row->end(), 0.0F);
    }
};

/// Means of those. Rows have a texel more at either end, as the picture is repeated.
struct MeanNormals {
    math::Extent size;
    std::vector<NormalRow> rows;
};

void wrap_ends(std::vector<float>& row) {
    row.front() = row[row.size() - 2];
    row.back() = row[1];
}

/// x and y of a texel. Of codes that are no unit normals only their direction is drawn.
math::Vec2 decoded(const std::uint8_t* codes) {
    constexpr int one = 255;
    const int x = 2 * codes[0] - one;
    const int y = 2 * codes[1] - one;
    const int steep2 = x * x + y * y;
    const float scale = steep2 <= one * one ? 1.0F / static_cast<float>(one)
                                            : 1.0F / std::sqrt(static_cast<float>(steep2));
    return math::Vec2(static_cast<float>(x), static_cast<float>(y)) * scale;
}

/// x and y of the map between row `y` and the row `next` to it; a texel more at either end.
void blend_rows(const Image& map, std::size_t y, std::size_t next, NormalRow& out) {
    const std::size_t width = map.size.width;
    const std::uint8_t* codes = map.as<std::uint8_t>().data();
    for (std::size_t i = 0; i < width; ++i) {
        const math::Vec2 n = near_share * decoded(codes + (y * width + i) * 4) +
                             next_share * decoded(codes + (next * width + i) * 4);
        out.x[i + 1] = n.x;
        out.y[i + 1] = n.y;
    }
    wrap_ends(out.x);
    wrap_ends(out.y);
}

/// Adds two points a texel of a row with its ends, and their squares.
void add_between(const float* row, std::size_t count, float share, float* sum, float* squares) {
    for (std::size_t i = 0; i < count; ++i) {
        const float left = near_share * row[i + 1] + next_share * row[i];
        const float right = near_share * row[i + 1] + next_share * row[i + 2];
        sum[i] += share * (left + right);
        squares[i] += share * (left * left + right * right);
    }
}

/// Adds to `sum` the normals of row `y` as they are drawn: a quarter each of those at the four
/// points around a texel's middle, times `share`. `between` is room for a row and its ends.
void add_drawn_row(const Image& map, std::size_t y, float share, NormalRow& between,
                   NormalRow& sum) {
    const std::size_t height = map.size.height;
    const float quarter = 0.25F * share;
    for (const std::size_t next : {(y + height - 1) % height, (y + 1) % height}) {
        blend_rows(map, y, next, between);
        add_between(between.x.data(), sum.x.size(), quarter, sum.x.data(), sum.steep2.data());
        add_between(between.y.data(), sum.y.size(), quarter, sum.y.data(), sum.steep2.data());
    }
}

void add_row(const NormalRow& row, float share, NormalRow& sum) {
    for (std::size_t i = 0; i < sum.x.size(); ++i) {
        sum.x[i] += share * row.x[i + 1];
        sum.y[i] += share * row.y[i + 1];
        sum.steep2[i] += share * row.steep2[i + 1];
    }
}

/// Half as wide and high. `add(y, share, sum)` adds a row of what is `from` wide and high.
template <class Add>
MeanNormals halved_normals(math::Extent from, const Add& add) {
    MeanNormals to{{std::max(1U, from.width / 2), std::max(1U, from.height / 2)}, {}};
    to.rows.assign(to.size.height, NormalRow(to.size.width + 2));
    std::vector<Taps> across;
    for (std::size_t i = 0; i < to.size.width; ++i)
        across.push_back(taps(from.width, to.size.width, i));
    NormalRow sum(from.width);
    for (std::size_t y = 0; y < to.size.height; ++y) {
        const Taps down = taps(from.height, to.size.height, y);
        sum.clear();
        for (std::size_t k = 0; k < 3; ++k)
            if (down.share[k] > 0.0F) add(down.at[k], down.share[k], sum);
        NormalRow& row = to.rows[y];
        for (const auto& [in, out] : {std::pair(&sum.x, &row.x), std::pair(&sum.y, &row.y),
                                      std::pair(&sum.steep2, &row.steep2)}) {
            for (std::size_t i = 0; i < across.size(); ++i) {
                const Taps& t = across[i];
                (*out)[i + 1] = t.share[0] * (*in)[t.at[0]] + t.share[1] * (*in)[t.at[1]] +
                                t.share[2] * (*in)[t.at[2]];
            }
            wrap_ends(*out);
        }
    }
    return to;
}

/// x^2 + y^2 of what lookups within the texels of row `y` give, in the mean. Along a side, of
/// a, b, c in three texels, what is linear between them has over the middle one the mean square
/// (a + 4 b + c)^2 / 48 + (c - a)^2 / 48 + b^2 / 4; over both sides those three times those three.
std::vector<float> seen_squares(const MeanNormals& means, std::size_t y) {
    constexpr float k = 0.14433757F;  // 1 / sqrt(48)
    constexpr math::Vec3 of_three[] = {{k, 4.0F * k, k}, {-k, 0.0F, k}, {0.0F, 0.5F, 0.0F}};
    const std::size_t height = means.rows.size();
    const NormalRow& above = means.rows[(y + height - 1) % height];
    const NormalRow& here = means.rows[y];
    const NormalRow& below = means.rows[(y + 1) % height];
    std::vector<float> squares(means.size.width, 0.0F);
    std::vector<float> row(means.size.width + 2);
    for (std::vector<float> NormalRow::*const axis : {&NormalRow::x, &NormalRow::y})
        for (const math::Vec3& down : of_three) {
            const float* const a = (above.*axis).data();
            const float* const b = (here.*axis).data();
            const float* const c = (below.*axis).data();
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] = down.x * a[i] + down.y * b[i] + down.z * c[i];
            for (std::size_t i = 0; i < squares.size(); ++i) {
                const float all = row[i] + 4.0F * row[i + 1] + row[i + 2];
                const float step = row[i + 2] - row[i];
                squares[i] += k * k * (all * all + step * step) + 0.25F * row[i + 1] * row[i + 1];
            }
        }
    return squares;
}

std::uint8_t code_of(float share) {
    return static_cast<std::uint8_t>(std::clamp(share, 0.0F, 1.0F) * 255.0F + 0.5F);
}

/// A texel from the mean of x and y, and how much of x^2 + y^2 no lookup shows.
void store(const math::Vec2& mean, float unseen, std::uint8_t* to) {
    // A spread that is as wide both ways looks narrower along the tilt, from above: x^2 + y^2 has
    // (1 + z^2) / 2 of it. Squared sines become slopes in the end: of two normals that are as steep
    // and turn away from each other it is exactly the square of their slope.
    const float z2 = 1.0F - std::min(math::dot(mean, mean), 1.0F);
    const float variance = std::max(unseen - rounding_variance, 0.0F) * 2.0F / (1.0F + z2);
    constexpr float widest = 0.5F;  // slopes of 1
    const float alpha2 = variance < widest ? variance / (1.0F - variance) : 1.0F;
    // The mean of unit vectors is as much shorter than they are as they spread.
    math::Vec2 n = mean / std::sqrt(1.0F - std::min(variance, widest));
    const float steep2 = math::dot(n, n);
    if (steep2 > 1.0F) n /= std::sqrt(steep2);
    to[0] = code_of(n.x * 0.5F + 0.5F);
    to[1] = code_of(n.y * 0.5F + 0.5F);
    to[2] = code_of(std::sqrt(1.0F - std::min(steep2, 1.0F)) * 0.5F + 0.5F);
    to[3] = code_of(std::sqrt(alpha2));
}

Image stored(const MeanNormals& means) {
    Image out(means.size, 4, Sample::u8);
    std::uint8_t* to = out.as<std::uint8_t>().data();
    for (std::size_t y = 0; y < means.rows.size(); ++y) {
        const NormalRow& row = means.rows[y];
        const std::vector<float> seen = seen_squares(means, y);
        for (std::size_t i = 0; i < seen.size(); ++i, to += 4)
            store({row.x[i + 1], row.y[i + 1]}, row.steep2[i + 1] - seen[i], to);
    }
    return out;
}

}  // namespace

std::vector<Image> build_normal_mips(Image rgba8) {
    FACET_ASSERT(rgba8.sample == Sample::u8 && rgba8.channels == 4 && rgba8.size.pixels() > 0);
    std::vector<Image> levels;
    levels.push_back(std::move(rgba8));
    const auto codes = levels.front().as<std::uint8_t>();
    for (std::size_t i = 3; i < codes.size(); i += 4) codes[i] = 0;
    if (levels.front().size.pixels() == 1) return levels;
    const Image& map = levels.front();
    NormalRow between(std::size_t{map.size.width} + 2);
    MeanNormals means = halved_normals(map.size, [&](std::size_t y, float share, NormalRow& sum) {
        add_drawn_row(map, y, share, between, sum);
    });
    levels.push_back(stored(means));
    while (means.size.pixels() > 1) {
        means = halved_normals(means.size, [&](std::size_t y, float share, NormalRow& sum) {
            add_row(means.rows[y], share, sum);
        });
        levels.push_back(stored(means));
    }
    return levels;
}

}  // namespace facet::image
