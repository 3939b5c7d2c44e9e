// The values of tables/aovs.def as C++: the table's text, which the rasteriser compiles as GLSL.
// SPDX-License-Identifier: MIT
#include "trace/aov.h"

namespace facet::trace {

math::Vec3 aov_value(tables::Aov aov, const AovSurface& surface, const LightPaths& paths) {
    using vec3 = math::Vec3;  // GLSL's name, for the table's text
    switch (aov) {
#define AOV(name, value, ...) \
    case tables::Aov::name:   \
        return value;
#include "tables/aovs.def"
    }
    return vec3(0.0F);
}

}  // namespace facet::trace
