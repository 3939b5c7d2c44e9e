// facet brdf eval: a table of questions in, the same with answers out.
// SPDX-License-Identifier: MIT
#include "base/csv.h"
#include "base/file.h"
#include "base/text.h"
#include "brdf/choice.h"
#include "cli/brdf_options.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <map>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::size_t most_input_bytes = std::size_t{1} << 30U;

/// The columns that a question is made of.
constexpr std::array<std::string_view, 8> column_names{"term", "model",   "roughness", "metallic",
                                                       "f0",   "n_dot_v", "n_dot_l",   "phi"};
enum Column : std::size_t { term, model, roughness, metallic, f0, n_dot_v, n_dot_l, phi };

/// A row as it came, and what it asks.
struct Row {
    std::string text;
    brdf::Question question;
    double n_dot_l = 0.0;
    double phi_deg = 0.0;
    std::size_t model = 0;
};

tl::unexpected<base::Error> at_line(const std::string& file, std::size_t line, std::string what,
                                    std::string found, std::string remedy = "") {
    return fail({.code = ErrorCode::input_invalid,
                 .file = file,
                 .where = fmt::format("line {}", line),
                 .what = std::move(what),
                 .found = std::move(found),
                 .remedy = std::move(remedy)});
}

/// Reads records into questions; keeps the models that were named.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    base::Status read_header(const base::CsvRecord& record) {
        fields_ = record.fields.size();
        for (std::size_t i = 0; i < column_names.size(); ++i) {
            const auto found =
                std::find(record.fields.begin(), record.fields.end(), column_names[i]);
            if (found == record.fields.end())
                return at_line(
                    file_, record.line, "a column is missing", std::string(column_names[i]),
                    "the header names term,model,roughness,metallic,f0,n_dot_v,n_dot_l,phi");
            places_[i] = static_cast<std::size_t>(found - record.fields.begin());
        }
        return {};
    }

    Result<Row> read(const base::CsvRecord& record) {
        if (record.fields.size() != fields_)
            return at_line(file_, record.line,
                           "a row with another number of fields than the header",
                           fmt::format("{} and {}", record.fields.size(), fields_));
        Row row;
        for (std::size_t i = 0; i < record.fields.size(); ++i)
            row.text += (i == 0 ? "" : ",") + base::csv_field(record.fields[i]);
        if (auto s = read_term(record, row); !s) return tl::unexpected(s.error());
        if (auto s = read_model(record, row); !s) return tl::unexpected(s.error());
        brdf::QuerySurface& surface = row.question.surface;
        const std::array<std::pair<Column, double*>, 6> targets{{{roughness, &surface.roughness},
                                                                 {metallic, &surface.metallic},
                                                                 {f0, &surface.f0},
                                                                 {n_dot_v, &surface.n_dot_v},
                                                                 {n_dot_l, &row.n_dot_l},
                                                                 {phi, &row.phi_deg}}};
        for (const auto& [column, target] : targets)
            if (auto s = read_number(record, column, *target); !s) return tl::unexpected(s.error());
        row.question.at = brdf::cosines_of(surface.n_dot_v, row.n_dot_l, row.phi_deg);
        return row;
    }

    [[nodiscard]] const std::vector<tables::BrdfChoice>& models() const { return models_; }

private:
    base::Status read_term(const base::CsvRecord& record, Row& row) const {
        const std::string& name = record.fields[places_[term]];
        const auto found = std::find(brdf::query_terms.begin(), brdf::query_terms.end(), name);
        if (found == brdf::query_terms.end())
            return at_line(file_, record.line, "no such term", name,
                           "one of D G V F specular diffuse full");
        row.question.term = static_cast<brdf::QueryTerm>(found - brdf::query_terms.begin());
        return {};
    }
    base::Status read_model(const base::CsvRecord& record, Row& row) {
        const std::string& text = record.fields[places_[model]];
        const auto [known, is_new] = by_text_.try_emplace(text, models_.size());
        if (is_new) {
            auto choice = brdf::parse_choice(text, brdf::Use::lesson);
            if (!choice)
                return at_line(file_, record.line, choice.error().what, choice.error().found,
                               choice.error().remedy);
            models_.push_back(*choice);
        }
        row.model = known->second;
        return {};
    }
    base::Status read_number(const base::CsvRecord& record, Column column, double& target) const {
        const std::string& text = record.fields[places_[column]];
        const auto number = base::parse_number(base::trimmed(text));
        const double high = column == phi ? 360.0 : 1.0;
        const double low = column == phi ? -360.0 : 0.0;
        if (!number || *number < low || *number > high)
            return at_line(
                file_, record.line,
                fmt::format("{} is a number from {} to {}", column_names[column], low, high), text);
        target = *number;
        return {};
    }

    std::string file_;
    std::size_t fields_ = 0;
    std::array<std::size_t, column_names.size()> places_{};
    std::map<std::string, std::size_t> by_text_;
    std::vector<tables::BrdfChoice> models_;
};

/// Answers all rows, model by model.
Result<std::vector<double>> answer(const std::vector<Row>& rows,
                                   const std::vector<tables::BrdfChoice>& models,
                                   const std::string& via, base::Log& log) {
    Answers answers(via, log);
    std::vector<double> values(rows.size());
    for (std::size_t m = 0; m < models.size(); ++m) {
        std::vector<brdf::Question> questions;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].model == m) {
                questions.push_back(rows[i].question);
                places.push_back(i);
            }
        const auto answered = answers.ask(models[m], questions);
        if (!answered) return tl::unexpected(answered.error());
        for (std::size_t i = 0; i < places.size(); ++i) values[places[i]] = (*answered)[i];
    }
    return values;
}

}  // namespace

Result<Exit> brdf_eval(const BrdfOptions& options, Io& io) {
    if (options.input.empty())
        return fail({.code = ErrorCode::usage,
                     .file = "--input",
                     .what = "is needed",
                     .remedy = "a CSV file, or - for standard input; facet help brdf-terms"});
    const bool is_stdin = options.input == "-";
    const auto bytes = is_stdin ? base::read_stdin(most_input_bytes)
                                : base::read_file(options.input, most_input_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string file = is_stdin ? "standard input" : options.input;
    base::CsvReader csv({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    base::CsvRecord record;
    Reader reader(file);
    const auto header = csv.next(record);
    if (!header) return tl::unexpected(base::in_file(header.error(), file));
    if (!*header) return at_line(file, 1, "empty", "", "the first line names the columns");
    if (auto s = reader.read_header(record); !s) return tl::unexpected(s.error());
    std::vector<Row> rows;
    std::string head;
    for (const std::string& field : record.fields) head += base::csv_field(field) + ",";
    for (;;) {
        const auto more = csv.next(record);
        if (!more) return tl::unexpected(base::in_file(more.error(), file));
        if (!*more) break;
        auto row = reader.read(record);
        if (!row) return tl::unexpected(row.error());
        rows.push_back(std::move(*row));
    }
    base::Log log = io.log();
    const auto values = answer(rows, reader.models(), options.via, log);
    if (!values) return tl::unexpected(values.error());
    io.print(head + "value_r,value_g,value_b");
    for (std::size_t i = 0; i < rows.size(); ++i)
        io.print(
            fmt::format("{},{},{},{}", rows[i].text, (*values)[i], (*values)[i], (*values)[i]));
    return Exit::done;
}

}  // namespace facet::cli
