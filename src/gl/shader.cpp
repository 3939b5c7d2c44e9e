// Shader programs from GLSL files.
// SPDX-License-Identifier: MIT
#include "gl/shader.h"

#include "base/file.h"
#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>

namespace facet::gl {
namespace {

constexpr std::size_t max_glsl_bytes = 1 << 20;
constexpr std::size_t max_include_depth = 16;

/// One assembly under way.
class Assembler {
public:
    explicit Assembler(const ShaderSources& sources) : sources_(sources) {}

    base::Status add(const std::string& path, const std::string& from, std::size_t depth) {
        if (std::find(out.files.begin(), out.files.end(), path) != out.files.end()) return {};
        auto text = read(path);
        if (!text || depth > max_include_depth)
            return base::fail(
                {.code = base::ErrorCode::internal,
                 .file = "glsl/" + path,
                 .what = depth > max_include_depth ? "includes nest too deep" : "cannot be read",
                 .found = "included from " + from});
        const std::size_t index = out.files.size();
        out.files.push_back(path);
        return expand(*text, path, index, depth);
    }

    ShaderText out;

private:
    base::Result<std::string> read(const std::string& path) const {
        if (const auto made = sources_.generated.find(path); made != sources_.generated.end())
            return made->second;
        return base::read_text_file(sources_.folder / path, max_glsl_bytes);
    }

    base::Status expand(std::string_view text, const std::string& path, std::size_t index,
                        std::size_t depth) {
        std::size_t line_number = 0;
        for (const std::string_view line : base::split(text, '\n')) {
            ++line_number;
            const std::string_view code = base::trimmed(line);
            if (!code.starts_with("#include")) {
                out.text += line;
                out.text += '\n';
                out.origins.push_back({index, line_number});
                continue;
            }
            const std::size_t begin = code.find('"');
            const std::size_t end = code.rfind('"');
            const std::string included(end > begin ? code.substr(begin + 1, end - begin - 1) : "");
            const std::string from = fmt::format("glsl/{}:{}", path, line_number);
            if (auto added = add(included, from, depth + 1); !added) return added;
        }
        return {};
    }

    const ShaderSources& sources_;
};

/// Mesa: `0:LINE(COLUMN): error: …`; NVIDIA: `0(LINE) : error …`. Others are shown as they are.
std::string at_own_place(std::string_view log, const ShaderText& text) {
    const std::string_view first = base::trimmed(log.substr(0, log.find('\n')));
    if (first.size() < 3 || first[0] != '0' || (first[1] != ':' && first[1] != '('))
        return std::string(first);
    const char* const end = first.data() + first.size();
    std::size_t line = 0;
    const auto after = std::from_chars(first.data() + 2, end, line);
    if (after.ec != std::errc() || line == 0 || line > text.origins.size())
        return std::string(first);
    const SourceLine& origin = text.origins[line - 1];
    return fmt::format("glsl/{}:{}: {}", text.files[origin.file], origin.line,
                       std::string_view(after.ptr, static_cast<std::size_t>(end - after.ptr)));
}

base::Result<Shader> compile(const Context& gl, GLenum stage, const ShaderText& text) {
    const Api& api = gl.api();
    Shader shader(api, api.CreateShader(stage));
    const char* source = text.text.c_str();
    api.ShaderSource(shader.name(), 1, &source, nullptr);
    api.CompileShader(shader.name());
    GLint compiled = 0;
    api.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != 0) return shader;
    std::string log(8192, '\0');
    GLsizei length = 0;
    api.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return base::fail({.code = base::ErrorCode::internal,
                       .file = "glsl/" + text.files.front(),
                       .what = "the driver does not compile this shader",
                       .found = at_own_place(log, text)});
}

}  // namespace

base::Result<ShaderText> assemble(const ShaderSources& sources, const std::string& path,
                                  std::string_view defines) {
    Assembler assembler(sources);
    assembler.out.text = fmt::format("#version 430 core\n{}{}", sources.defines, defines);
    const auto head = std::count(assembler.out.text.begin(), assembler.out.text.end(), '\n');
    assembler.out.origins.assign(static_cast<std::size_t>(head), {0, 1});
    if (auto added = assembler.add(path, "the program", 0); !added)
        return tl::unexpected(added.error());
    return std::move(assembler.out);
}

base::Result<Program> build_program(const Context& gl, const ShaderSources& sources,
                                    const ProgramSpec& spec) {
    const Api& api = gl.api();
    Program program(api, api.CreateProgram());
    std::vector<Shader> shaders;  // deleted with the scope; the program keeps what it linked
    for (const auto& [stage, path] :
         {std::pair{GL_VERTEX_SHADER, spec.vertex}, std::pair{GL_FRAGMENT_SHADER, spec.fragment}}) {
        const auto text = assemble(sources, path, spec.defines);
        if (!text) return tl::unexpected(text.error());
        auto shader = compile(gl, stage, *text);
        if (!shader) return tl::unexpected(shader.error());
        api.AttachShader(program.name(), shader->name());
        shaders.push_back(std::move(*shader));
    }
    api.LinkProgram(program.name());
    GLint linked = 0;
    api.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked != 0) return program;
    std::string log(8192, '\0');
    GLsizei length = 0;
    api.GetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return base::fail({.code = base::ErrorCode::internal,
                       .file = "glsl/" + spec.fragment,
                       .what = "the driver does not link this program",
                       .found = log});
}

void bind_block(const Context& gl, const Program& program, const char* block, GLuint binding) {
    const GLuint index = gl.api().GetUniformBlockIndex(program.name(), block);
    if (index != GL_INVALID_INDEX) gl.api().UniformBlockBinding(program.name(), index, binding);
}

void bind_sampler(const Context& gl, const Program& program, const char* name, GLint unit) {
    gl.api().UseProgram(program.name());
    const GLint location = gl.api().GetUniformLocation(program.name(), name);
    if (location >= 0) gl.api().Uniform1i(location, unit);
}

}  // namespace facet::gl
