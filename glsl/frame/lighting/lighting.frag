// Lighting: G-buffer to radiance. Drawn at the far plane with depth GREATER, so the background costs nothing.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
#ifdef FACET_EXPLAIN
#include "frame/explain/explain.glsl"
#endif
#include "lib/octahedral.glsl"
#include "lib/spaces.glsl"
#include "frame/lighting/shade.glsl"

uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_metal_rough_ao;
uniform sampler2D gbuffer_depth;
#if FACET_EMISSIVE_TARGET
uniform sampler2D gbuffer_emissive;
#endif
#if FACET_SPECULAR
uniform sampler2D gbuffer_specular;
#endif

#if FACET_LIGHT_PATHS
FACET_PATH_OUTPUTS
#else
layout(location = 0) out vec4 out_radiance;  // nit, linear Rec.709; a: coverage
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec3 metal_rough_ao = texelFetch(gbuffer_metal_rough_ao, pixel, 0).rgb;
    float depth = texelFetch(gbuffer_depth, pixel, 0).r;

    ShadePoint p;
    p.position_m = world_from_depth(view.world_from_clip, gl_FragCoord.xy * view.size_px.zw, depth);
    p.surface.normal = unit_from_octahedral(texelFetch(gbuffer_normal, pixel, 0).rg);
    p.to_eye = view.eye_m.w > 0.5 ? normalize(view.eye_m.xyz - p.position_m) : -view.forward.xyz;
    p.surface.base_color = albedo.rgb;
    p.surface.metallic = metal_rough_ao.r;
    p.surface.roughness = metal_rough_ao.g;
    p.surface.ao = metal_rough_ao.b;
#if FACET_SPECULAR
    vec4 specular = texelFetch(gbuffer_specular, pixel, 0);
    p.surface.dielectric_f0 = specular.rgb;
    p.surface.specular = specular.a;
#endif
#ifdef FACET_EXPLAIN
    // Drawn at the far plane: what is no surface is tested away only after it has run.
    if (depth < 1.0) explain_begin(EXPLAIN_LIGHTING, 0u, 0u);
#endif

#if FACET_LIGHT_PATHS
    shade(p);
    vec3 emissive_nit = vec3(0.0);
#if FACET_EMISSIVE_TARGET
    emissive_nit = texelFetch(gbuffer_emissive, pixel, 0).rgb;
#endif
    add_emission(p.surface.base_color, albedo.a, emissive_nit);
    FACET_WRITE_PATHS(1.0)
#else
    // albedo.a is 1 where KHR_materials_unlit asks for the base colour itself.
    vec3 radiance = mix(shade(p), p.surface.base_color, albedo.a);
#if FACET_EMISSIVE_TARGET
    radiance += texelFetch(gbuffer_emissive, pixel, 0).rgb;
#endif
    out_radiance = vec4(radiance, 1.0);
#ifdef FACET_EXPLAIN
    explained.position.w = depth;
    explained.radiance = vec4(radiance, 1.0);
    explain_end();
#endif
#endif
}
