// Adds one jittered frame to the sum.
#include "brdf/prelude.glsl"
#include "camera/vignette.glsl"
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
uniform sampler2D radiance;
layout(location = 0) out vec4 out_sum;
void main() {
    out_sum = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
    if (view.lens.z <= 0.0) return;
    vec2 tangent = view.tangents.zw + view.tangents.xy * gl_FragCoord.xy;
    out_sum.rgb *= natural_vignetting(tangent) * mechanical_vignetting(tangent, view.lens.xy, view.lens.z, view.lens.w);
}
