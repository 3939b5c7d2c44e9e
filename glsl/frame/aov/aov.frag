// One AOV of the G-buffer; FACET_AOV is the expression of its row in tables/aovs.def, FACET_KEY_LIGHT whether that is a
// term of the BRDF.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
#include "lib/octahedral.glsl"
#include "lib/spaces.glsl"
#if FACET_KEY_LIGHT
#include "generated/brdf.glsl"
#include "lib/shading_bounds.glsl"
uniform sampler2D albedo_table;  // as lighting/shade.glsl reads it
#endif

uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_metal_rough_ao;
uniform sampler2D gbuffer_depth;
uniform sampler2D gbuffer_emissive;
uniform usampler2D gbuffer_ids;
#if FACET_SPECULAR
uniform sampler2D gbuffer_specular;
#endif

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
#if FACET_KEY_LIGHT
    float n_dot_v;
    float n_dot_l;
    float n_dot_h;
    float v_dot_h;
    BrdfTerms brdf;
#endif
};

#if FACET_KEY_LIGHT
// The terms as lighting/shade.glsl evaluates them in the light of the key light.
void add_key_light(inout AovSurface surface) {
    vec3 v = view.eye_m.w > 0.5 ? normalize(view.eye_m.xyz - surface.position_m) : -view.forward.xyz;
    vec3 way = view.key_light.xyz - surface.position_m * view.key_light.w;
    vec3 l = way * inversesqrt(max(dot(way, way), 1e-12));
    vec3 sum = v + l;
    vec3 h = sum * inversesqrt(max(dot(sum, sum), 1e-12));
    surface.n_dot_v = clamp(dot(surface.normal, v), N_DOT_V_MIN, 1.0);
    surface.n_dot_l = clamp(dot(surface.normal, l), 0.0, 1.0);
    surface.n_dot_h = clamp(dot(surface.normal, h), 0.0, 1.0);
    surface.v_dot_h = clamp(dot(v, h), 0.0, 1.0);
    BrdfSurface s = brdf_surface(surface.albedo, surface.metallic, max(surface.roughness, ROUGHNESS_MIN));
#if FACET_SPECULAR
    vec4 specular = texelFetch(gbuffer_specular, ivec2(gl_FragCoord.xy), 0);
    s.dielectric_f0 = specular.rgb;
    s.specular = specular.a;
#endif
    vec4 albedo = textureLod(albedo_table, albedo_coordinates(surface.n_dot_v, s.roughness), 0.0);
    BrdfView seen = brdf_view(s, surface.n_dot_v, albedo);
    surface.brdf = brdf_terms(seen, surface.n_dot_l, surface.n_dot_h, surface.v_dot_h);
}
#endif

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
#if FACET_KEY_LIGHT
    add_key_light(surface);
#endif
    out_value = vec4(FACET_AOV, 1.0);
}
