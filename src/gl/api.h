// The table of GL entry points, filled by the context's own loader.
// SPDX-License-Identifier: MIT
#pragma once

#include <GL/glcorearb.h>

namespace facet::gl {

/// Entry points of one context. Never those of a library linked at build time: libGL and libOSMesa
/// both export the same names, and a program that links both calls the wrong one.
struct Api {
#define FUNCTION(type, name) PFNGL##type##PROC name = nullptr;
#include "gl/api.def"
};

using Function = void (*)();
/// Gives the address of a GL function, or null.
using Loader = Function (*)(const char* name);

/// Fills `api`; returns the name of the first function the loader does not know, or null.
[[nodiscard]] const char* load(Api& api, Loader loader);

}  // namespace facet::gl
