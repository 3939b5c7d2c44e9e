// One question about the BRDF, and its answer in double precision: what `facet brdf` asks and
// lessons show. SPDX-License-Identifier: MIT
#pragma once

#include "brdf/half_vectors.h"
#include "tables/brdf_terms.h"

#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace facet::brdf {

/// What can be asked for. D [1/sr], G [0, 1], V = G / (4 n.v n.l), F; D V F with its compensation,
/// F0 mixed by metallic; the diffuse lobe for albedo 1 without k_d; everything. The lobes are in
/// 1/sr without the cosine. `model_specular` is the specular part of everything, whose dielectric
/// and metal are compensated apart; it has no name to ask by.
enum class QueryTerm { d, g, v, f, specular, diffuse, full, model_specular };
inline constexpr std::array<std::string_view, 7> query_terms{"D",        "G",       "V",   "F",
                                                             "specular", "diffuse", "full"};

/// A surface of base colour `base` (all channels alike), and the view.
struct QuerySurface {
    double roughness = 0.5;  ///< perceptual, not clamped
    double metallic = 0.0;
    double f0 = 0.04;  ///< of the dielectric
    double base = 1.0;
    double n_dot_v = 1.0;
    auto operator<=>(const QuerySurface&) const = default;
};

/// A and B of the split sum at n.v, the hemispherical mean, and the white diffuse albedo: what
/// brdf_view takes.
struct ExactAlbedo {
    double a = 0.0;
    double b = 0.0;
    double average = 0.0;
    double diffuse = 1.0;
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
    [[nodiscard]] const tables::BrdfChoice& choice() const { return choice_; }

private:
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

/// Shares of light from everywhere: what the specular and the diffuse lobe send back.
struct Reflectance {
    double specular = 0.0;
    double diffuse = 0.0;
    [[nodiscard]] double sum() const { return specular + diffuse; }
};
/// Directions that resolve both lobes: first those for the specular one, then those for the diffuse
/// one.
struct ReflectanceNodes {
    std::vector<LightNode> specular;
    std::vector<LightNode> diffuse;
};
[[nodiscard]] ReflectanceNodes reflectance_nodes(const tables::BrdfChoice& choice,
                                                 const QuerySurface& surface);
/// By quadrature of brdf_light itself, error below 1e-4 for roughness >= 0.03: it shares no formula
/// with the albedo that the model conserves energy by.
[[nodiscard]] Reflectance reflectance(Queries& queries, const QuerySurface& surface);

}  // namespace facet::brdf
