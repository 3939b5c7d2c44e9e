// Numbers about light on a surface, as lessons ask for them.
// SPDX-License-Identifier: MIT
#include "teach/ask.h"

#include "base/text.h"
#include "brdf/camera_terms.h"
#include "brdf/choice.h"
#include "brdf/metal_spectra.h"
#include "brdf/presets.h"
#include "brdf/sheen.h"
#include "math/blackbody.h"
#include "scene/lens.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace facet::teach {
namespace {

using brdf::QueryTerm;

constexpr double degree = 3.14159265358979323846 / 180.0;
/// Below this the model's cosines divide by nothing.
constexpr double smallest_cosine = 1e-6;

brdf::QuerySurface surface_of(const Ask& ask) {
    return {ask.roughness, ask.metallic, ask.f0, ask.base, std::max(ask.n_dot_v, smallest_cosine)};
}

brdf::LightNode node_of(const Ask& ask) {
    brdf::LightNode node =
        brdf::cosines_of(std::max(ask.n_dot_v, smallest_cosine), ask.n_dot_l, ask.phi_deg);
    if (ask.n_dot_h) node.n_dot_h = *ask.n_dot_h;
    if (ask.v_dot_h) node.v_dot_h = *ask.v_dot_h;
    return node;
}

template <QueryTerm term>
double term_of(Answers& answers, const Ask& ask) {
    return answers.queries(ask.choice).value(term, surface_of(ask), node_of(ask));
}

brdf::Reflectance reflectance_of(Answers& answers, const Ask& ask) {
    return answers.queries(ask.choice).reflectance(surface_of(ask));
}

double albedo_of(Answers& answers, const Ask& ask) { return reflectance_of(answers, ask).specular; }
double entered_of(Answers& answers, const Ask& ask) { return reflectance_of(answers, ask).diffuse; }
double furnace_of(Answers& answers, const Ask& ask) { return reflectance_of(answers, ask).sum(); }
double residual_of(Answers& answers, const Ask& ask) { return furnace_of(answers, ask) - 1.0; }
double absorbed_of(Answers& answers, const Ask& ask) { return 1.0 - furnace_of(answers, ask); }
double split_a_of(Answers& answers, const Ask& ask) {
    return answers.queries(ask.choice).albedo(ask.n_dot_v, ask.roughness).a;
}
double split_b_of(Answers& answers, const Ask& ask) {
    return answers.queries(ask.choice).albedo(ask.n_dot_v, ask.roughness).b;
}
double average_of(Answers& answers, const Ask& ask) {
    return answers.queries(ask.choice).albedo(ask.n_dot_v, ask.roughness).average;
}

double dielectric_of(Answers&, const Ask& ask) {
    return brdf::Terms<double>{}.f_dielectric(ask.v_dot_h.value_or(1.0), ask.ior);
}

double metal_of(Answers&, const Ask& ask) {
    std::size_t metal = 0;
    for (std::size_t i = 0; i < brdf::metal_spectra.size(); ++i)
        if (brdf::metal_spectra[i].name == ask.metal) metal = i;
    const math::Vec3 color = brdf::metal_reflectance(metal, ask.v_dot_h.value_or(1.0));
    return static_cast<double>(color[static_cast<int>(ask.channel)]);
}

double blackbody_of(Answers&, const Ask& ask) {
    const math::Vec3 color = math::blackbody_color(static_cast<float>(ask.kelvin));
    return static_cast<double>(color[static_cast<int>(ask.channel)]);
}

/// Phong's lobe around the mirrored view. A quarter of Blinn's exponent makes it as wide, and as
/// the mirrored view turns twice as far as h, four times its density is as high.
double phong_of(Answers&, const Ask& ask) {
    const double sine_v = std::sqrt(std::max(0.0, 1.0 - ask.n_dot_v * ask.n_dot_v));
    const double sine_l = std::sqrt(std::max(0.0, 1.0 - ask.n_dot_l * ask.n_dot_l));
    const double v_dot_l =
        ask.n_dot_v * ask.n_dot_l + sine_v * sine_l * std::cos(ask.phi_deg * degree);
    const double r_dot_l = std::max(0.0, 2.0 * ask.n_dot_v * ask.n_dot_l - v_dot_l);
    const double alpha = std::max(ask.roughness * ask.roughness, 1e-3);
    const double exponent = (2.0 / (alpha * alpha) - 2.0) / 4.0;
    return 4.0 * brdf::Terms<double>{}.phong(r_dot_l, exponent);
}

/// (1/N) sum f(l) (n.l) / p(l), light of radiance 1 from everywhere; the same number for the same
/// seed. Source: Pharr, Jakob & Humphreys 2023, Section 2.1.3.
double estimate(Answers& answers, const Ask& ask, std::uint32_t seed) {
    brdf::QuerySurface surface = surface_of(ask);
    surface.roughness = std::max(surface.roughness, 1e-3);
    surface.n_dot_v = std::max(surface.n_dot_v, 1e-3);
    brdf::Draws draws(ask.choice, surface, answers.queries(ask.choice), seed);
    const auto samples = static_cast<std::uint32_t>(ask.samples);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < samples; ++i) sum += draws.next(ask.sampler).weight();
    return sum / samples;
}
double estimate_of(Answers& answers, const Ask& ask) { return estimate(answers, ask, 1); }

