// Surfaces that are shaded as they are drawn: blended ones, laid over what is there with associated alpha (FACET_BLEND), and
// those with layers that the G-buffer does not hold, in place of what lighting.frag made of them.
#include "shared/view.h"
#include "shared/draw.h"
layout(std140) uniform ViewBlock { View view; };
layout(std140) uniform DrawBlock { Draw draw; };
#ifdef FACET_EXPLAIN
#include "frame/explain/explain.glsl"
#endif
#include "lib/material.glsl"
#include "frame/lighting/shade.glsl"

in vec3 vertex_position_m;
#if FACET_LIGHT_PATHS
FACET_PATH_OUTPUTS
#else
layout(location = 0) out vec4 out_radiance;
#endif

void main() {
    Surface s = fetch_surface();
#if FACET_ALPHA_MASK
    if (s.opacity < draw.emissive_nit_cutoff.w) discard;
#endif
    float coverage = FACET_BLEND == 1 ? s.opacity : 1.0;
    ShadePoint p;
    p.position_m = vertex_position_m;
    p.to_eye = view.eye_m.w > 0.5 ? normalize(view.eye_m.xyz - vertex_position_m) : -view.forward.xyz;
    p.surface = s;
#ifdef FACET_EXPLAIN
    explain_begin(FACET_BLEND == 1 ? EXPLAIN_BLEND : EXPLAIN_LAYERS, draw.ids.w, uint(gl_PrimitiveID));
    explain_surface(s);
#endif
    vec3 lit = shade(p);
    vec3 emissive_nit = s.emissive_nit * (1.0 - coat_albedo());
#if FACET_LIGHT_PATHS
    add_emission(s.base_color, float(draw.ids.z), emissive_nit);
    FACET_WRITE_PATHS(coverage)
#else
    vec3 radiance = mix(lit, s.base_color, float(draw.ids.z)) + emissive_nit;
    out_radiance = vec4(radiance * coverage, coverage);
#ifdef FACET_EXPLAIN
    explained.emissive_nit.rgb = emissive_nit;
    explained.radiance = vec4(radiance, coverage);
    explain_end();
#endif
#endif
}
