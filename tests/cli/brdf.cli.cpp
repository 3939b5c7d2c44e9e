// facet brdf: the independent tables through the program, in C++ and in GL, and what bad input
// gets. SPDX-License-Identifier: MIT
#include "base/text.h"
#include "support/process.h"
#include "support/reference_table.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace facet::cli {
namespace {

using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;
using test::reference_rows;

constexpr const char* head = "term,model,roughness,metallic,f0,n_dot_v,n_dot_l,phi\n";

/// One question with the answer that a table has.
struct Known {
    std::string row;
    double value;
};

void ask(const std::vector<Known>& known, const char* via, double relative, double absolute) {
    const TemporaryFolder folder;
    const auto grid = folder / "grid.csv";
    std::ofstream(grid) << head << [&] {
        std::string rows;
        for (const Known& k : known) rows += k.row + "\n";
        return rows;
    }();
    const Ran ran = facet({"brdf", "eval", "--input", grid.string(), "--via", via});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const auto lines = base::split(ran.out, '\n');
    ASSERT_EQ(lines.size(), known.size() + 2);
    for (std::size_t i = 0; i < known.size(); ++i) {
        const std::string line(lines[i + 1]);
        ASSERT_TRUE(line.starts_with(known[i].row + ",")) << line;
        const auto fields = base::split(line, ',');
        const auto value = base::parse_number(fields.back());
        ASSERT_TRUE(value) << line;
        EXPECT_NEAR(*value, known[i].value, relative * std::fabs(known[i].value) + absolute)
            << line;
    }
}

std::string row(const std::string& term, const std::string& model, const test::ReferenceRow& r) {
    const auto column = [&](const char* name) {
        const auto found = r.numbers.find(name);
        return found == r.numbers.end() ? std::string("0") : nlohmann::json(found->second).dump();
    };
    return term + "," + model + "," + column("roughness") + "," + column("metallic") + "," +
           column("f0") + "," + column("n_dot_v") + "," + column("n_dot_l") + "," + column("phi");
}

const std::map<std::string, std::string> models{
    {"ggx-correlated", "multiscatter=off"},
    {"seed-direct", "lecture"},
    {"seed-ibl", "masking=schlick-ibl;multiscatter=off"},
    {"beckmann-correlated", "distribution=beckmann;multiscatter=off"}};

std::vector<Known> full_values() {
    std::vector<Known> known;
    for (const auto& r : reference_rows("brdf_points")) {
        const auto model = models.find(r.texts.at("model"));
        if (model == models.end()) continue;
        known.push_back({row("full", model->second, r), r["brdf"]});
        known.push_back({row("specular", model->second, r), r["specular"]});
    }
    return known;
}
std::vector<Known> compensated_values() {
    std::vector<Known> known;
    for (const auto& r : reference_rows("brdf_points_ms")) {
        known.push_back({row("full", "", r), r["brdf"]});
        known.push_back({row("specular", "", r), r["specular"]});
    }
    return known;
}
std::vector<Known> masking_values() {
    std::vector<Known> known;
    for (const auto& r : reference_rows("g_seed")) {
        known.push_back({row("G", "lecture", r), r["G_direct"]});
        known.push_back({row("G", "masking=schlick-ibl", r), r["G_ibl"]});
    }
    return known;
}

// The tables' own suggestions for tolerances: tighter on the CPU than in a shader's float.
TEST(BrdfEval, EqualsTheIndependentTablesOnTheCpu) {
    ask(full_values(), "cpu", 1e-5, 1e-12);
    ask(compensated_values(), "cpu", 1e-4, 1e-5);
    ask(masking_values(), "cpu", 1e-6, 1e-12);
}
TEST(BrdfEval, EqualsTheIndependentTablesInGl) {
    ask(full_values(), "gl", 2e-3, 1e-6);
    ask(compensated_values(), "gl", 1e-2, 1e-3);
    ask(masking_values(), "gl", 2e-4, 1e-6);
}

TEST(BrdfEval, AnswersInInputOrderWhateverTheModels) {
    ask({{"F,fresnel=none,0.5,0,0.04,0.5,0.5,0", 1.0},
         {"diffuse,,0.5,0,0.04,0.5,0.5,0", 1.0 / 3.14159265358979},
         {"G,masking=none,0.5,0,0.04,0.5,0.25,90", 1.0},
         {"F,fresnel=none,0.5,1,0.04,0.5,0.5,0", 1.0}},
        "cpu", 1e-9, 0.0);
}

TEST(BrdfEval, TellsTheLineAndThePlaceOfABadRow) {
    const TemporaryFolder folder;
    const auto grid = (folder / "grid.csv").string();
    const std::pair<std::string, std::string> cases[] = {
        {std::string(head) + "X,,0.5,0,0.04,1,1,0", "line 2: no such term (X)"},
        {std::string(head) + "D,,0.5,0,0.04,1,1,0\nD,,nan,0,0.04,1,1,0",
         "line 3: roughness is a number"},
        {std::string(head) + "D,,0.5,0,0.04,2,1,0", "line 2: n_dot_v is a number from 0 to 1 (2)"},
        {std::string(head) + "D,distribution=gx,0.5,0,0.04,1,1,0", "did you mean ggx"},
        {std::string(head) + "D,,0.5", "line 2: a row with another number of fields"},
        {"term,model\nD,", "line 1: a column is missing (roughness)"},
        {"", "line 1: empty"},
        {std::string(head) + "\"D", "line 2: a quote that is not closed"}};
    for (const auto& [text, message] : cases) {
        std::ofstream(grid) << text;
        const Ran ran = facet({"brdf", "eval", "--input", grid});
        EXPECT_EQ(ran.exit, 3) << text;
        EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
        EXPECT_EQ(ran.out, "");
    }
}

TEST(BrdfFurnace, DefaultModelIsWithinHalfAPercentInCppAndOnePercentInGl) {
    for (const auto& [via, bound] : {std::pair{"cpu", 0.005}, {"gl", 0.01}}) {
        const Ran ran = facet({"brdf", "furnace", "--via", via, "--json"});
        ASSERT_EQ(ran.exit, 0) << ran.err;
        int rows = 0;
        for (const auto line : base::split(ran.out, '\n')) {
            if (line.empty()) continue;
            ++rows;
            EXPECT_LE(std::fabs(nlohmann::json::parse(line)["residual"].get<double>()), bound)
                << via << line;
        }
        EXPECT_EQ(rows, 11 * 5 * 11);
    }
}

// The lecture's loss, and what its letter gains, is what an independent table says, not repaired.
TEST(BrdfAlbedo, OfTheLecturesMaskingEqualsTheTable) {
    const std::pair<const char*, const char*> readings[] = {
        {"E_direct", "lecture,fresnel=none"},
        {"E_ibl", "lecture,masking=schlick-ibl,fresnel=none"},
        {"E_direct_literal", "lecture-literal,fresnel=none"},
        {"E_ibl_literal", "lecture-literal,masking=schlick-ibl,fresnel=none"}};
    for (const auto& [column, model] : readings)
        for (const auto& r : reference_rows("albedo_seed")) {
            if (r["roughness"] < 0.1) continue;
            const Ran ran = facet({"brdf", "albedo", "--brdf", model, "--roughness",
                                   nlohmann::json(r["roughness"]).dump(), "--n-dot-v",
                                   nlohmann::json(r["n_dot_v"]).dump(), "--json"});
            ASSERT_EQ(ran.exit, 0) << ran.err;
            EXPECT_NEAR(nlohmann::json::parse(ran.out)["albedo"].get<double>(), r[column], 1e-4)
                << column << r.shown;
        }
}

TEST(BrdfAlbedo, BalanceAddsUpToOne) {
    const Ran ran = facet({"brdf", "albedo", "--balance", "--base-color", "0.3", "--json"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    for (const auto line : base::split(ran.out, '\n')) {
        if (line.empty()) continue;
        const auto object = nlohmann::json::parse(line);
        const double sum = object["reflected"].get<double>() + object["transmitted"].get<double>() +
                           object["absorbed"].get<double>();
        EXPECT_NEAR(sum, 1.0, 1e-12);
        EXPECT_GT(object["absorbed"].get<double>(), 0.0);
    }
}

TEST(BrdfSample, MeanWeightIsTheAlbedoAndTheSeedRepeatsIt) {
    const std::vector<std::string> command{"brdf", "sample",      "--count", "20000",      "--seed",
                                           "4",    "--roughness", "0.4",     "--metallic", "0.5"};
    const Ran ran = facet(command);
    ASSERT_EQ(ran.exit, 0) << ran.err;
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;
    for (const auto line : base::split(ran.out, '\n')) {
        if (line.empty() || line.starts_with("x")) continue;
        const auto weight = base::parse_number(base::split(line, ',').back());
        ASSERT_TRUE(weight);
        sum += *weight;
        squares += *weight * *weight;
        ++count;
    }
    EXPECT_EQ(count, 20000);
    const double mean = sum / count;
    EXPECT_NEAR(
        mean, 1.0,
        3.0 * std::sqrt((squares / count - mean * mean) / count));  // white: everything returns
    EXPECT_EQ(facet(command).out, ran.out);
}

TEST(BrdfPlot, IsOneSvgWithATitleAxesAndBothColourSchemes) {
    const TemporaryFolder folder;
    const auto file = folder / "lobe.svg";
    const Ran ran = facet({"brdf", "plot", "--brdf", "", "--brdf", "lecture", "-o", file.string()});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const std::string svg = text_of(file);
    for (const char* part :
         {"<svg", "</svg>", "prefers-color-scheme: dark", "D, 1/sr", "degrees", "lecture"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(facet({"brdf", "plot", "-o", (folder / "lobe.png").string()}).exit, 2);
}

TEST(Brdf, AnswersAMisspeltActionAndOptionWithTheNearest) {
    const Ran action = facet({"brdf", "furnce"});
    EXPECT_EQ(action.exit, 2);
    EXPECT_NE(action.err.find("furnace"), std::string::npos);
    EXPECT_EQ(facet({"brdf", "albedo", "--via", "gpu"}).exit, 2);
    EXPECT_EQ(facet({"brdf", "albedo", "--roughness", "0.5,x"}).exit, 2);
    EXPECT_EQ(facet({"brdf", "eval"}).exit, 2);
    EXPECT_EQ(facet({"brdf"}).exit, 2);
}

}  // namespace
}  // namespace facet::cli
