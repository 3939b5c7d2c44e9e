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
uniform sampler2D transmission_texture;
uniform sampler2D thickness_texture;
uniform sampler2D diffuse_transmission_texture;
uniform sampler2D diffuse_transmission_color_texture;
uniform sampler2D anisotropy_texture;
uniform sampler2D iridescence_texture;
uniform sampler2D iridescence_thickness_texture;
uniform sampler2D fresnel_ramp_texture;

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

// bumps: width (alpha) of the highlight that bumps too fine to be seen make of a mirror (image/normal_mips.h). A lobe's alpha^2 is
// twice the variance of its facets' slopes along an axis (Beckmann; GGX's peak is as high), and those of facets and bumps add up:
// Olano & Baker 2010, Section 3; Tokuyoshi & Kaplanyan 2019, Section 3.
float with_bumps(float roughness, float bumps) {
    float alpha = roughness * roughness;
    return bumps > 0.0 ? sqrt(min(sqrt(alpha * alpha + bumps * bumps), 1.0)) : roughness;
}

// Returns what with_bumps() takes, for the roughness.
float fetch_normal(inout Surface s) {
    vec3 n = normalize(vertex_normal);
    float bumps = 0.0;
#if FACET_NORMAL_TEXTURE
    vec4 texel = texture(normal_texture, slot_uv(2));
    float scale = draw.metallic_roughness_normal_ao.z;
    n = mapped_normal(n, (texel.xy * 2.0 - 1.0) * scale);
    bumps = texel.a * abs(scale);
#endif
    s.normal = n * viewed_side();
    return bumps;
}

#if FACET_CLEARCOAT
void fetch_coat(inout Surface s) {
    vec3 n = normalize(vertex_normal);
#if FACET_CLEARCOAT_NORMAL_TEXTURE
    vec4 texel = texture(clearcoat_normal_texture, slot_uv(9));
    n = mapped_normal(n, (texel.xy * 2.0 - 1.0) * draw.coat.z);
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
#if FACET_CLEARCOAT_NORMAL_TEXTURE
    s.coat_roughness = with_bumps(s.coat_roughness, texel.a * abs(draw.coat.z));
#endif
}
#endif

#if FACET_TRANSMISSION
void fetch_transmission(inout Surface s) {
    s.transmission = draw.transmission.x;
#if FACET_TRANSMISSION_TEXTURE
    s.transmission *= texture(transmission_texture, slot_uv(12)).r;
#endif
    s.thickness_m = draw.transmission.y;
#if FACET_THICKNESS_TEXTURE
    s.thickness_m *= texture(thickness_texture, slot_uv(13)).g;
#endif
    s.ior = draw.transmission.z;
    s.absorbed_per_m = draw.absorbed_per_m.rgb;
}
#endif
#if FACET_DIFFUSE_TRANSMISSION
void fetch_diffuse_transmission(inout Surface s) {
    s.far_color = draw.diffuse_transmission.rgb;
    s.far_share = draw.diffuse_transmission.a;
    s.scattered = draw.scattered.rgb;
#if FACET_DIFFUSE_TRANSMISSION_TEXTURE
    s.far_share *= texture(diffuse_transmission_texture, slot_uv(14)).a;
#endif
#if FACET_DIFFUSE_TRANSMISSION_COLOR_TEXTURE
    s.far_color *= texture(diffuse_transmission_color_texture, slot_uv(15)).rgb;
#endif
}
#endif
#if FACET_ANISOTROPY
// The strength with which a lobe that bumps made wider is as wide along its direction as they make it (anisotropic_alpha).
float with_bumps_along(float strength, float roughness, float bumps) {
    float alpha = roughness * roughness;
    float along = alpha + (1.0 - alpha) * strength * strength;
    float wide = sqrt(alpha * alpha + bumps * bumps);
    float excess = sqrt(along * along + bumps * bumps) - wide;
    return bumps > 0.0 ? sqrt(clamp(excess / max(1.0 - wide, 1e-6), 0.0, 1.0)) : strength;
}

// After the normal, before its bumps are in the roughness.
void fetch_anisotropy(inout Surface s, float bumps) {
    vec2 way = draw.anisotropy.yz;
    s.anisotropy = draw.anisotropy.x;
#if FACET_ANISOTROPY_TEXTURE
    vec3 texel = texture(anisotropy_texture, slot_uv(16)).rgb;
    vec2 turn = texel.xy * 2.0 - 1.0;
    way = vec2(way.x * turn.x - way.y * turn.y, way.y * turn.x + way.x * turn.y);
    s.anisotropy *= texel.z;
#endif
    vec3 t = vertex_tangent.xyz - s.normal * dot(s.normal, vertex_tangent.xyz);
    vec3 along = t * way.x + cross(s.normal, t) * (vertex_tangent.w * viewed_side() * way.y);
    float along_length = length(along);
    s.tangent = along / max(along_length, 1e-6);
    s.anisotropy = along_length > 1e-6 ? with_bumps_along(s.anisotropy, s.roughness, bumps) : 0.0;
}
#endif
#if FACET_IRIDESCENCE
void fetch_film(inout Surface s) {
    s.film = draw.iridescence.x;
    s.film_ior = draw.iridescence.y;
    s.film_nm = draw.iridescence.w;
#if FACET_IRIDESCENCE_TEXTURE
    s.film *= texture(iridescence_texture, slot_uv(17)).r;
#endif
#if FACET_IRIDESCENCE_THICKNESS_TEXTURE
    s.film_nm = mix(draw.iridescence.z, draw.iridescence.w, texture(iridescence_thickness_texture, slot_uv(18)).g);
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
#if FACET_NORMAL_TEXTURE
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
    float bumps = fetch_normal(s);
#if FACET_CLEARCOAT
    fetch_coat(s);
#endif
#if FACET_TRANSMISSION
    fetch_transmission(s);
#endif
#if FACET_DIFFUSE_TRANSMISSION
    fetch_diffuse_transmission(s);
#endif
#if FACET_ANISOTROPY
    fetch_anisotropy(s, bumps);
#endif
    s.roughness = with_bumps(s.roughness, bumps);
#if FACET_IRIDESCENCE
    fetch_film(s);
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
