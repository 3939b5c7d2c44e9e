// Light on one surface point: every light, and the environment. Used by the lighting pass and the blend pass.
#include "generated/brdf.glsl"
#include "lib/shading_bounds.glsl"
#include "lib/surface.glsl"
#include "light/directional.glsl"
#include "light/point.glsl"
#include "light/spot.glsl"

uniform samplerCube radiance_cube;   // prefiltered; see frame/environment/bake.h
uniform samplerCube irradiance_cube;  // over pi
uniform sampler2D albedo_table;      // A, B of the split sum and average E; see brdf/albedo.h
uniform samplerBuffer lights;        // LIGHT_TEXELS a light, see frame/lighting/light_lists.h
const int LIGHT_TEXELS = 5;
#if FACET_LIGHT_PROFILES
#include "frame/lighting/profile.glsl"
#endif
#if FACET_LOCAL_LIGHTS
uniform usamplerBuffer light_tiles;    // first, and how many: without a size, and above 16 bits with one
uniform usamplerBuffer light_indices;
#endif

#if FACET_VISIBILITY
uniform samplerBuffer light_visibility;  // [slot, pixel]: rgb share of a light that arrives, by its place in the tile's list
#endif
#if FACET_INDIRECT
#include "frame/lighting/indirect.glsl"
#endif
#if FACET_SHADOW_MAPS
#include "frame/shadow/shadow.glsl"
#endif
#if FACET_OCCLUSION
#include "frame/occlusion/occlusion.glsl"
#endif

struct ShadePoint {
    vec3 position_m;
    vec3 to_eye;
    Surface surface;
};
#include "frame/lighting/layers.glsl"

// A tile is this many pixels wide and high; frame/lighting/light_lists.h has the same number.
const uint TILE_PX = 16u;

#if FACET_LIGHT_PATHS
#include "frame/lighting/light_paths.glsl"
#endif

#include "frame/lighting/environment.glsl"
#include "frame/lighting/far_side.glsl"

#if FACET_LIGHT_PATHS
bool is_environments = false;  // the light at hand is the environment's sun
#endif

#ifdef FACET_EXPLAIN
float explain_distance_m = 0.0;  // to the light at hand; 0: infinitely far
#endif

// visible: share of the light that arrives; has_size: mirrors show it.
vec3 lit_by(ShadePoint p, BrdfView brdf, vec3 to_light, vec3 illuminance, vec3 visible, bool has_size) {
    float n_dot_l = clamp(dot(p.surface.normal, to_light), 0.0, 1.0);
    vec3 sum = p.to_eye + to_light;
    vec3 h = sum * inversesqrt(max(dot(sum, sum), 1e-12));
    float n_dot_h = clamp(dot(p.surface.normal, h), 0.0, 1.0);
    float v_dot_h = clamp(dot(p.to_eye, h), 0.0, 1.0);
    float e_l = 1.0;
#if FACET_BRDF_NEEDS_E_L
    vec2 at = albedo_coordinates(n_dot_l, max(p.surface.roughness, ROUGHNESS_MIN));
    vec2 a_b = textureLod(albedo_table, at, 0.0).xy;
    e_l = a_b.x + a_b.y;
#endif
#if FACET_ANISOTROPY
    BrdfValue f = brdf_light_of(brdf, stretched_d_v(p, to_light, h, brdf), n_dot_l, v_dot_h, e_l);
#else
    BrdfValue f = brdf_light(brdf, n_dot_l, n_dot_h, v_dot_h, e_l);
#endif
    float mirrored = has_size || p.surface.roughness >= MIRROR_ROUGHNESS ? 1.0 : 0.0;
    f.specular *= mirrored;
    f = layered(f, to_light, h, brdf.n_dot_v, n_dot_l, n_dot_h, v_dot_h, has_size);
#ifdef FACET_EXPLAIN
    BrdfTerms terms = brdf_terms(brdf, n_dot_l, n_dot_h, v_dot_h);
    float v = slot_masking(brdf.n_dot_v, n_dot_l, brdf.surface.roughness, brdf.surface.alpha);
    explain_lit(ExplainedLight(uvec4(0u), vec4(to_light, explain_distance_m), vec4(illuminance, 0.0),
                               vec4(n_dot_l, n_dot_h, v_dot_h, dot(visible, vec3(0.2126, 0.7152, 0.0722))), vec4(terms.d * mirrored, terms.g, v, 0.0),
                               vec4(terms.f, 0.0), vec4(terms.k_d, 0.0), vec4(terms.k_s, 0.0),
                               vec4(f.diffuse, 0.0), vec4(f.specular, 0.0)));
#endif
    vec3 arriving = illuminance * (visible * n_dot_l);
#if FACET_LIGHT_PATHS
    if (is_environments) {
        paths.diffuse_indirect += f.diffuse * arriving;
        paths.specular_indirect += f.specular * arriving;
    } else {
        paths.diffuse_direct += f.diffuse * arriving;
        paths.specular_direct += f.specular * arriving;
    }
#endif
    return (f.diffuse + f.specular) * arriving + far_light(p, brdf, to_light, illuminance);
}

