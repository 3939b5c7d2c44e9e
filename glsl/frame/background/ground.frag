// By how much the scene changes the light on the ground.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
uniform sampler2D ground_share;  // a texel for view.rays.w pixels across
in vec2 from_middle;
layout(location = 0) out vec4 out_share;  // a: what it covers of what is not covered
void main() {
    if (dot(from_middle, from_middle) > 1.0) discard;
    vec3 share = textureLod(ground_share, gl_FragCoord.xy / (float(view.rays.w) * vec2(textureSize(ground_share, 0))), 0.0).rgb;
    out_share = vec4(share, clamp(1.0 - dot(share, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0));
}
