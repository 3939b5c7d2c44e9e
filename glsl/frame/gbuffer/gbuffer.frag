// The G-buffer: albedo, normal, metallic, roughness, AO; emission and ids where the frame asks for them.
#include "shared/draw.h"
layout(std140) uniform DrawBlock { Draw draw; };
#ifdef FACET_EXPLAIN
#include "frame/explain/explain.glsl"
#endif
#include "lib/octahedral.glsl"
#include "lib/material.glsl"

layout(location = 0) out vec4 out_albedo;         // RGBA16: linear Rec.709; a: 1 where unlit
layout(location = 1) out vec2 out_normal;         // RG16: octahedral, world space
layout(location = 2) out vec4 out_metal_rough_ao; // RGBA8: metallic, roughness, AO, unused
#if FACET_EMISSIVE_TARGET
layout(location = 3) out vec4 out_emissive_nit;   // RGBA32F
#endif
#if FACET_SPECULAR_TARGET
layout(location = FACET_SPECULAR_LOCATION) out vec4 out_specular;  // RGBA16: F0 of dielectrics; a: strength
#endif
#if FACET_ID_TARGET
layout(location = FACET_ID_LOCATION) out uvec2 out_ids;  // RG32UI: object, material; 0 is the background
#endif
#if FACET_TRIANGLE_TARGET
layout(location = FACET_TRIANGLE_LOCATION) out uvec2 out_triangle;  // RG32UI: index of the draw, of its triangle
#endif

void main() {
    Surface s = fetch_surface();
#if FACET_ALPHA_MASK
    if (s.opacity < draw.emissive_nit_cutoff.w) discard;
#endif
#ifdef FACET_EXPLAIN
    explain_begin(EXPLAIN_GBUFFER, draw.ids.w, uint(gl_PrimitiveID));
    explain_surface(s);
    explain_end();
#endif
    out_albedo = vec4(s.base_color, float(draw.ids.z));
    out_normal = octahedral_from_unit(s.normal);
    out_metal_rough_ao = vec4(s.metallic, s.roughness, s.ao, 1.0);
#if FACET_EMISSIVE_TARGET
    out_emissive_nit = vec4(s.emissive_nit, 1.0);
#endif
#if FACET_SPECULAR_TARGET
#if FACET_SPECULAR
    out_specular = vec4(s.dielectric_f0, s.specular);
#else
    out_specular = draw.dielectric_f0_specular;  // a plain dielectric's
#endif
#endif
#if FACET_ID_TARGET
    out_ids = draw.ids.xy;
#endif
#if FACET_TRIANGLE_TARGET
    out_triangle = uvec2(draw.ids.w, uint(gl_PrimitiveID));
#endif
}
