// The same text as GLSL ES 3.00, for browsers: every choice's model, its sampling, and every term
// file. SPDX-License-Identifier: MIT
#include "base/log.h"
#include "base/text.h"
#include "brdf/choice.h"
#include "brdf/glsl_text.h"
#include "gl/context.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

namespace facet::test {
namespace {

/// `text` with its #include lines replaced by the files, each once.
std::string expanded(const std::string& text, std::set<std::string>& seen) {
    std::string out;
    for (const std::string_view line : base::split(text, '\n')) {
        if (!line.starts_with("#include \"")) {
            out += std::string(line) + "\n";
            continue;
        }
        const std::string name(line.substr(10, line.size() - 11));
        if (!seen.insert(name).second) continue;
        std::ifstream file(FACET_SOURCE_DIR "/glsl/" + name);
        EXPECT_TRUE(file) << name;
        out += expanded({std::istreambuf_iterator<char>(file), {}}, seen);
    }
    return out;
}

/// The compiler's complaint; empty where there is none.
std::string complaint(const gl::Context& gl, const std::string& body) {
    const std::string text =
        "#version 300 es\nprecision highp float;\nprecision highp int;\n" + body +
        "layout(location = 0) out vec4 result;\nvoid main() { result = vec4(1.0); }\n";
    const gl::Api& api = gl.api();
    const GLuint shader = api.CreateShader(GL_FRAGMENT_SHADER);
    const char* pointer = text.c_str();
    api.ShaderSource(shader, 1, &pointer, nullptr);
    api.CompileShader(shader);
    GLint compiled = 0;
    api.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log(4096, '\0');
    GLsizei length = 0;
    api.GetShaderInfoLog(shader, 4096, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    api.DeleteShader(shader);
    return compiled == GL_TRUE ? "" : log + "?";
}

struct GlslEs : testing::Test {
    base::Log log;
    base::Result<gl::Context> gl = gl::Context::create(gl::Backend::automatic, log);
};

TEST_F(GlslEs, TakesTheModelAndItsSamplingWithEveryValueOfEverySlot) {
    ASSERT_TRUE(gl);
    ASSERT_NE(complaint(*gl, "this is no shader"), "");
    for (const tables::BrdfSlot& slot : tables::brdf_slots) {
        std::size_t index = 0;
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != slot.key) continue;
            tables::BrdfChoice choice;
            slot.set(choice, index++);
            const auto text = brdf::glsl_text(choice, brdf::Parts::sampling);
            ASSERT_TRUE(text);
            std::set<std::string> seen;
            EXPECT_EQ(complaint(*gl, expanded(*text, seen)), "") << slot.key << "=" << term.name;
        }
    }
}

TEST_F(GlslEs, TakesEveryTermFile) {
    ASSERT_TRUE(gl);
    std::string all = "#include \"brdf/prelude.glsl\"\n";
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        for (const std::string_view file : base::split(term.files, ' '))
            if (!file.empty()) all += "#include \"brdf/" + std::string(file) + ".glsl\"\n";
    for (const char* light :
         {"across", "directional", "disk", "point", "profile", "rect", "sphere", "spot", "tube"})
        all += "#include \"light/" + std::string(light) + ".glsl\"\n";
    std::set<std::string> seen;
    EXPECT_EQ(complaint(*gl, expanded(all, seen)), "");
}

}  // namespace
}  // namespace facet::test
