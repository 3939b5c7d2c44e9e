// What shows where no surface is: the environment, or one of its blurred levels. The cube's first level is as fine as
// the picture it was made from, and a cube costs one fetch where a lat-long picture costs two inverse functions more.
#include "shared/view.h"
#ifdef FACET_EXPLAIN
#include "frame/explain/explain.glsl"
#endif
layout(std140) uniform ViewBlock { View view; };
uniform samplerCube radiance_cube;

in vec3 direction;
layout(location = 0) out vec4 out_radiance;

void main() {
    out_radiance = vec4(textureLod(radiance_cube, direction, view.background.x).rgb * view.environment.w, 1.0);
    // A blurred sun would be a faint glow: it is left out.
    if (view.background.x == 0.0 && dot(normalize(direction), view.sun.xyz) > view.sun.w)
        out_radiance.rgb += view.sun_nit.rgb;
#ifdef FACET_EXPLAIN
    explain_begin(EXPLAIN_BACKGROUND, 0u, 0u);
    explained.to_eye = vec4(-normalize(direction), 0.0);
    explained.radiance = out_radiance;
    explain_end();
#endif
}
