// The BRDF terms as the shader compiler sees them, against the tables: float32, so the bounds are
// wider. SPDX-License-Identifier: MIT
#include "support/directions.h"
#include "support/gpu_evaluator.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

#include <functional>

namespace facet::test {
namespace {

using tables::BrdfChoice;
using tables::Distribution;
using tables::Fresnel;
using tables::Masking;
using tables::Multiscatter;

/// One comparison: what goes in, what is computed, what must come out.
struct Comparison {
    std::string table;
    std::vector<std::string> inputs;  ///< columns for p.x, p.y, ... q.w
    BrdfChoice choice;
    std::string statements;
    std::string output;
    double relative = 2e-4;
    double absolute = 1e-9;
    std::function<void(const ReferenceRow&, GpuRow&)> derive =
        {};  ///< adds inputs that are no columns
    std::function<bool(const ReferenceRow&)> wanted = {};
};

void expect_table(GpuEvaluator& gpu, const Comparison& c) {
    std::vector<ReferenceRow> rows;
    std::vector<GpuRow> packed;
    for (const ReferenceRow& row : reference_rows(c.table)) {
        if (c.wanted && !c.wanted(row)) continue;
        GpuRow values{};
        for (std::size_t i = 0; i < c.inputs.size(); ++i)
            values[i] = static_cast<float>(row[c.inputs[i]]);
        if (c.derive) c.derive(row, values);
        rows.push_back(row);
        packed.push_back(values);
    }
    ASSERT_FALSE(rows.empty()) << c.table;
    const auto results = gpu.evaluate(c.choice, c.statements, packed);
    ASSERT_TRUE(results) << base::to_line(results.error());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double expected = rows[i][c.output];
        EXPECT_NEAR(static_cast<double>((*results)[i].x), expected,
                    c.relative * expected + c.absolute)
            << c.output << " of " << rows[i].shown;
    }
}

/// n.h and v.h behind n.v and n.l in p, from the azimuth in the table.
void add_half_vector(const ReferenceRow& row, GpuRow& values) {
    const PairOfDirections at(row["n_dot_v"], row["n_dot_l"], row["phi"]);
    values[2] = static_cast<float>(at.n_dot_h);
    values[3] = static_cast<float>(at.v_dot_h);
}

TEST(BrdfOnGpu, DistributionsEqualTheTables) {
    GpuEvaluator gpu;
    // n.h near 1 loses digits in float: 2e-3 (the tables' own advice). Below 1e-30 float
    // underflows.
    Comparison c{.table = "d_ggx",
                 .inputs = {"n_dot_h", "alpha"},
                 .choice = {},
                 .statements = "result = vec4(slot_distribution(p.x, p.y));\n",
                 .output = "D",
                 .relative = 2e-3,
                 .absolute = 1e-30};
    expect_table(gpu, c);
    // In the tail, exp(-32), the rounding of n.h counts 32-fold; what is below 1e-8 is seen by
    // nobody.
    c.table = "d_beckmann";
    c.absolute = 1e-8;
    c.choice.distribution = Distribution::beckmann;
    expect_table(gpu, c);
}

TEST(BrdfOnGpu, MaskingEqualsTheTables) {
    GpuEvaluator gpu;
    const std::string g =
        "result = vec4(4.0 * p.x * p.y * slot_masking(p.x, p.y, sqrt(p.z), p.z));\n";
    const std::vector<std::string> inputs{"n_dot_v", "n_dot_l", "alpha"};
    expect_table(gpu, {.table = "g_smith_ggx",
                       .inputs = inputs,
                       .choice = {},
                       .statements = g,
                       .output = "G2_correlated"});
    expect_table(gpu, {.table = "g_smith_ggx",
                       .inputs = inputs,
                       .choice = {.masking = Masking::smith},
                       .statements = g,
                       .output = "G2_separable"});
    // GLSL has no erf; the prelude's is good to 1.5e-7, over cosines down to 0.02.
    expect_table(gpu, {.table = "g_smith_beckmann",
                       .inputs = inputs,
                       .choice = {.distribution = Distribution::beckmann},
                       .statements = g,
                       .output = "G2_correlated"});
    const std::string by_roughness =
        "result = vec4(4.0 * p.x * p.y * slot_masking(p.x, p.y, p.z, p.z * p.z));\n";
    for (const auto& [masking, column] :
         {std::pair{Masking::schlick_direct, "G_direct"}, {Masking::schlick_ibl, "G_ibl"}})
        expect_table(gpu, {.table = "g_seed",
                           .inputs = {"n_dot_v", "n_dot_l", "roughness"},
                           .choice = {.masking = masking},
                           .statements = by_roughness,
                           .output = column});
}

TEST(BrdfOnGpu, FresnelEqualsTheTables) {
    GpuEvaluator gpu;
    // Where total reflection begins, the root of float rounding shows: 1e-3 of 1 in f_dielectric.
    expect_table(gpu,
                 {.table = "f_schlick",
                  .inputs = {"f0", "u"},
                  .choice = {},
                  .statements = "result = vec4(slot_fresnel(vec3(p.x), vec3(1.0), p.y), 0.0);\n",
                  .output = "F",
                  .absolute = 1e-6});
    expect_table(gpu, {.table = "f_dielectric",
                       .inputs = {"u", "eta"},
                       .choice = {.fresnel = Fresnel::dielectric},
                       .statements = "result = vec4(f_dielectric(p.x, p.y));\n",
                       .output = "F",
                       .absolute = 1e-6});
    expect_table(gpu, {.table = "f_conductor",
                       .inputs = {"u", "n", "k"},
                       .choice = {.fresnel = Fresnel::conductor},
                       .statements = "result = vec4(f_conductor(p.x, p.y, p.z));\n",
                       .output = "F",
                       .absolute = 1e-6});
    expect_table(gpu,
                 {.table = "f_f82",
                  .inputs = {"f0", "tint", "u"},
                  .choice = {.fresnel = Fresnel::f82},
                  .statements = "result = vec4(slot_fresnel(vec3(p.x), vec3(p.y), p.z), 0.0);\n",
                  .output = "F",
                  .absolute = 1e-6});
}

TEST(BrdfOnGpu, DiffuseLobesEqualTheTable) {
    GpuEvaluator gpu;
    for (const auto& [diffuse, column] :
         {std::pair{tables::Diffuse::burley, "burley"}, {tables::Diffuse::eon, "eon_rho1"}})
        expect_table(gpu, {.table = "diffuse_points",
                           .inputs = {"n_dot_v", "n_dot_l", "n_dot_l", "n_dot_l", "roughness"},
                           .choice = {.diffuse = diffuse},
                           .statements =
                               "result = vec4(slot_diffuse(vec3(1.0), q.x, p.x, p.y, p.w), 0.0);\n",
                           .output = column,
                           .absolute = 1e-6,
                           .derive = add_half_vector});
}

const std::string light_statements =
    "BrdfSurface s = brdf_surface(vec3(1.0), q.y, q.x);\n"
    "s.dielectric_f0 = vec3(q.z);\n"
    "vec4 albedo = textureLod(albedo_table, albedo_coordinates(p.x, q.x), 0.0);\n"
    "BrdfValue f = brdf_light(brdf_view(s, p.x, albedo), p.y, p.z, p.w, 1.0);\n"
    "result = vec4(f.specular + f.diffuse, 0.0);\n";
const std::vector<std::string> light_inputs{"n_dot_v",   "n_dot_l",  "n_dot_l", "n_dot_l",
                                            "roughness", "metallic", "f0"};

TEST(BrdfOnGpu, CookTorranceOfEveryModelEqualsTheTable) {
    GpuEvaluator gpu;
    const std::pair<std::string, BrdfChoice> models[] = {
        {"ggx-correlated", {}},
        {"seed-direct", {.masking = Masking::schlick_direct}},
        {"seed-ibl", {.masking = Masking::schlick_ibl}},
        {"beckmann-correlated", {.distribution = Distribution::beckmann}}};
    for (auto [model, choice] : models) {
        choice.multiscatter = Multiscatter::off;
        expect_table(gpu, {.table = "brdf_points",
                           .inputs = light_inputs,
                           .choice = choice,
                           .statements = light_statements,
                           .output = "brdf",
                           .relative = 2e-3,
                           .derive = add_half_vector,
                           .wanted = [&](const ReferenceRow& row) {
                               return row.texts.at("model") == model;
                           }});
    }
}

TEST(BrdfOnGpu, TheDefaultModelWithItsTableEqualsTheReference) {
    GpuEvaluator gpu;
    // 2.5e-3 is what the albedo table promises (brdf/albedo.h), over pi in the diffuse lobe.
    expect_table(gpu, {.table = "brdf_points_ms",
                       .inputs = light_inputs,
                       .choice = {},
                       .statements = light_statements,
                       .output = "brdf",
                       .relative = 2e-3,
                       .absolute = 1e-3,
                       .derive = add_half_vector});
}

TEST(BrdfOnGpu, TheFilteredTableEqualsTheSplitSum) {
    GpuEvaluator gpu;
    const std::string look_up =
        "vec4 e = textureLod(albedo_table, albedo_coordinates(p.x, p.y), 0.0);\n";
    for (const auto& [column, channel] : {std::pair{"A", "x"}, {"B", "y"}})
        expect_table(gpu, {.table = "split_sum",
                           .inputs = {"n_dot_v", "roughness"},
                           .choice = {},
                           .statements = look_up + "result = vec4(e." + channel + ");\n",
                           .output = column,
                           .relative = 0.0,
                           .absolute = 2.5e-3});
}

TEST(BrdfOnGpu, EveryTermCompilesInItsSlot) {
    GpuEvaluator gpu;
    const std::string all =
        "BrdfView v = brdf_view(brdf_surface(p.xyz, p.w, q.x), q.y, p);\n"
        "BrdfValue f = brdf_light(v, q.x, q.y, q.z, q.w);\nBrdfValue e = brdf_environment(v);\n"
        "BrdfSampler s = brdf_sampler(v, q.xyz);\nvec3 l = brdf_sample(v, s, p.xy, p.z);\n"
        "result = vec4(f.diffuse + f.specular + e.diffuse + e.specular + l, brdf_pdf(v, s, q.x, "
        "q.y, q.z));\n";
    for (const tables::BrdfSlot& slot : tables::brdf_slots) {
        std::size_t index = 0;
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != slot.key) continue;
            BrdfChoice choice;
            slot.set(choice, index++);
            const auto program = gpu.compile(choice, all);
            EXPECT_TRUE(program) << slot.key << "=" << term.name << ": "
                                 << base::to_line(program.error());
        }
    }
}

}  // namespace
}  // namespace facet::test
