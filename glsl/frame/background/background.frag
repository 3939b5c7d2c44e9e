// What shows where no surface is: the environment, or one of its blurred levels. The cube's first level is as fine as
// the picture it was made from, and a cube costs one fetch where a lat-long picture costs two inverse functions more.
#include "shared/view.h"
#include "lib/spaces.glsl"
layout(std140) uniform ViewBlock { View view; };
uniform samplerCube radiance_cube;

layout(location = 0) out vec4 out_radiance;

void main() {
    vec2 uv = gl_FragCoord.xy * view.size_px.zw;
    vec3 d = view.forward.xyz;
    if (view.eye_m.w > 0.5) d = world_from_depth(view.world_from_clip, uv, 0.5) - view.eye_m.xyz;
    out_radiance = vec4(textureLod(radiance_cube, d, view.background.x).rgb, 1.0);
}
