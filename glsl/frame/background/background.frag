// What shows where no surface is: the environment, or one of its blurred levels.
#include "shared/view.h"
#include "lib/spaces.glsl"
layout(std140) uniform ViewBlock { View view; };
uniform samplerCube radiance_cube;
uniform sampler2D latlong;

layout(location = 0) out vec4 out_radiance;

const float INV_PI = 0.318309886183790671538;

// The middle column is -z, columns to its right turn towards +x; row 0 is +y (contract, "Conventions").
vec2 latlong_uv(vec3 d) {
    return vec2(atan(d.x, -d.z) * 0.5 * INV_PI + 0.5, acos(clamp(d.y, -1.0, 1.0)) * INV_PI);
}

void main() {
    vec2 uv = gl_FragCoord.xy * view.size_px.zw;
    vec3 d = view.forward.xyz;
    if (view.eye_m.w > 0.5) d = normalize(world_from_depth(view.world_from_clip, uv, 0.5) - view.eye_m.xyz);
#if FACET_BACKGROUND_SHARP
    float c = view.environment.z;
    float s = view.environment.w;
    vec3 turned = vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
    out_radiance = vec4(textureLod(latlong, latlong_uv(turned), 0.0).rgb * view.environment.y, 1.0);
#else
    out_radiance = vec4(textureLod(radiance_cube, d, view.background.x).rgb, 1.0);
#endif
}
