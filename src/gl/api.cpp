// The table of GL entry points.
// SPDX-License-Identifier: MIT
#include "gl/api.h"

namespace facet::gl {

const char* load(Api& api, Loader loader) {
#define FUNCTION(type, name)                                            \
    api.name = reinterpret_cast<PFNGL##type##PROC>(loader("gl" #name)); \
    if (api.name == nullptr) return "gl" #name;
#include "gl/api.def"
    return nullptr;
}

}  // namespace facet::gl