/// Root mean square error of many estimates over their true value.
double error_of(Answers& answers, const Ask& ask) {
    constexpr std::uint32_t repetitions = 96;
    const double truth = furnace_of(answers, ask);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < repetitions; ++i) {
        const double off = estimate(answers, ask, i + 1) - truth;
        sum += off * off;
    }
    return std::sqrt(sum / repetitions) / std::max(truth, 1e-12);
}

double ev_of(Answers&, const Ask& ask) {
    return scene::exposure_value(ask.f_number, ask.shutter_s, ask.iso);
}

double vignetting_of(Answers&, const Ask& ask) {
    const double tangent =
        std::sqrt(std::max(0.0, 1.0 - ask.n_dot_v * ask.n_dot_v)) / std::max(ask.n_dot_v, 1e-6);
    return brdf::CameraTerms<double>{}.natural_vignetting({tangent, 0.0});
}

/// Thin lens: (f / N) f |s - s_f| / (s (s_f - f)), all in millimetres.
double blur_of(Answers&, const Ask& ask) {
    constexpr double mm_per_m = 1000.0;
    const double s = std::max(ask.distance_m * mm_per_m, 1e-3);
    const double focus = std::max(ask.focus_m * mm_per_m, ask.focal_mm * 1.001);
    return ask.focal_mm * ask.focal_mm / ask.f_number * std::fabs(s - focus) /
           (s * (focus - ask.focal_mm));
}

/// Of a ball straight above that fills a cone of that half angle: pi sin^2 (Lambert 1760).
double ball_of(Answers&, const Ask& ask) {
    return std::numbers::pi * (1.0 - ask.n_dot_v * ask.n_dot_v);
}

/// Of fibres of colour 1, as layers of sheen look it up.
double sheen_of(Answers&, const Ask& ask) {
    const float e =
        brdf::sheen_albedo(static_cast<float>(ask.n_dot_v), static_cast<float>(ask.roughness));
    return std::min(double{e}, 1.0);
}

