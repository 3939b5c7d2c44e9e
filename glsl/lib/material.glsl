// From a fragment's interpolated values to the numbers the BRDF takes: textures times factors.
// Needs DrawBlock's `draw`, the outputs of gbuffer.vert and the FACET_ switches of frame/upload/material_key.h.
#include "lib/surface.glsl"

in vec3 vertex_normal;
#if FACET_TANGENTS
in vec4 vertex_tangent;
#endif
in vec2 vertex_uv0;
#if FACET_UV_GENERAL
in vec2 vertex_uv1;
#endif
#if FACET_VERTEX_COLOR
in vec4 vertex_color;
#endif

uniform sampler2D base_color_texture;
uniform sampler2D metallic_roughness_texture;
uniform sampler2D normal_texture;
uniform sampler2D occlusion_texture;
uniform sampler2D emissive_texture;
uniform sampler2D specular_texture;
uniform sampler2D specular_color_texture;
uniform sampler2D clearcoat_texture;
uniform sampler2D clearcoat_roughness_texture;
uniform sampler2D clearcoat_normal_texture;
uniform sampler2D sheen_color_texture;
uniform sampler2D sheen_roughness_texture;

vec2 slot_uv(int slot) {
#if FACET_UV_GENERAL
    vec4 row_u = draw.uv_rows[slot * 2];
    vec4 row_v = draw.uv_rows[slot * 2 + 1];
    vec3 uv = vec3(row_u.w > 0.5 ? vertex_uv1 : vertex_uv0, 1.0);
    return vec2(dot(row_u.xyz, uv), dot(row_v.xyz, uv));
#else
    return vertex_uv0;
#endif
}

#if FACET_TANGENTS
// xy: of a normal map, scaled; n: the mesh's normal.
vec3 mapped_normal(vec3 n, vec2 xy) {
    // z is rebuilt: exact for unit normals, and right for maps that store two channels only.
    float z = sqrt(max(1.0 - dot(xy, xy), 1e-4));
    vec3 t = vertex_tangent.xyz - n * dot(n, vertex_tangent.xyz);
    float t_length = length(t);
    if (t_length <= 1e-6) return n;
    t /= t_length;
    vec3 b = cross(n, t) * vertex_tangent.w;
    return normalize(t * xy.x + b * xy.y + n * z);
}
#endif

// The back of a double-sided surface is lit as its front is: the normal turns to the viewer.
float viewed_side() { return gl_FrontFacing ? 1.0 : -1.0; }

vec3 shading_normal() {
    vec3 n = normalize(vertex_normal);
#if FACET_NORMAL_MAP
    n = mapped_normal(n, (texture(normal_texture, slot_uv(2)).xy * 2.0 - 1.0) * draw.metallic_roughness_normal_ao.z);
#endif
    return n * viewed_side();
}

#if FACET_CLEARCOAT
void fetch_coat(inout Surface s) {
    vec3 n = normalize(vertex_normal);
#if FACET_CLEARCOAT_NORMAL_MAP
    n = mapped_normal(n, (texture(clearcoat_normal_texture, slot_uv(9)).xy * 2.0 - 1.0) * draw.coat.z);
#endif
    s.coat_normal = n * viewed_side();
    s.coat = draw.coat.x;
#if FACET_CLEARCOAT_TEXTURE
    s.coat *= texture(clearcoat_texture, slot_uv(7)).r;
#endif
    s.coat_roughness = draw.coat.y;
#if FACET_CLEARCOAT_ROUGHNESS_TEXTURE
    s.coat_roughness *= texture(clearcoat_roughness_texture, slot_uv(8)).g;
#endif
}
#endif

