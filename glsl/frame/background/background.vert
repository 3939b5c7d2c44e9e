// The far plane's triangle, with the direction that each corner looks in: directions at one depth are linear
// across the screen, so the corners' are enough.
#include "shared/view.h"
#include "lib/spaces.glsl"
layout(std140) uniform ViewBlock { View view; };
out vec3 direction;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 1.0, 1.0);
    direction = view.forward.xyz;
    if (view.eye_m.w > 0.5)
        direction = world_from_depth(view.world_from_clip, corner * 0.5 + 0.5, 0.5) - view.eye_m.xyz;
}