struct Kind {
    AskName name;
    double (*answer)(Answers&, const Ask&);
    std::string_view table = {};  ///< the action of `facet brdf` that prints it
};
constexpr Kind kinds[] = {
    {{"D", "normal distribution, 1/sr"}, term_of<QueryTerm::d>, "eval"},
    {{"G", "masking and shadowing"}, term_of<QueryTerm::g>, "eval"},
    {{"V", "G / (4 n.v n.l)"}, term_of<QueryTerm::v>, "eval"},
    {{"F", "Fresnel reflectance, F0 mixed by metallic"}, term_of<QueryTerm::f>, "eval"},
    {{"specular", "D V F with its compensation, 1/sr"}, term_of<QueryTerm::specular>, "eval"},
    {{"diffuse", "the diffuse lobe for albedo 1 without k_d, 1/sr"},
     term_of<QueryTerm::diffuse>,
     "eval"},
    {{"full", "the whole BRDF, 1/sr"}, term_of<QueryTerm::full>, "eval"},
    {{"model_specular", "the specular part of full"}, term_of<QueryTerm::model_specular>},
    {{"model_diffuse", "the diffuse part of full"}, term_of<QueryTerm::model_diffuse>},
    {{"albedo", "share of the light from everywhere that the specular lobe reflects"},
     albedo_of,
     "albedo"},
    {{"transmitted", "share that enters and comes back as diffuse light"}, entered_of, "albedo"},
    {{"absorbed", "share that does not come back"}, absorbed_of, "albedo"},
    {{"furnace", "share that comes back in all"}, furnace_of, "furnace"},
    {{"residual", "furnace - 1"}, residual_of, "furnace"},
    {{"sheen", "share that fibres of colour 1 reflect, of that roughness"}, sheen_of},
    {{"split_a", "A of the split sum"}, split_a_of},
    {{"split_b", "B of the split sum"}, split_b_of},
    {{"average", "mean of A + B over the hemisphere"}, average_of},
    {{"dielectric", "exact Fresnel reflectance for an index, at v.h"}, dielectric_of},
    {{"metal", "exact reflectance of a metal in a channel, at v.h"}, metal_of},
    {{"blackbody", "linear Rec.709 of a black body of luminance 1, in a channel"}, blackbody_of},
    {{"phong", "Phong's lobe, as wide and high as D seen from above, 1/sr"}, phong_of},
    {{"estimate", "Monte Carlo estimate of furnace"}, estimate_of},
    {{"error", "its relative error, root mean square"}, error_of},
    {{"ev", "exposure value at ISO 100 of f_number, shutter, iso"}, ev_of},
    {{"vignetting", "natural: cos^4 of the angle theta_v to the axis"}, vignetting_of},
    {{"blur", "circle of confusion in mm of focal_mm, f_number, focus_m at distance_m"}, blur_of},
    {{"ball", "lux of a ball of 1 nit above that fills a cone of half angle theta_v"}, ball_of},
};

const Kind* kind_of(std::string_view name) {
    const auto* found =
        std::ranges::find_if(kinds, [&](const Kind& kind) { return kind.name.name == name; });
    return found == std::end(kinds) ? nullptr : found;
}

/// A number of Ask by the name that lesson.json has for it.
struct Variable {
    std::string_view name;
    tables::Range range;
    void (*set)(Ask&, double);
};
constexpr Variable variables[] = {
    {"roughness", {0, 1}, [](Ask& a, double x) { a.roughness = x; }},
    {"metallic", {0, 1}, [](Ask& a, double x) { a.metallic = x; }},
    {"f0", {0, 1}, [](Ask& a, double x) { a.f0 = x; }},
    {"base", {0, 1}, [](Ask& a, double x) { a.base = x; }},
    {"n_dot_v", {0, 1}, [](Ask& a, double x) { a.n_dot_v = x; }},
    {"n_dot_l", {0, 1}, [](Ask& a, double x) { a.n_dot_l = x; }},
    {"n_dot_h", {0, 1}, [](Ask& a, double x) { a.n_dot_h = x; }},
    {"v_dot_h", {0, 1}, [](Ask& a, double x) { a.v_dot_h = x; }},
    {"phi", {-360, 360}, [](Ask& a, double x) { a.phi_deg = x; }},
    {"theta_v", {0, 90}, [](Ask& a, double x) { a.n_dot_v = std::cos(x * degree); }},
    // Left of the normal, where the viewer is, angles are negative.
    {"theta_l",
     {-90, 90},
     [](Ask& a, double x) {
         a.n_dot_l = std::cos(x * degree);
         a.phi_deg = x < 0.0 ? 0.0 : 180.0;
     }},
    {"theta_h", {0, 90}, [](Ask& a, double x) { a.n_dot_h = std::cos(x * degree); }},
    {"theta_d", {0, 90}, [](Ask& a, double x) { a.v_dot_h = std::cos(x * degree); }},
    {"theta", {0, 90}, [](Ask& a, double x) { a.n_dot_v = a.n_dot_l = std::cos(x * degree); }},
    {"ior", {0.01F, 100}, [](Ask& a, double x) { a.ior = x; }},
    {"channel", {0, 2}, [](Ask& a, double x) { a.channel = x; }},
    {"kelvin", {1000, 15000}, [](Ask& a, double x) { a.kelvin = x; }},
    {"samples", {1, 65536}, [](Ask& a, double x) { a.samples = x; }},
    {"f_number", {0.1F, 1000}, [](Ask& a, double x) { a.f_number = x; }},
    {"shutter", {1e-6F, 3600}, [](Ask& a, double x) { a.shutter_s = x; }},
    {"iso", {1, 1e6F}, [](Ask& a, double x) { a.iso = x; }},
    {"focal_mm", {1, 10000}, [](Ask& a, double x) { a.focal_mm = x; }},
    {"focus_m", {0.001F, 1e6F}, [](Ask& a, double x) { a.focus_m = x; }},
    {"distance_m", {0.001F, 1e6F}, [](Ask& a, double x) { a.distance_m = x; }},
};

