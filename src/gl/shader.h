// Shader programs from GLSL files: own #include expansion, permutation defines, errors with file
// and line. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "gl/context.h"
#include "gl/handle.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace facet::gl {

/// A line of a file, counted from 1.
struct SourceLine {
    std::size_t file = 0;  ///< index into ShaderText::files
    std::size_t line = 0;
};
/// Assembled GLSL: `#include "path"` (from the glsl folder) is replaced by the file, once a path.
/// `origins` says for each line where it came from; drivers do not agree on what #line does with a
/// file's number.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;
    std::vector<SourceLine> origins;
};

/// Where GLSL comes from: the glsl folder, and texts made by the program under names of their own.
struct ShaderSources {
    std::filesystem::path folder;
    std::map<std::string, std::string> generated;  ///< include path -> text
    std::string defines;  ///< `#define` lines of every program made from them
};

/// Errors: internal, naming the file and the line of an include that is not there.
[[nodiscard]] base::Result<ShaderText> assemble(const ShaderSources& sources,
                                                const std::string& path, std::string_view defines);

/// A program of one vertex and one fragment file. `defines` holds `#define` lines.
struct ProgramSpec {
    std::string vertex;
    std::string fragment;
    std::string defines;
};
/// Errors: internal, with the driver's first message at the GLSL's own file and line.
[[nodiscard]] base::Result<Program> build_program(const Context& gl, const ShaderSources& sources,
                                                  const ProgramSpec& spec);

/// Binds a uniform block or sampler of a program to a fixed place; a name the compiler dropped is
/// skipped.
void bind_block(const Context& gl, const Program& program, const char* block, GLuint binding);
void bind_sampler(const Context& gl, const Program& program, const char* name, GLint unit);

}  // namespace facet::gl
