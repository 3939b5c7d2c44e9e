// The structs that C++ and GLSL share: the driver's offset of every member against the compiler's.
// SPDX-License-Identifier: MIT
#include "frame/shared.h"
#include "gl/shader.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace facet::frame {
namespace {

struct Member {
    const char* name;
    std::size_t offset;
};

/// A program that reads both blocks, so that no member is dropped.
class LayoutTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(gl);
        sources.generated["test.vert"] =
            "#include \"shared/view.h\"\n#include \"shared/draw.h\"\n"
            "layout(std140) uniform ViewBlock { View view; };\n"
            "layout(std140) uniform DrawBlock { Draw draw; };\n"
            "void main() { gl_Position = view.clip_from_world * draw.world_from_object * "
            "draw.base_color_opacity; }\n";
        sources.generated["test.frag"] =
            "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(1.0); }\n";
        auto built = gl::build_program(*gl, sources, {"test.vert", "test.frag", ""});
        ASSERT_TRUE(built) << base::to_line(built.error());
        program = std::move(*built);
    }

    GLint offset(const char* name) const {
        const gl::Api& api = gl->api();
        const GLuint index = api.GetProgramResourceIndex(program.name(), GL_UNIFORM, name);
        const GLenum property = GL_OFFSET;
        GLint value = -1;
        if (index != GL_INVALID_INDEX)
            api.GetProgramResourceiv(program.name(), GL_UNIFORM, index, 1, &property, 1, nullptr,
                                     &value);
        return value;
    }

    base::Log log;
    base::Result<gl::Context> gl = gl::Context::create(gl::Backend::automatic, log);
    gl::ShaderSources sources{.folder = FACET_SOURCE_DIR "/glsl", .generated = {}};
    gl::Program program;
};

#define MEMBER(type, name) \
    Member { "" #name, offsetof(type, name) }

TEST_F(LayoutTest, TheDriverPlacesEveryMemberOfViewWhereTheCompilerDoes) {
    using shared::View;
    for (const Member& m :
         {MEMBER(View, clip_from_world), MEMBER(View, world_from_clip),
          MEMBER(View, middle_from_world), MEMBER(View, eye_m), MEMBER(View, forward),
          MEMBER(View, size_px), MEMBER(View, light_counts), MEMBER(View, environment),
          MEMBER(View, background), MEMBER(View, pixel), MEMBER(View, rays),
          MEMBER(View, key_light)})
        EXPECT_EQ(offset((std::string("view.") + m.name).c_str()), static_cast<GLint>(m.offset))
            << m.name;
}

TEST_F(LayoutTest, TheDriverPlacesEveryMemberOfDrawWhereTheCompilerDoes) {
    using shared::Draw;
    for (const Member& m :
         {MEMBER(Draw, world_from_object), MEMBER(Draw, normal_from_object),
          MEMBER(Draw, base_color_opacity), MEMBER(Draw, metallic_roughness_normal_ao),
          MEMBER(Draw, emissive_nit_cutoff), MEMBER(Draw, ids)})
        EXPECT_EQ(offset((std::string("draw.") + m.name).c_str()), static_cast<GLint>(m.offset))
            << m.name;
    EXPECT_EQ(offset("draw.uv_rows[0]"), static_cast<GLint>(offsetof(Draw, uv_rows)));
}

}  // namespace
}  // namespace facet::frame
