// What `facet brdf` was asked for, and who answers.
// SPDX-License-Identifier: MIT
#include "cli/brdf_options.h"

#include "base/resources.h"
#include "base/text.h"
#include "brdf/choice.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

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
    for (auto& [asked, queries] : known_)
        if (asked == choice) return queries;
    return known_.emplace_back(choice, brdf::Queries(choice)).second;
}

Result<std::vector<double>> Answers::ask(const tables::BrdfChoice& choice,
                                         std::span<const brdf::Question> questions) {
    std::vector<double> out;
    out.reserve(questions.size());
    if (via_ == "cpu") {
        brdf::Queries& asked = queries(choice);
        for (const brdf::Question& q : questions)
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
    // Some at a time: a surface takes thousands of questions, and every call to the GL compiles.
    constexpr std::size_t at_once = 128;
    for (std::size_t first = 0; first < surfaces.size(); first += at_once) {
        std::vector<brdf::Question> questions;
        std::vector<std::size_t> counts;
        for (const brdf::QuerySurface& surface :
             surfaces.subspan(first, std::min(at_once, surfaces.size() - first))) {
            const auto own = brdf::reflectance_questions(choice, surface);
            questions.insert(questions.end(), own.begin(), own.end());
            counts.push_back(own.size());
        }
        const auto values = ask(choice, questions);
        if (!values) return tl::unexpected(values.error());
        std::size_t at = 0;
        for (const std::size_t count : counts) {
            out.push_back(brdf::reflectance(std::span(questions).subspan(at, count),
                                            std::span(*values).subspan(at, count)));
            at += count;
        }
    }
    return out;
}

}  // namespace facet::cli
