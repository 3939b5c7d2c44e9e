// What `facet brdf` was asked for, and who answers: C++ or GL.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/flags.h"
#include "cli/output_gate.h"
#include "frame/evaluate/evaluate.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace facet::cli {

struct BrdfOptions {
    std::string action;
    std::vector<std::string> brdf;
    std::string input;
    std::string output;
    std::string via = "cpu";
    std::vector<std::string> roughness;
    std::vector<std::string> metallic;
    std::vector<std::string> n_dot_v;
    std::optional<double> f0;
    std::optional<double> base_color;
    std::optional<double> count;
    std::optional<double> seed;
    bool balance = false;
    OutputRules rules;
};

/// The choice of the one --brdf, or the default. Errors: usage.
[[nodiscard]] base::Result<tables::BrdfChoice> first_choice(const BrdfOptions& options);
/// Numbers of a list option ("0.1,0.5" or repeated), within [low, high]; `initial` where it was not
/// given.
[[nodiscard]] base::Result<std::vector<double>> numbers(const char* option,
                                                        const std::vector<std::string>& texts,
                                                        std::vector<double> initial, double low,
                                                        double high);

/// Answers questions on the side that --via names. The GL context is made at the first question.
class Answers {
public:
    Answers(std::string via, base::Log& log) : via_(std::move(via)), log_(&log) {}
    /// Values in the order of `questions`, all of one choice.
    [[nodiscard]] base::Result<std::vector<double>> ask(const tables::BrdfChoice& choice,
                                                        std::span<const brdf::Question> questions);
    [[nodiscard]] base::Result<std::vector<brdf::Reflectance>> reflectances(
        const tables::BrdfChoice& choice, std::span<const brdf::QuerySurface> surfaces);

private:
    std::string via_;
    base::Log* log_;
    std::optional<gl::Context> gl_;
    std::vector<std::pair<tables::BrdfChoice, brdf::Queries>> known_;  ///< on the CPU
    [[nodiscard]] brdf::Queries& queries(const tables::BrdfChoice& choice);
};

[[nodiscard]] base::Result<Exit> brdf_eval(const BrdfOptions& options, Io& io);
[[nodiscard]] base::Result<Exit> brdf_albedo(const BrdfOptions& options, Io& io);
[[nodiscard]] base::Result<Exit> brdf_furnace(const BrdfOptions& options, Io& io);
[[nodiscard]] base::Result<Exit> brdf_sample(const BrdfOptions& options, Io& io);
[[nodiscard]] base::Result<Exit> brdf_plot(const BrdfOptions& options, Io& io);

}  // namespace facet::cli
