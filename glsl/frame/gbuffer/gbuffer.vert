// Geometry: objects to clip space, with what the material needs.
#include "shared/view.h"
#include "shared/draw.h"
layout(std140) uniform ViewBlock { View view; };
layout(std140) uniform DrawBlock { Draw draw; };

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 color;

invariant gl_Position;  // layers are drawn again where the G-buffer has them
out vec3 vertex_normal;
#if FACET_TANGENTS
out vec4 vertex_tangent;
#endif
out vec2 vertex_uv0;
#if FACET_UV_GENERAL
out vec2 vertex_uv1;
#endif
#if FACET_VERTEX_COLOR
out vec4 vertex_color;
#endif
#if FACET_FORWARD
out vec3 vertex_position_m;
#endif

void main() {
    vec4 world = draw.world_from_object * vec4(position_m, 1.0);
    gl_Position = view.clip_from_world * world;
    vertex_normal = mat3(draw.normal_from_object) * normal;
#if FACET_TANGENTS
    vertex_tangent = vec4(mat3(draw.world_from_object) * tangent.xyz, tangent.w);
#endif
    vertex_uv0 = uv0;
#if FACET_UV_GENERAL
    vertex_uv1 = uv1;
#endif
#if FACET_VERTEX_COLOR
    vertex_color = color;
#endif
#if FACET_FORWARD
    vertex_position_m = world.xyz;
#endif
}
