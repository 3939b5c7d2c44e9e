// Light profiles.
// SPDX-License-Identifier: MIT
#include "scene/light_profile.h"

#include "base/file.h"
#include "base/text.h"
#include "brdf/light_terms.h"
#include "scene/builtin_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace facet::scene {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{4} << 20U;
constexpr double max_candela = 1e9;

tl::unexpected<base::Error> invalid(std::size_t line, std::string what, std::string_view found,
                                    std::string remedy = "see IES LM-63-2002") {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = fmt::format("line {}", line),
                       .what = std::move(what),
                       .found = std::string(found),
                       .remedy = std::move(remedy)});
}

/// The lines before the numbers, and then the numbers, wherever lines break.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    [[nodiscard]] std::size_t line() const { return line_; }

    std::optional<std::string_view> next_line() {
        if (rest_.empty()) return std::nullopt;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view line = base::trimmed(rest_.substr(0, end));
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_;
        return line;
    }

    base::Result<double> number(std::string_view what) {
        while (words_.empty()) {
            const auto line = next_line();
            if (!line) return invalid(line_, fmt::format("ends before {}", what), "");
            words_ = *line;
            skip_gap();
        }
        const std::size_t end = std::min(words_.find_first_of(gap), words_.size());
        const std::string_view word = words_.substr(0, end);
        words_.remove_prefix(end);
        skip_gap();
        const auto value = base::parse_number(word.starts_with('+') ? word.substr(1) : word);
        if (!value) return invalid(line_, fmt::format("{} is not a number", what), word);
        return *value;
    }

    base::Result<std::size_t> count(std::string_view what) {
        const auto value = number(what);
        if (!value) return tl::unexpected(value.error());
        // Each is followed by as many numbers, of two bytes at least.
        if (*value < 1.0 || *value > static_cast<double>(words_.size() + rest_.size()) ||
            std::floor(*value) != *value)
            return invalid(line_, fmt::format("{} is not a count that the file can hold", what),
                           fmt::format("{:g}", *value));
        return static_cast<std::size_t>(*value);
    }

    base::Result<std::vector<double>> numbers(std::size_t count, std::string_view what) {
        std::vector<double> out;
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = number(what);
            if (!value) return tl::unexpected(value.error());
            out.push_back(*value);
        }
        return out;
    }

    /// Angles that rise from one of `starts` to one of `ends`.
    base::Result<std::vector<double>> angles(std::size_t count, std::string_view what,
                                             std::initializer_list<double> starts,
                                             std::initializer_list<double> ends) {
        auto out = numbers(count, what);
        if (!out) return out;
        if (std::ranges::adjacent_find(*out, std::greater_equal<>()) != out->end())
            return invalid(line_, fmt::format("{}s do not rise", what), "");
        const auto among = [](double x, std::initializer_list<double> list) {
            return std::ranges::find(list, x) != list.end();
        };
        if (!among(out->front(), starts) || !among(out->back(), ends))
            return invalid(line_, fmt::format("{}s span nothing that LM-63 knows", what),
                           fmt::format("{:g} to {:g}", out->front(), out->back()));
        return out;
    }

private:
    static constexpr std::string_view gap = " \t\r,";
    void skip_gap() {
        words_.remove_prefix(std::min(words_.find_first_not_of(gap), words_.size()));
    }
    std::string_view rest_;
    std::string_view words_;  ///< left of the line at hand
    std::size_t line_ = 0;
};

/// Candela by angle, as in the file.
struct Measured {
    std::vector<double> polar_deg, azimuth_deg;
    std::vector<double> candela;  ///< [azimuth, polar]
};

/// Where `x` is among `steps` that rise: the step below and how far on.
struct Between {
    std::size_t low = 0;
    double on = 0.0;
};
std::optional<Between> find(const std::vector<double>& steps, double x) {
    constexpr double slack_deg = 1e-6;
    if (x < steps.front() - slack_deg || x > steps.back() + slack_deg) return std::nullopt;
    const auto above = std::ranges::upper_bound(steps, x);
    const auto low =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - steps.begin() - 1, 0));
    if (low + 1 >= steps.size()) return Between{steps.size() - 1, 0.0};
    return Between{low, std::max(x - steps[low], 0.0) / (steps[low + 1] - steps[low])};
}

