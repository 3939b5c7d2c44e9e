// What shows where no surface is: the environment, or one of its blurred levels. The cube's first level is as fine as
// the picture it was made from, and a cube costs one fetch where a lat-long picture costs two inverse functions more.
#include "brdf/prelude.glsl"
#include "brdf/d_ggx.glsl"
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
    float to_sun = dot(normalize(direction), view.sun.xyz);
    if (view.background.y == 0.0) {
        if (to_sun > view.sun.w) out_radiance.rgb += view.sun_nit.rgb;
    } else if (view.sun.w < 1.5) {
        // The lobe that blurs: facets that mirror the sun to an eye straight above them, weighted with its cosine.
        float n_dot_h = sqrt(0.5 + 0.5 * clamp(to_sun, -1.0, 1.0));
        out_radiance.rgb += view.sun_nit.rgb * (d_ggx(n_dot_h, view.background.y) * max(to_sun, 0.0) * view.background.z);
    }
#ifdef FACET_EXPLAIN
    explain_begin(EXPLAIN_BACKGROUND, 0u, 0u);
    explained.to_eye = vec4(-normalize(direction), 0.0);
    explained.radiance = out_radiance;
    explain_end();
#endif
}
