// Shader assembly: includes, and errors at the GLSL's own place.
// SPDX-License-Identifier: MIT
#include "gl/shader.h"

#include <gtest/gtest.h>

namespace facet::gl {
namespace {

const std::string vertex = "void main() { gl_Position = vec4(0.0); }\n";

class ShaderTest : public testing::Test {
protected:
    base::Log log;
    base::Result<Context> gl = Context::create(Backend::automatic, log);
    ShaderSources sources{.folder = FACET_SOURCE_DIR "/glsl", .generated = {{"test.vert", vertex}}};
};

TEST_F(ShaderTest, AnErrorInAnIncludedFileNamesThatFileAndLine) {
    ASSERT_TRUE(gl);
    sources.generated["part.glsl"] =
        "float one() { return 1.0; }\nfloat two() { return nothing; }\n";
    sources.generated["test.frag"] =
        "layout(location = 0) out vec4 color;\n#include \"part.glsl\"\nvoid main() { color = "
        "vec4(one()); }\n";
    const auto program = build_program(*gl, sources, {"test.vert", "test.frag", ""});
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().found.find("glsl/part.glsl:2"), std::string::npos)
        << program.error().found;
}

TEST_F(ShaderTest, AnErrorAfterAnIncludeKeepsTheLineOfItsOwnFile) {
    ASSERT_TRUE(gl);
    sources.generated["part.glsl"] = "float one() { return 1.0; }\n\n\n\n";
    sources.generated["test.frag"] =
        "layout(location = 0) out vec4 color;\n#include \"part.glsl\"\nvoid main() { color = "
        "wrong; }\n";
    const auto program = build_program(*gl, sources, {"test.vert", "test.frag", ""});
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().found.find("glsl/test.frag:3"), std::string::npos)
        << program.error().found;
}

TEST_F(ShaderTest, AMissingIncludeNamesTheLineThatAskedForIt) {
    ASSERT_TRUE(gl);
    sources.generated["test.frag"] = "\n#include \"nowhere.glsl\"\nvoid main() {}\n";
    const auto program = build_program(*gl, sources, {"test.vert", "test.frag", ""});
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().file, "glsl/nowhere.glsl");
    EXPECT_NE(program.error().found.find("glsl/test.frag:2"), std::string::npos)
        << program.error().found;
}

TEST_F(ShaderTest, AFileIncludedTwiceIsThereOnce) {
    ASSERT_TRUE(gl);
    sources.generated["part.glsl"] = "float one() { return 1.0; }\n";
    sources.generated["test.frag"] =
        "#include \"part.glsl\"\n#include \"part.glsl\"\n"
        "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(one()); }\n";
    EXPECT_TRUE(build_program(*gl, sources, {"test.vert", "test.frag", ""}));
}

TEST_F(ShaderTest, AFileThatIncludesItselfEnds) {
    sources.generated["loop.glsl"] = "#include \"loop.glsl\"\n";
    EXPECT_TRUE(assemble(sources, "loop.glsl", ""));
}

}  // namespace
}  // namespace facet::gl