/// The azimuth among those measured that stands for `azimuth` in [0, 360] by symmetry (LM-63-2002,
/// 3.15).
double measured_azimuth(const Measured& m, double azimuth) {
    const double first = m.azimuth_deg.front();
    const double last = m.azimuth_deg.back();
    if (first == 90.0) {  // the halves left and right of 90 to 270 are alike
        if (azimuth < 90.0) return 180.0 - azimuth;
        return azimuth > 270.0 ? 540.0 - azimuth : azimuth;
    }
    if (last == 0.0) return 0.0;
    if (last <= 180.0 && azimuth > 180.0) azimuth = 360.0 - azimuth;
    if (last <= 90.0 && azimuth > 90.0) azimuth = 180.0 - azimuth;
    return azimuth;
}

double candela_at(const Measured& m, double polar, double azimuth) {
    const auto p = find(m.polar_deg, polar);
    const auto a = find(m.azimuth_deg, measured_azimuth(m, azimuth));
    if (!p || !a) return 0.0;
    const auto at = [&](std::size_t i, std::size_t j) {
        return m.candela[std::min(i, m.azimuth_deg.size() - 1) * m.polar_deg.size() +
                         std::min(j, m.polar_deg.size() - 1)];
    };
    return std::lerp(std::lerp(at(a->low, p->low), at(a->low, p->low + 1), p->on),
                     std::lerp(at(a->low + 1, p->low), at(a->low + 1, p->low + 1), p->on), a->on);
}

/// Lumen by candela of the brightest: the table's trapezoids over the sphere.
float flux_of(const std::vector<float>& shares) {
    constexpr double step = std::numbers::pi / (profile_rows - 1);
    double sum = 0.0;
    for (std::size_t row = 0; row < profile_rows; ++row)
        for (std::size_t column = 0; column + 1 < profile_columns; ++column)
            sum += std::sin(static_cast<double>(row) * step) *
                   static_cast<double>(shares[row * profile_columns + column]);
    return static_cast<float>(sum * step * 2.0 * std::numbers::pi / (profile_columns - 1));
}

base::Result<LightProfile> tabulated(const Measured& m, std::size_t line) {
    LightProfile out;
    std::vector<double> candela;
    for (std::size_t row = 0; row < profile_rows; ++row)
        for (std::size_t column = 0; column < profile_columns; ++column)
            candela.push_back(
                candela_at(m, static_cast<double>(row) * 180.0 / (profile_rows - 1),
                           static_cast<double>(column) * 360.0 / (profile_columns - 1)));
    const double most = *std::ranges::max_element(candela);
    if (!(most > 0.0) || most > max_candela)
        return invalid(line, "the brightest direction is not between 0 and 1e9 candela",
                       fmt::format("{:g}", most));
    for (const double c : candela) out.shares.push_back(static_cast<float>(c / most));
    out.candela = static_cast<float>(most);
    out.flux_per_candela = flux_of(out.shares);
    if (!(out.flux_per_candela > 0.0F))
        return invalid(line, "a beam too narrow for the table of a lamp", "", "a wider lamp");
    return out;
}

/// Passes the lines before the numbers, and the tilt's own numbers.
base::Status skip_head(Reader& in) {
    const auto first = in.next_line();
    if (!first) return invalid(1, "an empty file", "", "an IES LM-63 file");
    if (!first->starts_with("IES"))  // LM-63-1986 has none, and begins with text
        for (const unsigned char c : *first)
            if (c < 0x09 || c == 0x7F)
                return invalid(1, "not an IES file", *first, "an IES LM-63 file");
    auto line = first;
    while (line && !line->starts_with("TILT=")) line = in.next_line();
    if (!line) return invalid(in.line(), "no TILT= line", "", "an IES LM-63 file");
    const std::string_view tilt = base::trimmed(line->substr(5));
    if (tilt == "NONE") return {};
    if (tilt != "INCLUDE")
        return invalid(in.line(), "tilt from another file is not read", tilt,
                       "TILT=NONE or INCLUDE");
    // How the lamp dims as the luminaire is tilted: of use with one that is, and this one is not.
    if (const auto geometry = in.number("lamp geometry"); !geometry)
        return tl::unexpected(geometry.error());
    const auto pairs = in.count("number of tilts");
    if (!pairs) return tl::unexpected(pairs.error());
    if (const auto rest = in.numbers(2 * *pairs, "tilt"); !rest)
        return tl::unexpected(rest.error());
    return {};
}

}  // namespace

