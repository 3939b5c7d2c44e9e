// Numbers about light on a surface, as lessons ask for them: in their text and along the curves of
// their plots. SPDX-License-Identifier: MIT
#pragma once

#include "brdf/draw.h"
#include "teach/fields.h"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace facet::teach {

/// One question. `what` is a name of ask_names(); only the members that it speaks of matter.
struct Ask {
    std::string what = "full";
    std::string brdf;  ///< as --brdf has it
    tables::BrdfChoice choice;
    double roughness = 0.5;  ///< perceptual
    double metallic = 0.0;
    double f0 = 0.04;
    double base = 1.0;
    double n_dot_v = 1.0;
    double n_dot_l = 1.0;
    double phi_deg = 180.0;         ///< azimuth from view to light
    std::optional<double> n_dot_h;  ///< else what n_dot_v, n_dot_l and phi_deg lead to
    std::optional<double> v_dot_h;
    double ior = 1.5;
    std::string metal = "gold";
    double channel = 0.0;  ///< 0 red, 1 green, 2 blue
    double kelvin = 6500.0;
    double samples = 16.0;
    double f_number = 8.0;
    double shutter_s = 0.01;
    double iso = 100.0;
    double focal_mm = 50.0;
    double focus_m = 2.0;
    double distance_m = 4.0;
    brdf::Sampler sampler = brdf::Sampler::cosine;
};

/// Everything that can be asked, with what it is.
struct AskName {
    std::string_view name;
    std::string_view help;
};
[[nodiscard]] const std::vector<AskName>& ask_names();

/// Reads the members that an Ask has; others are left to the caller. Wrong ones are the Fields'
/// error. `initial` holds what is not given.
[[nodiscard]] Ask read_ask(Fields& fields, Ask initial);

/// The variables that a curve can run over: members of Ask, and theta_v, theta_l, theta_h, theta_d
/// (v.h) and theta (view and light alike) in degrees. False: no such variable.
[[nodiscard]] bool set_variable(Ask& ask, std::string_view variable, double value);
[[nodiscard]] std::vector<std::string> variable_names();

/// Answers; remembers what takes a quadrature.
class Answers {
public:
    /// Precondition: read_ask() took the question.
    [[nodiscard]] double operator()(const Ask& ask);

    [[nodiscard]] brdf::Queries& queries(const tables::BrdfChoice& choice);

private:
    std::unordered_map<tables::BrdfChoice, brdf::Queries> queries_;
};

/// The command whose output holds the answer; empty where there is none.
[[nodiscard]] std::string command_of(const Ask& ask);

}  // namespace facet::teach
