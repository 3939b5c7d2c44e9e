// The BRDF as the shader compiler sees it.
// SPDX-License-Identifier: MIT
#include "frame/evaluate/evaluate.h"

#include "brdf/albedo.h"
#include "brdf/glsl_text.h"
#include "gl/objects.h"
#include "gl/pipeline.h"
#include "gl/shader.h"

#include <algorithm>
#include <array>

namespace facet::frame {
namespace {

/// Questions a draw: 2048 x 510 texels in, a third of that out.
constexpr std::uint32_t across = 2048;
constexpr std::uint32_t down = 170;

void pack(std::span<const brdf::Question> questions, std::vector<math::Vec4>& texels) {
    const auto f = [](double x) { return static_cast<float>(x); };
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto& [term, s, at] = questions[i];
        math::Vec4* row = texels.data() + i / across * 3 * across + i % across;
        row[0] = {f(s.n_dot_v), f(at.n_dot_l), f(at.n_dot_h), f(at.v_dot_h)};
        row[across] = {f(s.roughness), f(s.metallic), f(s.f0), f(s.base)};
        row[2 * across] = math::Vec4(static_cast<float>(term));
    }
}

/// What one draw needs; made once.
class Evaluator {
public:
    static base::Result<Evaluator> create(const gl::Context& gl, const std::filesystem::path& glsl,
                                          const tables::BrdfChoice& choice) {
        const auto text = brdf::glsl_text(choice);
        if (!text) return tl::unexpected(text.error());
        const gl::ShaderSources sources{glsl, {{"generated/brdf.glsl", *text}}};
        Evaluator out;
        auto program = gl::build_program(
            gl, sources, {"frame/full_screen.vert", "frame/evaluate/evaluate.frag", ""});
        if (!program) return tl::unexpected(program.error());
        out.program_ = std::move(*program);
        gl::bind_sampler(gl, out.program_, "questions", 0);
        gl::bind_sampler(gl, out.program_, "albedo_table", 1);
        if (auto made = out.make_textures(gl, choice); !made) return tl::unexpected(made.error());
        out.empty_ = gl::make_vertex_array(gl);
        return out;
    }

    void run(const gl::Context& gl, std::span<const brdf::Question> questions,
             std::vector<float>& answers) {
        std::vector<math::Vec4> texels(questions_spec().size.pixels());
        pack(questions, texels);
        gl::upload(gl, questions_, questions_spec(), 0, 0, {GL_RGBA, GL_FLOAT},
                   std::as_bytes(std::span(texels)));
        gl::begin_draw(gl, framebuffer_, {across, down}, program_, {});
        gl::bind_texture(gl, 0, GL_TEXTURE_2D, questions_, nullptr);
        gl::bind_texture(gl, 1, GL_TEXTURE_2D, table_, &linear_);
        gl::draw_full_screen(gl, empty_);
        std::vector<math::Vec4> out(std::size_t{across} * down);
        gl::read_pixels(gl, framebuffer_, 0, {across, down}, {GL_RGBA, GL_FLOAT},
                        std::as_writable_bytes(std::span(out)));
        for (std::size_t i = 0; i < questions.size(); ++i) answers.push_back(out[i].x);
    }

private:
    static gl::TextureSpec questions_spec() {
        return {.format = GL_RGBA32F, .size = {across, 3 * down}};
    }

    base::Status make_textures(const gl::Context& gl, const tables::BrdfChoice& choice) {
        const brdf::AlbedoTable table = brdf::albedo_table(choice);
        const gl::TextureSpec table_spec{.format = GL_RGBA32F, .size = {table.size, table.size}};
        auto questions = gl::make_texture(gl, questions_spec());
        auto looked_up = gl::make_texture(gl, table_spec);
        auto target = gl::make_texture(gl, {.format = GL_RGBA32F, .size = {across, down}});
        for (const auto* made : {&questions, &looked_up, &target})
            if (!*made) return tl::unexpected(made->error());
        gl::upload(gl, *looked_up, table_spec, 0, 0, {GL_RGBA, GL_FLOAT},
                   std::as_bytes(std::span(table.texels)));
        questions_ = std::move(*questions);
        table_ = std::move(*looked_up);
        target_ = std::move(*target);
        const std::array<const gl::Texture*, 1> colors{&target_};
        auto framebuffer = gl::make_framebuffer(gl, colors, nullptr);
        if (!framebuffer) return tl::unexpected(framebuffer.error());
        framebuffer_ = std::move(*framebuffer);
        linear_ = gl::make_sampler(gl, {.min_filter = GL_LINEAR,
                                        .mag_filter = GL_LINEAR,
                                        .wrap_s = GL_CLAMP_TO_EDGE,
                                        .wrap_t = GL_CLAMP_TO_EDGE});
        return {};
    }

    gl::Program program_;
    gl::Texture questions_;
    gl::Texture table_;
    gl::Texture target_;
    gl::Framebuffer framebuffer_;
    gl::Sampler linear_;
    gl::VertexArray empty_;
};

}  // namespace

base::Result<std::vector<float>> evaluate(const gl::Context& gl, const std::filesystem::path& glsl,
                                          const tables::BrdfChoice& choice,
                                          std::span<const brdf::Question> questions) {
    tables::BrdfChoice alike = choice;
    alike.environment_masking = alike.masking;
    auto evaluator = Evaluator::create(gl, glsl, alike);
    if (!evaluator) return tl::unexpected(evaluator.error());
    std::vector<float> answers;
    answers.reserve(questions.size());
    constexpr std::size_t block = std::size_t{across} * down;
    for (std::size_t first = 0; first < questions.size(); first += block)
        evaluator->run(gl, questions.subspan(first, std::min(block, questions.size() - first)),
                       answers);
    if (auto s = gl.check("brdf"); !s) return tl::unexpected(s.error());
    return answers;
}

}  // namespace facet::frame
