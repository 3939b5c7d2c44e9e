// One AOV of the G-buffer; FACET_AOV is the expression of its row in tables/aovs.def.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
#include "lib/octahedral.glsl"
#include "lib/spaces.glsl"

uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_metal_rough_ao;
uniform sampler2D gbuffer_depth;
uniform sampler2D gbuffer_emissive;
uniform usampler2D gbuffer_ids;

layout(location = 0) out vec4 out_value;

struct AovSurface {
    vec3 albedo;
    vec3 normal;
    float metallic;
    float roughness;
    float ao;
    vec3 emissive;
    vec3 position_m;
    float depth_m;
    uint object_id;
    uint material_id;
};

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 metal_rough_ao = texelFetch(gbuffer_metal_rough_ao, pixel, 0).rgb;
    uvec2 ids = texelFetch(gbuffer_ids, pixel, 0).xy;
    AovSurface surface;
    surface.albedo = texelFetch(gbuffer_albedo, pixel, 0).rgb;
    surface.normal = unit_from_octahedral(texelFetch(gbuffer_normal, pixel, 0).rg);
    surface.metallic = metal_rough_ao.r;
    surface.roughness = metal_rough_ao.g;
    surface.ao = metal_rough_ao.b;
    surface.emissive = texelFetch(gbuffer_emissive, pixel, 0).rgb;
    float depth = texelFetch(gbuffer_depth, pixel, 0).r;
    surface.position_m = world_from_depth(view.world_from_clip, gl_FragCoord.xy * view.size_px.zw, depth);
    surface.depth_m = dot(surface.position_m - view.eye_m.xyz, view.forward.xyz);
    surface.object_id = ids.x;
    surface.material_id = ids.y;
    out_value = vec4(FACET_AOV, 1.0);
}
