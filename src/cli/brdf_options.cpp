// What `facet brdf` was asked for, and who answers.
// SPDX-License-Identifier: MIT
#include "cli/brdf_options.h"

#include "base/resources.h"
#include "base/text.h"
#include "brdf/choice.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::cli {

using base::ErrorCode;
using base::fail;
using base::Result;

Result<tables::BrdfChoice> first_choice(const BrdfOptions& options) {
    if (options.brdf.size() > 1)
        return fail({.code = ErrorCode::usage,
                     .file = "--brdf",
                     .what = "takes one model here",
                     .found = fmt::format("{}", options.brdf.size()),
                     .remedy = "facet brdf plot lays several side by side"});
    auto choice =
        brdf::parse_choice(options.brdf.empty() ? "" : options.brdf.front(), brdf::Use::lesson);
    if (!choice) return tl::unexpected(base::in_file(choice.error(), "--brdf"));
    choice->environment_masking = choice->masking;
    return choice;
}

Result<std::vector<double>> numbers(const char* option, const std::vector<std::string>& texts,
                                    std::vector<double> initial, double low, double high) {
    if (texts.empty()) return initial;
    std::vector<double> out;
    for (const std::string& text : texts)
        for (const std::string_view part : base::split(text, ',')) {
            const auto number = base::parse_number(base::trimmed(part));
            if (!number || *number < low || *number > high)
                return fail(
                    {.code = ErrorCode::usage,
                     .file = option,
                     .what = fmt::format("takes numbers from {} to {}, commas between", low, high),
                     .found = std::string(part)});
            out.push_back(*number);
        }
    return out;
}

brdf::Queries& Answers::queries(const tables::BrdfChoice& choice) {
    for (brdf::Queries& each : known_)
        if (each.choice().masking == choice.masking &&
            each.choice().distribution == choice.distribution &&
            each.choice().fresnel == choice.fresnel && each.choice().diffuse == choice.diffuse &&
            each.choice().multiscatter == choice.multiscatter &&
            each.choice().width == choice.width)
            return each;
    return known_.emplace_back(choice);
}

Result<std::vector<double>> Answers::ask(const tables::BrdfChoice& choice,
                                         std::span<const frame::Question> questions) {
    std::vector<double> out;
    out.reserve(questions.size());
    if (via_ == "cpu") {
        brdf::Queries& asked = queries(choice);
        for (const frame::Question& q : questions)
            out.push_back(asked.value(q.term, q.surface, q.at));
        return out;
    }
    if (!gl_) {
        gl::prepare_environment(0);
        auto made = gl::Context::create(gl::Backend::automatic, *log_);
        if (!made) return tl::unexpected(made.error());
        gl_ = std::move(*made);
    }
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    const auto values = frame::evaluate(*gl_, *folder / "glsl", choice, questions);
    if (!values) return tl::unexpected(values.error());
    out.assign(values->begin(), values->end());
    return out;
}

Result<std::vector<brdf::Reflectance>> Answers::reflectances(
    const tables::BrdfChoice& choice, std::span<const brdf::QuerySurface> surfaces) {
    std::vector<brdf::Reflectance> out;
    if (via_ == "cpu") {
        for (const brdf::QuerySurface& surface : surfaces)
            out.push_back(brdf::reflectance(queries(choice), surface));
        return out;
    }
    // Some at a time: a surface takes thousands of questions, and every call to the GL compiles.
    constexpr std::size_t at_once = 128;
    for (std::size_t first = 0; first < surfaces.size(); first += at_once) {
        const auto part = surfaces.subspan(first, std::min(at_once, surfaces.size() - first));
        std::vector<frame::Question> questions;
        std::vector<double> weights;
        const auto add = [&](brdf::QueryTerm term, const brdf::QuerySurface& surface,
                             const brdf::LightNode& node, double sign) {
            questions.push_back({term, surface, node});
            weights.push_back(sign * node.weight);
        };
        std::vector<std::array<std::size_t, 2>> ends;
        for (const brdf::QuerySurface& surface : part) {
            const brdf::ReflectanceNodes nodes = brdf::reflectance_nodes(choice, surface);
            for (const brdf::LightNode& node : nodes.specular)
                add(brdf::QueryTerm::model_specular, surface, node, 1.0);
            const std::size_t middle = questions.size();
            for (const brdf::LightNode& node : nodes.diffuse) {
                add(brdf::QueryTerm::full, surface, node, 1.0);
                add(brdf::QueryTerm::model_specular, surface, node, -1.0);
            }
            ends.push_back({middle, questions.size()});
        }
        const auto values = ask(choice, questions);
        if (!values) return tl::unexpected(values.error());
        std::size_t at = 0;
        for (const auto& [middle, end] : ends) {
            brdf::Reflectance sum;
            for (; at < middle; ++at) sum.specular += weights[at] * (*values)[at];
            for (; at < end; ++at) sum.diffuse += weights[at] * (*values)[at];
            out.push_back(sum);
        }
    }
    return out;
}

}  // namespace facet::cli
