// A level square around the ground's middle, seen from above.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
out vec2 from_middle;  // of the ground, by its radius
void main() {
    vec2 corners[6] = vec2[6](vec2(-1.0, -1.0), vec2(-1.0, 1.0), vec2(1.0, 1.0), vec2(-1.0, -1.0), vec2(1.0, 1.0), vec2(1.0, -1.0));
    from_middle = corners[gl_VertexID];
    vec3 place = view.ground.xyz + vec3(from_middle.x, 0.0, from_middle.y) * view.ground.w;
    gl_Position = view.clip_from_world * vec4(place, 1.0);
}
