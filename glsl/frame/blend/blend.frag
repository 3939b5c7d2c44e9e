// Alpha-blended surfaces, shaded forward and laid over what is there; associated alpha.
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
    ShadePoint p;
    p.position_m = vertex_position_m;
    p.normal = s.normal;
    p.to_eye = view.eye_m.w > 0.5 ? normalize(view.eye_m.xyz - vertex_position_m) : -view.forward.xyz;
    p.base_color = s.base_color;
    p.metallic = s.metallic;
    p.roughness = s.roughness;
    p.ao = s.ao;
#if FACET_SPECULAR
    p.dielectric_f0 = s.dielectric_f0;
    p.specular = s.specular;
#endif
#ifdef FACET_EXPLAIN
    explain_begin(EXPLAIN_BLEND, draw.ids.w, uint(gl_PrimitiveID));
    explain_surface(s);
#endif
#if FACET_LIGHT_PATHS
    shade(p);
    add_emission(s.base_color, float(draw.ids.z), s.emissive_nit);
    FACET_WRITE_PATHS(s.opacity)
#else
    vec3 radiance = mix(shade(p), s.base_color, float(draw.ids.z)) + s.emissive_nit;
    out_radiance = vec4(radiance * s.opacity, s.opacity);
#ifdef FACET_EXPLAIN
    explained.radiance = vec4(radiance, s.opacity);
    explain_end();
#endif
#endif
}