base::Result<LightProfile> parse_profile(std::string_view text) {
    Reader in(text);
    if (auto head = skip_head(in); !head) return tl::unexpected(head.error());
    const auto lamps = in.numbers(2, "lamps");
    if (!lamps) return tl::unexpected(lamps.error());
    const auto multiplier = in.number("candela multiplier");
    if (!multiplier) return tl::unexpected(multiplier.error());
    const auto polar_count = in.count("number of vertical angles");
    if (!polar_count) return tl::unexpected(polar_count.error());
    const auto azimuth_count = in.count("number of horizontal angles");
    if (!azimuth_count) return tl::unexpected(azimuth_count.error());
    const auto type = in.number("photometric type");
    if (!type) return tl::unexpected(type.error());
    if (*type != 1.0 && (*type == 2.0 || *type == 3.0))
        return base::fail({.code = base::ErrorCode::feature_missing,
                           .where = fmt::format("line {}", in.line()),
                           .what = "photometry of types A and B is not there yet",
                           .found = fmt::format("{:g}", *type),
                           .remedy = "a file of type C (1)"});
    if (*type != 1.0) return invalid(in.line(), "no photometric type", fmt::format("{:g}", *type));
    // Units, width, length, height; ballast factor, its use, watts.
    const auto housing = in.numbers(7, "size and ballast");
    if (!housing) return tl::unexpected(housing.error());
    Measured m;
    auto polar = in.angles(*polar_count, "vertical angle", {0.0, 90.0}, {90.0, 180.0});
    if (!polar) return tl::unexpected(polar.error());
    m.polar_deg = std::move(*polar);
    auto azimuth = in.angles(*azimuth_count, "horizontal angle", {0.0, 90.0},
                             {0.0, 90.0, 180.0, 270.0, 360.0});
    if (!azimuth) return tl::unexpected(azimuth.error());
    m.azimuth_deg = std::move(*azimuth);
    if ((m.azimuth_deg.front() == 90.0) != (m.azimuth_deg.back() == 270.0))
        return invalid(in.line(), "horizontal angles span nothing that LM-63 knows",
                       fmt::format("{:g} to {:g}", m.azimuth_deg.front(), m.azimuth_deg.back()));
    auto candela = in.numbers(*polar_count * *azimuth_count, "candela");
    if (!candela) return tl::unexpected(candela.error());
    const double factor = *multiplier * (*housing)[4] * (*housing)[5];
    for (double& c : *candela) {
        c *= factor;
        if (!(c >= 0.0)) return invalid(in.line(), "light is below zero", fmt::format("{:g}", c));
    }
    m.candela = std::move(*candela);
    return tabulated(m, in.line());
}

base::Result<LightProfile> read_profile(const std::string& name) {
    const auto path = file_of(name, builtin_lamps);
    if (!path) return tl::unexpected(path.error());
    const auto text = base::read_text_file(*path, max_file_bytes);
    if (!text) return tl::unexpected(text.error());
    auto profile = parse_profile(*text);
    if (!profile) return tl::unexpected(base::in_file(profile.error(), name));
    profile->file = name;
    return profile;
}

LightAxes profile_axes(const Light& light) {
    const LightAxes axes = axes_of(light);
    return {-axes.x, axes.y, axes.z};
}

float profile_share(const Light& light, const Vec3& direction) {
    const LightAxes axes = profile_axes(light);
    const Vec2 place = brdf::LightTerms<float>{}.profile_place(direction, axes.x, axes.y, axes.z);
    const Vec2 at = place * Vec2(profile_rows - 1, profile_columns - 1);
    const auto row = std::min(static_cast<std::size_t>(std::max(at.x, 0.0F)), profile_rows - 2);
    const auto column =
        std::min(static_cast<std::size_t>(std::max(at.y, 0.0F)), profile_columns - 2);
    const Vec2 on = at - Vec2(row, column);
    const float* const low = &light.profile->shares[row * profile_columns + column];
    const float* const high = low + profile_columns;
    return std::lerp(std::lerp(low[0], low[1], on.y), std::lerp(high[0], high[1], on.y), on.x);
}

}  // namespace facet::scene