#if FACET_AREA_LIGHTS
#include "frame/lighting/area.glsl"
#endif

// Share of a light that reaches this pixel: of its rays, by its place in the tile's list (those that there was no room for are
// taken to be lit), or by its map. light: in the packed order; from_light: metres, from its middle.
vec3 light_visible(uint slot, int light, ShadePoint p, vec3 from_light) {
#if FACET_SHADOW_MAPS
    float n_dot_l = -dot(p.surface.normal, from_light) * inversesqrt(max(dot(from_light, from_light), 1e-20));
    return vec3(shadow_share(light, p.position_m, p.surface.normal, from_light, clamp(n_dot_l, 0.0, 1.0)));
#elif FACET_VISIBILITY
    if (slot >= view.rays.y) return vec3(1.0);
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return texelFetch(light_visibility, int(slot * view.rays.x + pixel.y * view.rays.z + pixel.x)).rgb;
#else
    return vec3(1.0);
#endif
}

#if FACET_LOCAL_LIGHTS
struct LocalLight {
    int texel;  // its first
    vec4 place;
    vec4 color;
    vec3 way;   // unit, to its middle
    float distance2;
};
// `index`: in the lists.
LocalLight local_light(uint index, vec3 position_m) {
    LocalLight light;
    light.texel = int(texelFetch(light_indices, int(index)).x) * LIGHT_TEXELS;
    light.place = texelFetch(lights, light.texel);
    light.color = texelFetch(lights, light.texel + 1);
    light.way = light.place.xyz - position_m;
    light.distance2 = dot(light.way, light.way);
    light.way *= inversesqrt(max(light.distance2, 1e-12));
#ifdef FACET_EXPLAIN
    explain_light = uint(light.texel / LIGHT_TEXELS);
    explain_distance_m = sqrt(light.distance2);
#endif
    return light;
}
// The next place in the lists, from `index` on, whose light reaches so far; `end` where none does.
uint next_light(uint index, uint end, vec3 position_m) {
#ifndef FACET_EXPLAIN  // which tells of all
    while (index < end) {
        vec4 place = texelFetch(lights, int(texelFetch(light_indices, int(index)).x) * LIGHT_TEXELS);
        vec3 way = place.xyz - position_m;
        if (dot(way, way) * place.w < 1.0) break;
        ++index;
    }
#endif
    return index;
}
#endif

