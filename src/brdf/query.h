// One question about the BRDF, and its answer in double precision: what `facet brdf` asks and
// lessons show. SPDX-License-Identifier: MIT
#pragma once

#include "brdf/half_vectors.h"
#include "tables/brdf_terms.h"

#include <array>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::brdf {

/// What can be asked for. D [1/sr], G [0, 1], V = G / (4 n.v n.l), F; D V F with its compensation,
/// F0 mixed by metallic; the diffuse lobe for albedo 1 without k_d; everything. The lobes are in
/// 1/sr without the cosine. The two parts of everything, whose dielectric and metal are compensated
/// apart and whose diffuse lobe has its k_d, have no names to ask by. glsl/frame/evaluate has the
/// same numbers.
enum class QueryTerm { d, g, v, f, specular, diffuse, full, model_specular, model_diffuse };
inline constexpr std::array<std::string_view, 7> query_terms{"D",        "G",       "V",   "F",
                                                             "specular", "diffuse", "full"};

/// A surface of base colour `base` (all channels alike), and the view.
struct QuerySurface {
    double roughness = 0.5;  ///< perceptual, not clamped
    double metallic = 0.0;
    double f0 = 0.04;  ///< of the dielectric
    double base = 1.0;
    double n_dot_v = 1.0;
};

/// One question: Queries::value's arguments.
struct Question {
    QueryTerm term = QueryTerm::full;
    QuerySurface surface;
    LightNode at;
};

/// A and B of the split sum at n.v, and the hemispherical mean.
struct ExactAlbedo {
    double a = 0.0;
    double b = 0.0;
    double average = 0.0;
};

/// Shares of light from everywhere: what the specular and the diffuse lobe send back.
struct Reflectance {
    double specular = 0.0;
    double diffuse = 0.0;
    [[nodiscard]] double sum() const { return specular + diffuse; }
};

/// Answers questions about one choice of terms; remembers what takes a quadrature. Lights and
/// environment are masked alike, by `choice.masking`.
class Queries {
public:
    explicit Queries(const tables::BrdfChoice& choice);

    [[nodiscard]] double value(QueryTerm term, const QuerySurface& surface, double n_dot_l,
                               double phi_deg);
    /// The same where the cosines are known.
    [[nodiscard]] double value(QueryTerm term, const QuerySurface& surface, const LightNode& at);
    [[nodiscard]] const ExactAlbedo& albedo(double n_dot_v, double roughness);
    /// reflectance() of the answers to reflectance_questions().
    [[nodiscard]] Reflectance reflectance(const QuerySurface& surface);

private:
    /// The compensation that takes the mean albedo, and the albedo at the light's direction.
    [[nodiscard]] bool adds_lobe() const {
        return choice_.multiscatter == tables::Multiscatter::kulla_conty;
    }
    [[nodiscard]] double mixed_specular(const QuerySurface& surface, const LightNode& at,
                                        double e_l);
    [[nodiscard]] double lobe(QueryTerm term, const QuerySurface& surface, const LightNode& at,
                              double e_l);
    /// A + B at n.l, interpolated: a quadrature asks for thousands of directions. Error below 1e-4.
    [[nodiscard]] double light_albedo(double n_dot_l, double roughness);

    tables::BrdfChoice choice_;
    std::map<std::pair<double, double>, ExactAlbedo> albedos_;
    std::map<double, double> averages_;  ///< by roughness
    std::map<double, std::vector<double>>
        light_albedos_;  ///< by roughness, at the fourth powers of even steps
};

/// The cosines between two directions from their own and the azimuth between them; 180 degrees is
/// the mirror side.
[[nodiscard]] LightNode cosines_of(double n_dot_v, double n_dot_l, double phi_deg);

/// What to ask about a surface so that reflectance() finds it: directions that resolve either lobe,
/// their weights among them. By quadrature of brdf_light itself, error below 1e-4 for roughness >=
/// 0.03: it shares no formula with the albedo that the model conserves energy by.
[[nodiscard]] std::vector<Question> reflectance_questions(const tables::BrdfChoice& choice,
                                                          const QuerySurface& surface);
/// From the answers to reflectance_questions(), as many and in that order.
[[nodiscard]] Reflectance reflectance(std::span<const Question> questions,
                                      std::span<const double> answers);

}  // namespace facet::brdf
