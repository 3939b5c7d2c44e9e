// facet brdf albedo, furnace, sample: tables of what a BRDF reflects, and of where it sends light.
// SPDX-License-Identifier: MIT
#include "brdf/draw.h"
#include "cli/brdf_options.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

namespace facet::cli {
namespace {

using base::Result;
using brdf::QuerySurface;

const std::vector<double> default_roughness{0.03, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
const std::vector<double> default_metallic{0.0, 0.25, 0.5, 0.75, 1.0};
const std::vector<double> default_n_dot_v{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};

/// The grid of surfaces: roughness, then metallic, then n.v.
Result<std::vector<QuerySurface>> surfaces(const BrdfOptions& options,
                                           std::vector<double> metallic) {
    const auto r = numbers("--roughness", options.roughness, default_roughness, 0.0, 1.0);
    if (!r) return tl::unexpected(r.error());
    const auto m = numbers("--metallic", options.metallic, std::move(metallic), 0.0, 1.0);
    if (!m) return tl::unexpected(m.error());
    const auto v = numbers("--n-dot-v", options.n_dot_v, default_n_dot_v, 0.0, 1.0);
    if (!v) return tl::unexpected(v.error());
    std::vector<QuerySurface> out;
    for (const double roughness : *r)
        for (const double metal : *m)
            for (const double cosine : *v)
                out.push_back({roughness, metal, options.f0.value_or(0.04),
                               options.base_color.value_or(1.0), cosine});
    return out;
}

/// One line of the result, as CSV or as an object.
class Table {
public:
    Table(std::vector<const char*> columns, Io& io) : columns_(std::move(columns)), io_(&io) {
        if (io.json) return;
        std::string head;
        for (const char* column : columns_) head += (head.empty() ? "" : ",") + std::string(column);
        io.print(head);
    }
    void row(const std::vector<double>& values) {
        if (io_->json) {
            nlohmann::ordered_json object;
            for (std::size_t i = 0; i < columns_.size(); ++i) object[columns_[i]] = values[i];
            return io_->print_object(object);
        }
        std::string line;
        for (const double value : values)
            line += fmt::format("{}{}", line.empty() ? "" : ",", value);
        io_->print(line);
    }

private:
    std::vector<const char*> columns_;
    Io* io_;
};

}  // namespace

Result<Exit> brdf_albedo(const BrdfOptions& options, Io& io) {
    const auto choice = first_choice(options);
    if (!choice) return tl::unexpected(choice.error());
    const auto grid = surfaces(options, {0.0});
    if (!grid) return tl::unexpected(grid.error());
    base::Log log = io.log();
    Answers answers(options.via, log);
    const auto reflected = answers.reflectances(*choice, *grid);
    if (!reflected) return tl::unexpected(reflected.error());
    std::vector<const char*> columns{"roughness", "n_dot_v", "albedo"};
    if (options.balance) columns.insert(columns.end(), {"reflected", "transmitted", "absorbed"});
    Table table(columns, io);
    for (std::size_t i = 0; i < grid->size(); ++i) {
        const brdf::Reflectance& r = (*reflected)[i];
        std::vector<double> values{(*grid)[i].roughness, (*grid)[i].n_dot_v, r.specular};
        if (options.balance) values.insert(values.end(), {r.specular, r.diffuse, 1.0 - r.sum()});
        table.row(values);
    }
    return Exit::done;
}

Result<Exit> brdf_furnace(const BrdfOptions& options, Io& io) {
    const auto choice = first_choice(options);
    if (!choice) return tl::unexpected(choice.error());
    const auto grid = surfaces(options, default_metallic);
    if (!grid) return tl::unexpected(grid.error());
    base::Log log = io.log();
    Answers answers(options.via, log);
    const auto reflected = answers.reflectances(*choice, *grid);
    if (!reflected) return tl::unexpected(reflected.error());
    Table table({"roughness", "metallic", "n_dot_v", "albedo", "residual"}, io);
    for (std::size_t i = 0; i < grid->size(); ++i) {
        const QuerySurface& s = (*grid)[i];
        const double sum = (*reflected)[i].sum();
        table.row({s.roughness, s.metallic, s.n_dot_v, sum, sum - 1.0});
    }
    return Exit::done;
}

Result<Exit> brdf_sample(const BrdfOptions& options, Io& io) {
    const auto choice = first_choice(options);
    if (!choice) return tl::unexpected(choice.error());
    BrdfOptions one = options;
    if (one.roughness.empty()) one.roughness = {"0.5"};
    if (one.n_dot_v.empty()) one.n_dot_v = {"0.7"};
    const auto grid = surfaces(one, {0.0});
    if (!grid) return tl::unexpected(grid.error());
    if (grid->size() != 1 || grid->front().roughness <= 0.0 || grid->front().n_dot_v <= 0.0)
        return base::fail(
            {.code = base::ErrorCode::usage,
             .file = "--roughness",
             .what = "sample takes one surface and one view, roughness and n.v above 0",
             .remedy = "give --roughness, --metallic and --n-dot-v one number each"});
    const QuerySurface& s = grid->front();
    brdf::Queries queries(*choice);
    brdf::Draws draws(*choice, s, queries, static_cast<std::uint32_t>(options.seed.value_or(0.0)));
    Table table({"x", "y", "z", "pdf", "value", "weight"}, io);
    const auto count = static_cast<std::size_t>(options.count.value_or(16.0));
    for (std::size_t i = 0; i < count; ++i) {
        const brdf::Drawn drawn = draws.next(brdf::Sampler::brdf);
        table.row({drawn.l.x, drawn.l.y, drawn.l.z, drawn.pdf, drawn.value, drawn.weight()});
    }
    return Exit::done;
}

}  // namespace facet::cli
