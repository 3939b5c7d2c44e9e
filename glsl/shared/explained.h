// What one shaded point tells of itself: std430, the same text for GLSL and C++. Written by shaders
// that are compiled with FACET_EXPLAIN (frame/explain/explain.glsl). SPDX-License-Identifier: MIT
struct ExplainedSurface {
    uvec4 which;        // index of the pixel asked for, stage, draw, primitive
    uvec4 ids;          // object, material, 1 where unlit, 1 where its front is seen
    vec4 position;      // xyz: metres; w: window depth
    vec4 normal;        // xyz: unit, world space; w: n.v
    vec4 base_color;    // rgb; a: opacity
    vec4 numbers;       // metallic, roughness, ao, roughness as lights see it
    vec4 emissive_nit;  // rgb
    vec4 base_texel;    // what the textures gave, 1 where there is none
    vec4 orm_texel;     // occlusion, roughness, metallic; a: 1 where occlusion has a texture
    vec4 normal_texel;  // as stored, 0..1
    vec4 emissive_texel;
    vec4 vertex_color;
    vec4 uv;                   // both sets
    vec4 to_eye;               // unit
    vec4 albedo;               // the table's texel at n.v
    vec4 irradiance;           // over pi, nit; before occlusion
    vec4 prefiltered;          // nit; before occlusion
    vec4 environment_diffuse;  // weights of the two
    vec4 environment_specular;
    vec4 coat;        // of layers: strength, roughness, albedo at n.v, unused; all 0 without
    vec4 sheen;       // albedo at n.v, rgb; roughness
    vec4 far_nit;     // rgb: light from the surface's far side,
    vec4 far_weight;  // and the factor on light from everywhere there
    vec4 radiance;    // what the surface shows in nit, before its opacity
};
struct ExplainedLight {
    uvec4 which;           // index of the surface's record, of the scene's light, unused
    vec4 to_light;         // unit; w: metres, 0 where it is infinitely far
    vec4 illuminance_lux;  // that arrives, facing the light
    vec4 cosines;          // n.l, n.h, v.h; w: share of the light that is visible
    vec4 d_g_v;            // D 1/sr, G, V 1/sr, unused
    vec4 f;
    vec4 k_d;
    vec4 k_s;
    vec4 diffuse;   // 1/sr
    vec4 specular;  // 1/sr
};
