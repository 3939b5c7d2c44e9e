// Evaluates GLSL statements on the BRDF for many rows of numbers, one row a pixel.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/albedo.h"
#include "brdf/glsl_text.h"
#include "gl/objects.h"
#include "gl/pipeline.h"
#include "gl/shader.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace facet::test {

/// What the statements may use: p.x .. p.w and q.x .. q.w.
using GpuRow = std::array<float, 8>;

/// A context and the pass; every call compiles a program.
class GpuEvaluator {
public:
    /// What `statements` put into vec4 `result`, for each row, with the BRDF of `choice` and
    /// `albedo_table` in reach.
    base::Result<std::vector<math::Vec4>> evaluate(const tables::BrdfChoice& choice,
                                                   const std::string& statements,
                                                   const std::vector<GpuRow>& rows) {
        const auto text = brdf::glsl_text(choice, brdf::Parts::sampling);
        if (!text) return tl::unexpected(text.error());
        return evaluate_text(*text, choice, statements, rows);
    }

    /// The same with other GLSL than the choice's in reach.
    base::Result<std::vector<math::Vec4>> evaluate_text(const std::string& text,
                                                        const tables::BrdfChoice& choice,
                                                        const std::string& statements,
                                                        const std::vector<GpuRow>& rows) {
        if (!gl_) return tl::unexpected(gl_.error());
        const auto program = compile_text(text, statements);
        if (!program) return tl::unexpected(program.error());
        const math::Extent size{static_cast<std::uint32_t>(rows.size()), 1};
        std::vector<math::Vec4> p;
        std::vector<math::Vec4> q;
        for (const GpuRow& row : rows) {
            p.emplace_back(row[0], row[1], row[2], row[3]);
            q.emplace_back(row[4], row[5], row[6], row[7]);
        }
        const brdf::AlbedoTable table = brdf::albedo_table(choice);
        const auto p_texture = texture(size, std::as_bytes(std::span(p)));
        const auto q_texture = texture(size, std::as_bytes(std::span(q)));
        const auto table_texture =
            texture({table.size, table.size}, std::as_bytes(std::span(table.texels)));
        const auto target = gl::make_texture(*gl_, {.format = GL_RGBA32F, .size = size});
        for (const auto* made : {&p_texture, &q_texture, &table_texture, &target})
            if (!*made) return tl::unexpected(made->error());
        const std::array<const gl::Texture*, 1> colors{&*target};
        const auto framebuffer = gl::make_framebuffer(*gl_, colors, nullptr);
        if (!framebuffer) return tl::unexpected(framebuffer.error());
        const gl::Sampler linear = gl::make_sampler(*gl_, {.min_filter = GL_LINEAR,
                                                           .mag_filter = GL_LINEAR,
                                                           .wrap_s = GL_CLAMP_TO_EDGE,
                                                           .wrap_t = GL_CLAMP_TO_EDGE});
        gl::begin_draw(*gl_, *framebuffer, size, *program, {});
        gl::bind_texture(*gl_, 0, GL_TEXTURE_2D, *p_texture, nullptr);
        gl::bind_texture(*gl_, 1, GL_TEXTURE_2D, *q_texture, nullptr);
        gl::bind_texture(*gl_, 2, GL_TEXTURE_2D, *table_texture, &linear);
        gl::draw_full_screen(*gl_, gl::make_vertex_array(*gl_));
        std::vector<math::Vec4> out(rows.size());
        gl::read_pixels(*gl_, *framebuffer, 0, size, {.format = GL_RGBA, .type = GL_FLOAT},
                        std::as_writable_bytes(std::span(out)));
        if (auto s = gl_->check("gpu evaluator"); !s) return tl::unexpected(s.error());
        return out;
    }

    /// Errors: the driver's, at the GLSL's own file and line.
    base::Result<gl::Program> compile(const tables::BrdfChoice& choice,
                                      const std::string& statements) {
        const auto text = brdf::glsl_text(choice, brdf::Parts::sampling);
        if (!text) return tl::unexpected(text.error());
        return compile_text(*text, statements);
    }

private:
    base::Result<gl::Program> compile_text(const std::string& text, const std::string& statements) {
        if (!gl_) return tl::unexpected(gl_.error());
        const std::string main =
            "#include \"generated/brdf.glsl\"\nuniform sampler2D p_rows;\nuniform sampler2D "
            "q_rows;\n"
            "uniform sampler2D albedo_table;\nlayout(location = 0) out vec4 result;\nvoid main() "
            "{\n"
            "vec4 p = texelFetch(p_rows, ivec2(gl_FragCoord.xy), 0);\n"
            "vec4 q = texelFetch(q_rows, ivec2(gl_FragCoord.xy), 0);\n" +
            statements + "}\n";
        const gl::ShaderSources sources{FACET_SOURCE_DIR "/glsl",
                                        {{"generated/brdf.glsl", text}, {"test.frag", main}}};
        auto program =
            gl::build_program(*gl_, sources, {"frame/full_screen.vert", "test.frag", ""});
        if (!program) return program;
        gl::bind_sampler(*gl_, *program, "p_rows", 0);
        gl::bind_sampler(*gl_, *program, "q_rows", 1);
        gl::bind_sampler(*gl_, *program, "albedo_table", 2);
        return program;
    }

    base::Result<gl::Texture> texture(math::Extent size, std::span<const std::byte> bytes) {
        const gl::TextureSpec spec{.format = GL_RGBA32F, .size = size};
        auto made = gl::make_texture(*gl_, spec);
        if (made) gl::upload(*gl_, *made, spec, 0, 0, {.format = GL_RGBA, .type = GL_FLOAT}, bytes);
        return made;
    }

    base::Log log_;
    base::Result<gl::Context> gl_ = gl::Context::create(gl::Backend::automatic, log_);
};

}  // namespace facet::test