vec3 shade(ShadePoint p) {
    float n_dot_v = clamp(dot(p.surface.normal, p.to_eye), N_DOT_V_MIN, 1.0);
    BrdfSurface surface = brdf_surface(p.surface.base_color, p.surface.metallic, max(p.surface.roughness, ROUGHNESS_MIN));
#if FACET_SPECULAR
    surface.dielectric_f0 = p.surface.dielectric_f0;
    surface.specular = p.surface.specular;
#endif
    vec2 seen = vec2(n_dot_v, surface.roughness);
#if FACET_ANISOTROPY
    seen = anisotropic_view(stretched_frame(p) * p.to_eye, anisotropic_alpha(surface.alpha, p.surface.anisotropy));
#endif
#if FACET_FRESNEL_RAMP_TEXTURE
    float ramp_half_texel = 0.5 / float(textureSize(fresnel_ramp_texture, 0).x);
    vec2 ramp_at = vec2(clamp(n_dot_v, ramp_half_texel, 1.0 - ramp_half_texel), 0.5);
    vec3 ramp = textureLod(fresnel_ramp_texture, ramp_at, 0.0).rgb;
    surface.dielectric_f0 = f0_of_reflectance(ramp, surface.dielectric_f0, n_dot_v);
    surface.metal_f0 = f0_of_reflectance(ramp, surface.metal_f0, n_dot_v);
#endif
#if FACET_IRIDESCENCE
    surface.dielectric_f0 = thin_film_f0(surface.dielectric_f0, p.surface.film, p.surface.film_ior, p.surface.film_nm, n_dot_v);
    surface.metal_f0 = thin_film_f0(surface.metal_f0, p.surface.film, p.surface.film_ior, p.surface.film_nm, n_dot_v);
#endif
#if FACET_TRANSMISSION
    surface.diffuse *= 1.0 - p.surface.transmission;
#endif
#if FACET_DIFFUSE_TRANSMISSION
    if (is_deep(p))
        surface.base_color = mix(surface.base_color, p.surface.far_color * p.surface.scattered, p.surface.far_share);
    else
        surface.diffuse *= 1.0 - p.surface.far_share;
#endif
    vec4 albedo = textureLod(albedo_table, albedo_coordinates(seen.x, seen.y), 0.0);
    BrdfView brdf = brdf_view(surface, n_dot_v, albedo);
    set_layers(p, n_dot_v);

    vec3 radiance = vec3(0.0);
#ifdef FACET_EXPLAIN
    explained.position.xyz = p.position_m;
    explained.normal = vec4(p.surface.normal, n_dot_v);
    explained.to_eye = vec4(p.to_eye, 0.0);
    explained.albedo = albedo;
    explained.base_color.rgb = surface.base_color;
    explained.numbers = vec4(p.surface.metallic, p.surface.roughness, p.surface.ao, surface.roughness);
    BrdfValue balance = below_layers(brdf_environment(brdf));
    balance.specular += coat_albedo();
    explained.environment_diffuse = vec4(balance.diffuse, 0.0);
    explained.environment_specular = vec4(balance.specular, 0.0);
#endif
#if FACET_INDIRECT
    BrdfValue w = below_layers(brdf_environment(brdf));
    IndirectLight found = indirect_light(p.position_m, p.surface.normal);
#if FACET_CLEARCOAT
    found.specular = with_coat(w, found.specular, found.coat);
#endif
    vec3 arriving = found.rest;
#if FACET_ENVIRONMENT
    arriving += irradiance_over_pi(p.surface.normal) * found.sky;
#endif
    radiance = w.diffuse * arriving + w.specular * found.specular;
#ifdef FACET_EXPLAIN
    explained.numbers.z = 1.0;  // rays find what is occluded
    explained.irradiance = vec4(arriving, 0.0);
    explained.prefiltered = vec4(found.specular, 0.0);
#endif
#if FACET_LIGHT_PATHS
    paths.diffuse_indirect = w.diffuse * arriving;
    paths.specular_indirect = w.specular * found.specular;
#endif
#elif FACET_ENVIRONMENT
    BrdfValue w = below_layers(brdf_environment(brdf));
#if FACET_OCCLUSION
    vec4 occlusion = texelFetch(ambient_occlusion, ivec2(gl_FragCoord.xy), 0);
    occlusion.w = min(occlusion.w, p.surface.ao);
    float ao = 1.0;
#else
    vec4 occlusion = vec4(p.surface.normal, 1.0);
    float ao = p.surface.ao;
#endif
    vec3 prefiltered = mirrored_environment(p, mirroring_normal(p), p.surface.roughness, w, occlusion);
#if FACET_CLEARCOAT
    vec3 on_coat = mirrored_environment(p, p.surface.coat_normal, p.surface.coat_roughness, w, occlusion);
    prefiltered = with_coat(w, prefiltered, on_coat);
#endif
    vec3 irradiance = irradiance_over_pi(occlusion.xyz);
#if FACET_OCCLUSION
    irradiance *= with_bounces(occlusion.w, w.diffuse);
#endif
    radiance = (w.diffuse * irradiance + w.specular * prefiltered) * ao;
#ifdef FACET_EXPLAIN
    explained.numbers.z = ao;
    explained.irradiance = vec4(irradiance, 0.0);
    explained.prefiltered = vec4(prefiltered, p.surface.roughness * view.environment.x);
#endif
#if FACET_LIGHT_PATHS
    paths.diffuse_indirect = w.diffuse * irradiance * ao;
    paths.specular_indirect = w.specular * prefiltered * ao;
#endif
#endif
#if FACET_FAR_SIDE
    vec3 far = far_around(p, brdf);
    radiance += far;
#if FACET_LIGHT_PATHS
    BrdfValue far_share = far_weight(p, brdf);
    vec3 far_diffuse = far * far_share.diffuse / max(far_share.diffuse + far_share.specular, vec3(1e-20));
    paths.diffuse_indirect += far_diffuse;
    paths.specular_indirect += far - far_diffuse;
#endif
#ifdef FACET_EXPLAIN
    explained.far_nit = vec4(far, 0.0);
    BrdfValue through = far_weight(p, brdf);
    explained.far_weight = vec4(through.diffuse + through.specular, 0.0);
#endif
#endif
    for (uint i = 0u; i < view.light_counts.x; ++i) {
        int texel = int(i) * LIGHT_TEXELS;
        vec3 intensity_lux = texelFetch(lights, texel + 1).rgb;
        vec3 direction = texelFetch(lights, texel + 2).xyz;
        bool is_sun = texelFetch(lights, texel + 3).w < 0.0;  // the environment's, which is as wide as it is
#if FACET_LIGHT_PATHS
        is_environments = is_sun;
#endif
#ifdef FACET_EXPLAIN
        explain_light = i;
#endif
        radiance += lit_by(p, brdf, -direction, light_directional(intensity_lux), light_visible(i, int(i), p, direction),
                           is_sun);
    }
#if FACET_LOCAL_LIGHTS
#if FACET_LIGHT_PATHS
    is_environments = false;
#endif
    // A software renderer works on both sides of a branch, and on all pixels of a group until the last is done: lights of a
    // kind have a loop of their own, and each pixel looks for the next light that reaches it before they work on theirs.
    uvec2 tile = uvec2(gl_FragCoord.xy) / TILE_PX;
    uvec2 list = texelFetch(light_tiles, int(tile.y * view.light_counts.z + tile.x)).xy;
    uint end = list.x + (list.y & 0xFFFFu);
    uint i = next_light(list.x, end, p.position_m);
    while (i < end) {
        LocalLight light = local_light(i, p.position_m);
        vec4 direction_offset = texelFetch(lights, light.texel + 2);
        float cone = light_spot(-dot(light.way, direction_offset.xyz), light.color.w, direction_offset.w);
        vec3 illuminance = light_point(light.color.rgb, light.distance2, light.place.w) * cone;
#if FACET_LIGHT_PROFILES
        illuminance *= profile_share(light.texel, -light.way, direction_offset.xyz);
#endif
        radiance += lit_by(p, brdf, light.way, illuminance,
                           light_visible(view.light_counts.x + i - list.x, light.texel / LIGHT_TEXELS, p, p.position_m - light.place.xyz),
                           false);
        i = next_light(i + 1u, end, p.position_m);
    }
#if FACET_AREA_LIGHTS
    AreaView area_point = area_view(p.to_eye, p.surface.normal, p.surface.roughness, n_dot_v);
    BrdfValue area_weight = below_layers(brdf_environment(brdf));
#if FACET_CLEARCOAT
    AreaView coat_area = area_view(p.to_eye, p.surface.coat_normal, p.surface.coat_roughness, coat.brdf.n_dot_v);
    BrdfValue coat_weight = BrdfValue(vec3(0.0), vec3(coat.brdf.albedo));
#endif
    uint area_end = end + (list.y >> 16u);
    i = next_light(end, area_end, p.position_m);
    while (i < area_end) {
        LocalLight light = local_light(i, p.position_m);
        vec4 x_kind = texelFetch(lights, light.texel + 3);
        vec3 half_y = texelFetch(lights, light.texel + 4).xyz;
        SeenArea area = seen_area(x_kind.w, light.place.xyz - p.position_m, x_kind.xyz, half_y);
        vec3 nit = light.color.rgb * light_window(light.distance2, light.place.w);
#if FACET_SHADOW_MAPS
        nit *= light_visible(0u, light.texel / LIGHT_TEXELS, p, p.position_m - light.place.xyz);
#endif
        radiance += lit_by_area(area_point, area_weight, area, nit);
#if FACET_CLEARCOAT
        radiance += lit_by_area(coat_area, coat_weight, area, nit);
#endif
        i = next_light(i + 1u, area_end, p.position_m);
    }
#endif
#endif
    return radiance;
}