#ifdef FACET_EXPLAIN
// What fetch_surface made its surface of.
void explain_surface(Surface s) {
    explained.ids = uvec4(draw.ids.xyz, gl_FrontFacing ? 1u : 0u);
    explained.normal.xyz = s.normal;
    explained.base_color = vec4(s.base_color, s.opacity);
    explained.numbers = vec4(s.metallic, s.roughness, s.ao, 0.0);
    explained.emissive_nit = vec4(s.emissive_nit, 0.0);
    explained.base_texel = vec4(1.0);
    explained.orm_texel = vec4(1.0, 1.0, 1.0, 0.0);
    explained.normal_texel = vec4(0.5, 0.5, 1.0, 0.0);
    explained.emissive_texel = vec4(1.0);
    explained.vertex_color = vec4(1.0);
    explained.uv.xy = vertex_uv0;
#if FACET_UV_GENERAL
    explained.uv.zw = vertex_uv1;
#endif
#if FACET_VERTEX_COLOR
    explained.vertex_color = vertex_color;
#endif
#if FACET_BASE_COLOR_TEXTURE
    explained.base_texel = texture(base_color_texture, slot_uv(0));
#endif
#if FACET_METALLIC_ROUGHNESS_TEXTURE
    explained.orm_texel.gb = texture(metallic_roughness_texture, slot_uv(1)).gb;
#if FACET_OCCLUSION_PACKED
    explained.orm_texel.ra = vec2(texture(metallic_roughness_texture, slot_uv(1)).r, 1.0);
#endif
#endif
#if FACET_OCCLUSION_TEXTURE
    explained.orm_texel.ra = vec2(texture(occlusion_texture, slot_uv(3)).r, 1.0);
#endif
#if FACET_NORMAL_MAP
    explained.normal_texel = texture(normal_texture, slot_uv(2));
#endif
#if FACET_EMISSIVE_TEXTURE
    explained.emissive_texel = texture(emissive_texture, slot_uv(4));
#endif
}
#endif

Surface fetch_surface() {
    Surface s;
    vec4 base = draw.base_color_opacity;
#if FACET_VERTEX_COLOR
    base *= vertex_color;
#endif
#if FACET_BASE_COLOR_TEXTURE
    base *= texture(base_color_texture, slot_uv(0));
#endif
    s.base_color = base.rgb;
    s.opacity = base.a;
    s.metallic = draw.metallic_roughness_normal_ao.x;
    s.roughness = draw.metallic_roughness_normal_ao.y;
    s.ao = 1.0;
#if FACET_METALLIC_ROUGHNESS_TEXTURE
    vec3 orm = texture(metallic_roughness_texture, slot_uv(1)).rgb;
    s.metallic *= orm.b;
    s.roughness *= orm.g;
#if FACET_OCCLUSION_PACKED
    s.ao = mix(1.0, orm.r, draw.metallic_roughness_normal_ao.w);
#endif
#endif
#if FACET_OCCLUSION_TEXTURE
    s.ao = mix(1.0, texture(occlusion_texture, slot_uv(3)).r, draw.metallic_roughness_normal_ao.w);
#endif
    s.emissive_nit = draw.emissive_nit_cutoff.rgb;
#if FACET_EMISSIVE_TEXTURE
    s.emissive_nit *= texture(emissive_texture, slot_uv(4)).rgb;
#endif
#if FACET_SPECULAR
    s.dielectric_f0 = draw.dielectric_f0_specular.rgb;
    s.specular = draw.dielectric_f0_specular.a;
#if FACET_SPECULAR_COLOR_TEXTURE
    vec4 tint = texture(specular_color_texture, slot_uv(6));
    s.dielectric_f0 *= tint.rgb;
#if FACET_GLOSSINESS
    s.roughness = 1.0 - (1.0 - s.roughness) * tint.a;
#endif
#endif
    s.dielectric_f0 = min(s.dielectric_f0, vec3(1.0));
#if FACET_SPECULAR_TEXTURE
    s.specular *= texture(specular_texture, slot_uv(5)).a;
#endif
#endif
    s.normal = shading_normal();
#if FACET_CLEARCOAT
    fetch_coat(s);
#endif
#if FACET_SHEEN
    s.sheen_color = draw.sheen.rgb;
    s.sheen_roughness = draw.sheen.a;
#if FACET_SHEEN_COLOR_TEXTURE
    s.sheen_color *= texture(sheen_color_texture, slot_uv(10)).rgb;
#endif
#if FACET_SHEEN_ROUGHNESS_TEXTURE
    s.sheen_roughness *= texture(sheen_roughness_texture, slot_uv(11)).a;
#endif
#endif
    return s;
}
