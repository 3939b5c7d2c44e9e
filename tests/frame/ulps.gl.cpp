// The one source text compiled twice: C++ in float and the driver's GLSL, on the same random
// inputs. SPDX-License-Identifier: MIT
#include "base/text.h"
#include "brdf/terms.h"
#include "support/gpu_evaluator.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>

namespace facet::test {
namespace {

using Lobe = brdf::Terms<float>;
using Vec3 = Lobe::real3;
using Vec2 = Lobe::real2;

/// Floats between two values of one sign; a lot where they differ in it.
double ulps_between(float a, float b) {
    const auto place = [](float x) {
        const auto bits = std::bit_cast<std::int32_t>(x);
        return static_cast<double>(bits < 0 ? static_cast<std::int32_t>(0x80000000U) - bits : bits);
    };
    return std::fabs(place(a) - place(b));
}

/// One term: how GLSL calls it on p and q (both in [0, 1)), how C++ does, and how far they may be
/// apart.
struct Term {
    const char* name;
    const char* glsl;
    std::function<float(Lobe&, const float* x)> cpp;
    double ulps;
    /// Below this, the difference itself is bounded by it: where a value is what a subtraction has
    /// left of larger ones, its own ulps say nothing.
    float floor = 0.0F;
};

Vec3 unit(float x, float y) {
    const float cosine = 0.02F + 0.98F * x;
    const float sine = std::sqrt(std::max(0.0F, (1.0F - cosine) * (1.0F + cosine)));
    return {sine * std::cos(6.0F * y), sine * std::sin(6.0F * y), cosine};
}
const char* const unit_glsl =
    "float c_ = 0.02 + 0.98 * p.x; float s_ = sqrt(max(0.0, (1.0 - c_) * (1.0 + c_)));\n"
    "vec3 v = vec3(s_ * cos(6.0 * p.y), s_ * sin(6.0 * p.y), c_);\n"
    "float d_ = 0.02 + 0.98 * p.z; float t_ = sqrt(max(0.0, (1.0 - d_) * (1.0 + d_)));\n"
    "vec3 l = vec3(t_ * cos(6.0 * p.w), t_ * sin(6.0 * p.w), d_);\nfloat a = 0.01 + 0.99 * q.x;\n"
    "vec2 a2 = vec2(a, 0.01 + 0.99 * q.y);\n";

// A multiplication, a division and a square root are correctly rounded on both sides: what is left
// is the order of operations (the driver may contract or reorder), and its exp, log, pow, sin, cos
// and acos, which are polynomials.
const Term terms[] = {
    {"d_ggx", "d_ggx(p.x, a)",
     [](Lobe& b, const float* x) { return b.d_ggx(x[0], 0.01F + 0.99F * x[4]); }, 16},
    {"d_beckmann", "d_beckmann(0.3 + 0.7 * p.x, 0.1 + 0.9 * q.x)",
     [](Lobe& b, const float* x) { return b.d_beckmann(0.3F + 0.7F * x[0], 0.1F + 0.9F * x[4]); },
     512, 1e-20F},
    {"d_blinn_phong", "d_blinn_phong(0.3 + 0.7 * p.x, 0.2 + 0.8 * q.x)",
     [](Lobe& b, const float* x) {
         return b.d_blinn_phong(0.3F + 0.7F * x[0], 0.2F + 0.8F * x[4]);
     },
     512, 1e-20F},
    {"phong", "phong(0.3 + 0.7 * p.x, 40.0 * q.x)",
     [](Lobe& b, const float* x) { return b.phong(0.3F + 0.7F * x[0], 40.0F * x[4]); }, 512,
     1e-20F},
    {"v_smith_ggx_correlated", "v_smith_ggx_correlated(p.x, p.y, a)",
     [](Lobe& b, const float* x) {
         return b.v_smith_ggx_correlated(x[0], x[1], 0.01F + 0.99F * x[4]);
     },
     16},
    {"v_smith_ggx", "v_smith_ggx(p.x, p.y, a)",
     [](Lobe& b, const float* x) { return b.v_smith_ggx(x[0], x[1], 0.01F + 0.99F * x[4]); }, 16},
    {"v_schlick_direct", "v_schlick_direct(p.x, p.y, a)",
     [](Lobe& b, const float* x) { return b.v_schlick_direct(x[0], x[1], 0.01F + 0.99F * x[4]); },
     16},
    {"v_schlick_ibl", "v_schlick_ibl(p.x, p.y, a)",
     [](Lobe& b, const float* x) { return b.v_schlick_ibl(x[0], x[1], 0.01F + 0.99F * x[4]); }, 16},
    {"v_none", "v_none(p.x, p.y)", [](Lobe& b, const float* x) { return b.v_none(x[0], x[1]); },
     16},
    {"lambda_beckmann", "lambda_beckmann(p.x, a)",
     [](Lobe& b, const float* x) { return b.lambda_beckmann(x[0], 0.01F + 0.99F * x[4]); }, 4096,
     1e-6F},
    {"f_schlick", "f_schlick(vec3(q.y), p.x).x",
     [](Lobe& b, const float* x) { return b.f_schlick(Vec3(x[5]), x[0]).x; }, 16},
    {"f_dielectric", "f_dielectric(p.x, 1.0 + q.y)",
     [](Lobe& b, const float* x) { return b.f_dielectric(x[0], 1.0F + x[5]); }, 64, 1e-6F},
    {"f_conductor", "f_conductor(p.x, 0.2 + 3.0 * q.y, 5.0 * q.z)",
     [](Lobe& b, const float* x) { return b.f_conductor(x[0], 0.2F + 3.0F * x[5], 5.0F * x[6]); },
     64, 1e-6F},
    {"f_f82", "f_f82(vec3(q.y), vec3(q.z), p.x).x",
     [](Lobe& b, const float* x) { return b.f_f82(Vec3(x[5]), Vec3(x[6]), x[0]).x; }, 64, 1e-6F},
    {"ior_from_f0", "ior_from_f0(q.y)", [](Lobe& b, const float* x) { return b.ior_from_f0(x[5]); },
     64},
    {"k_from_f0", "k_from_f0(q.y)", [](Lobe& b, const float* x) { return b.k_from_f0(x[5]); }, 64},
    {"diffuse_lambert", "diffuse_lambert(vec3(q.y)).x",
     [](Lobe& b, const float* x) { return b.diffuse_lambert(Vec3(x[5])).x; }, 2},
    {"diffuse_burley", "diffuse_burley(vec3(q.y), a, p.x, p.y, p.z).x",
     [](Lobe& b, const float* x) {
         return b.diffuse_burley(Vec3(x[5]), 0.01F + 0.99F * x[4], x[0], x[1], x[2]).x;
     },
     16},
    {"diffuse_eon", "diffuse_eon(vec3(q.y), a, p.x, p.y, p.z).x",
     [](Lobe& b, const float* x) {
         return b.diffuse_eon(Vec3(x[5]), 0.01F + 0.99F * x[4], x[0], x[1], x[2]).x;
     },
     4096, 1e-5F},
    {"diffuse_eon_albedo", "diffuse_eon_albedo(vec3(q.y), a, p.x).x",
     [](Lobe& b, const float* x) {
         return b.diffuse_eon_albedo(Vec3(x[5]), 0.01F + 0.99F * x[4], x[0]).x;
     },
     4096, 1e-5F},
    {"ms_turquin", "ms_turquin(vec3(q.y), 0.2 + 0.8 * q.z).x",
     [](Lobe& b, const float* x) { return b.ms_turquin(Vec3(x[5]), 0.2F + 0.8F * x[6]).x; }, 16},
    {"ms_fdez_aguera", "ms_fdez_aguera(vec3(q.y), 0.5 * q.z, 0.4 * q.w).x",
     [](Lobe& b, const float* x) {
         return b.ms_fdez_aguera(Vec3(x[5]), 0.5F * x[6], 0.4F * x[7]).x;
     },
     64},
    {"ms_kulla_conty", "ms_kulla_conty(vec3(q.y), q.z, 0.4 + 0.5 * q.w).x",
     [](Lobe& b, const float* x) {
         return b.ms_kulla_conty(Vec3(x[5]), x[6], 0.4F + 0.5F * x[7]).x;
     },
     64},
    {"d_ggx_anisotropic", "d_ggx_anisotropic(v, a2)",
     [](Lobe& b, const float* x) {
         return b.d_ggx_anisotropic(unit(x[0], x[1]),
                                    Vec2(0.01F + 0.99F * x[4], 0.01F + 0.99F * x[5]));
     },
     64, 1e-5F},
    {"v_smith_ggx_anisotropic", "v_smith_ggx_anisotropic(v, l, a2)",
     [](Lobe& b, const float* x) {
         return b.v_smith_ggx_anisotropic(unit(x[0], x[1]), unit(x[2], x[3]),
                                          Vec2(0.01F + 0.99F * x[4], 0.01F + 0.99F * x[5]));
     },
     64},
    {"pdf_ggx", "pdf_ggx(0.001 + 0.999 * p.x, p.y, a)",
     [](Lobe& b, const float* x) {
         return b.pdf_ggx(0.001F + 0.999F * x[0], x[1], 0.01F + 0.99F * x[4]);
     },
     32},
    {"pdf_ggx_anisotropic", "pdf_ggx_anisotropic(v, normalize(v + l), a2)",
     [](Lobe& b, const float* x) {
         const Vec3 v = unit(x[0], x[1]);
         return b.pdf_ggx_anisotropic(v, b.normalize(v + unit(x[2], x[3])),
                                      Vec2(0.01F + 0.99F * x[4], 0.01F + 0.99F * x[5]));
     },
     64, 1e-3F},
    {"pdf_ndf", "pdf_ndf(q.y, p.x, 0.01 + p.y)",
     [](Lobe& b, const float* x) { return b.pdf_ndf(x[5], x[0], 0.01F + x[1]); }, 16},
    {"pdf_cosine", "pdf_cosine(p.x)", [](Lobe& b, const float* x) { return b.pdf_cosine(x[0]); },
     2},
    {"pdf_uniform", "pdf_uniform(p.x)", [](Lobe& b, const float* x) { return b.pdf_uniform(x[0]); },
     2},
    {"sample_ggx", "sample_ggx(v, a, q.zw).z",
     [](Lobe& b, const float* x) {
         return b.sample_ggx(unit(x[0], x[1]), 0.01F + 0.99F * x[4], {x[6], x[7]}).z;
     },
     64, 1e-4F},
    {"sample_ggx_anisotropic", "sample_ggx_anisotropic(v, a2, q.zw).z",
     [](Lobe& b, const float* x) {
         return b
             .sample_ggx_anisotropic(unit(x[0], x[1]),
                                     Vec2(0.01F + 0.99F * x[4], 0.01F + 0.99F * x[5]), {x[6], x[7]})
             .z;
     },
     64, 1e-4F},
    {"sample_beckmann", "sample_beckmann(a, q.zw).z",
     [](Lobe& b, const float* x) {
         return b.sample_beckmann(0.01F + 0.99F * x[4], {x[6], x[7]}).z;
     },
     64},
    {"sample_blinn_phong", "sample_blinn_phong(a, q.zw).z",
     [](Lobe& b, const float* x) {
         return b.sample_blinn_phong(0.01F + 0.99F * x[4], {x[6], x[7]}).z;
     },
     64},
    {"sample_cosine", "sample_cosine(q.zw).z",
     [](Lobe& b, const float* x) {
         return b.sample_cosine({x[6], x[7]}).z;
     },
     4},
    {"sample_uniform", "sample_uniform(q.zw).z",
     [](Lobe& b, const float* x) { return b.sample_uniform({x[6], x[7]}).z; }, 2},
    {"d_charlie", "d_charlie(p.x, 0.1 + 0.9 * q.x)",
     [](Lobe& b, const float* x) { return b.d_charlie(x[0], 0.1F + 0.9F * x[4]); }, 64, 1e-6F},
    {"v_charlie", "v_charlie(0.02 + 0.98 * p.x, 0.02 + 0.98 * p.y, a)",
     [](Lobe& b, const float* x) {
         return b.v_charlie(0.02F + 0.98F * x[0], 0.02F + 0.98F * x[1], 0.01F + 0.99F * x[4]);
     },
     256},
    {"v_neubelt", "v_neubelt(p.x, p.y)",
     [](Lobe& b, const float* x) { return b.v_neubelt(x[0], x[1]); }, 16},
    {"clearcoat", "clearcoat(p.x, p.y, p.z, p.w, 0.1 + 0.9 * q.x)",
     [](Lobe& b,
        const float* x) { return b.clearcoat(x[0], x[1], x[2], x[3], 0.1F + 0.9F * x[4]); },
     64}};

std::vector<GpuRow> random_rows() {
    std::mt19937 engine(11);
    std::vector<GpuRow> rows(4000);
    for (GpuRow& row : rows)
        for (float& x : row) x = static_cast<float>(engine() >> 8U) / 16777216.0F;
    return rows;
}

/// Every term file there is, behind the default choice's.
std::string every_term() {
    std::string text = "#include \"brdf/prelude.glsl\"\n";
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        for (const std::string_view file : base::split(term.files, ' '))
            if (!file.empty() &&
                text.find("brdf/" + std::string(file) + ".glsl") == std::string::npos)
                text += "#include \"brdf/" + std::string(file) + ".glsl\"\n";
    return text;
}

TEST(TwoCompilations, OfEveryTermAgreeWithinTheirUlpsOnRandomInputs) {
    GpuEvaluator gpu;
    Lobe lobe;
    const auto rows = random_rows();
    for (const Term& term : terms) {
        const auto values = gpu.evaluate_text(
            every_term(), {}, std::string(unit_glsl) + "result = vec4(" + term.glsl + ");\n", rows);
        ASSERT_TRUE(values) << term.name << ": " << base::to_line(values.error());
        double worst = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const float gl = (*values)[i].x;
            const float cpp = term.cpp(lobe, rows[i].data());
            ASSERT_TRUE(std::isfinite(gl) && std::isfinite(cpp)) << term.name << " row " << i;
            if (std::fabs(gl - cpp) <= term.floor) continue;
            worst = std::max(worst, ulps_between(gl, cpp));
        }
        RecordProperty(term.name, std::to_string(worst));
        EXPECT_LE(worst, term.ulps) << term.name;
    }
}

TEST(TwoCompilations, CoverEveryTermFile) {
    std::string names;
    for (const Term& term : terms) names += std::string(" ") + term.name + " ";
    for (const tables::BrdfTerm& row : tables::brdf_terms)
        for (const std::string_view file : base::split(row.files, ' ')) {
            // What others call, and is tested through them.
            const bool inner =
                file == "eon_albedo" || file == "lambda_charlie" || file == "v_smith_beckmann" ||
                file == "v_smith_beckmann_correlated" || file == "ms_kulla_conty_shape";
            if (!file.empty() && !inner) {
                EXPECT_NE(names.find(" " + std::string(file) + " "), std::string::npos) << file;
            }
        }
}

}  // namespace
}  // namespace facet::test