void read_names(Fields& fields, Ask& ask) {
    ask.what = fields.text("ask", ask.what);
    if (kind_of(ask.what) == nullptr) {
        std::vector<std::string> names;
        for (const Kind& kind : kinds) names.emplace_back(kind.name.name);
        fields.refuse("ask", "no such question", ask.what, base::suggestion(ask.what, names));
    }
    ask.brdf = fields.text("brdf", ask.brdf);
    if (const auto choice = brdf::parse_choice(ask.brdf, brdf::Use::lesson))
        ask.choice = *choice;
    else
        fields.keep(choice.error(), "brdf");
    ask.metal = fields.text("metal", ask.metal);
    std::vector<std::string> metals;
    for (const auto& metal : brdf::metal_spectra) metals.emplace_back(metal.name);
    if (std::ranges::find(metals, ask.metal) == metals.end())
        fields.refuse("metal", "no such metal", ask.metal, base::suggestion(ask.metal, metals));
    const std::string sampler =
        fields.text("sampler", brdf::samplers[static_cast<std::size_t>(ask.sampler)]);
    const auto found = std::ranges::find(brdf::samplers, sampler);
    if (found == brdf::samplers.end())
        fields.refuse("sampler", "no such sampler", sampler, "uniform, cosine or brdf");
    else
        ask.sampler = static_cast<brdf::Sampler>(found - brdf::samplers.begin());
}

}  // namespace

const std::vector<AskName>& ask_names() {
    static const std::vector<AskName> names = [] {
        std::vector<AskName> out;
        for (const Kind& kind : kinds) out.push_back(kind.name);
        return out;
    }();
    return names;
}

Ask read_ask(Fields& fields, Ask initial) {
    Ask ask = std::move(initial);
    read_names(fields, ask);
    constexpr double unset = -1e9;
    for (const Variable& variable : variables) {
        const double value = fields.number(variable.name, unset, variable.range);
        if (value != unset) variable.set(ask, value);
    }
    return ask;
}

bool set_variable(Ask& ask, std::string_view name, double value) {
    const auto* found = std::ranges::find(variables, name, &Variable::name);
    if (found == std::end(variables)) return false;
    found->set(ask, std::clamp(value, static_cast<double>(found->range.low),
                               static_cast<double>(found->range.high)));
    return true;
}

std::vector<std::string> variable_names() {
    std::vector<std::string> out;
    for (const Variable& variable : variables) out.emplace_back(variable.name);
    return out;
}

double Answers::operator()(const Ask& ask) {
    const Kind* kind = kind_of(ask.what);
    return kind == nullptr ? 0.0 : kind->answer(*this, ask);
}

brdf::Queries& Answers::queries(const tables::BrdfChoice& choice) {
    return queries_.try_emplace(choice, choice).first->second;
}

std::string command_of(const Ask& ask) {
    const Kind* kind = kind_of(ask.what);
    if (kind == nullptr || kind->table.empty()) return {};
    if (kind->table == "eval") {
        if (ask.n_dot_h || ask.v_dot_h) return {};
        std::string model = ask.brdf;
        std::ranges::replace(model, ',', ';');
        return fmt::format(
            "printf 'term,model,roughness,metallic,f0,n_dot_v,n_dot_l,phi\\n"
            "{},{},{:g},{:g},{:g},{:g},{:g},{:g}\\n' | facet brdf eval --input -",
            ask.what, model, ask.roughness, ask.metallic, ask.f0, ask.n_dot_v, ask.n_dot_l,
            ask.phi_deg);
    }
    std::string out = fmt::format("facet brdf {} --roughness {:g} --metallic {:g} --n-dot-v {:g}",
                                  kind->table, ask.roughness, ask.metallic, ask.n_dot_v);
    if (ask.f0 != Ask{}.f0) out += fmt::format(" --f0 {:g}", ask.f0);
    if (ask.base != Ask{}.base) out += fmt::format(" --base-color {:g}", ask.base);
    if (!ask.brdf.empty()) out += " --brdf " + ask.brdf;
    if (ask.what == "transmitted" || ask.what == "absorbed") out += " --balance";
    return out;
}

}  // namespace facet::teach
