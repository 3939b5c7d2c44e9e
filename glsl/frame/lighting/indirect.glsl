// Indirect light that rays found at some pixels (frame/rays), brought to this one from those of its own surface.
#include "lib/octahedral.glsl"
uniform sampler2D indirect_sky;       // rgb: share of the environment's irradiance; a: 0 where unknown
uniform sampler2D indirect_rest;      // rgb: other irradiance / pi, nit
uniform sampler2D indirect_specular;  // rgb: nit
uniform sampler2D indirect_guide;     // xyz: metres; w: normal, -1 where nothing is

#if FACET_SAMPLE_LIGHT
uniform sampler2D sample_diffuse;   // rgb: irradiance / pi at this very sample, nit; a: 1 where it is there
uniform sampler2D sample_specular;  // rgb: nit; likewise, 2 where it is the coat's
#endif

struct IndirectLight {
    vec3 sky;
    vec3 rest;
    vec3 specular;
    vec3 coat;  // of its own lobe, where that was drawn apart
};

vec3 guide_normal(float packed_normal) {
    float x = floor(packed_normal / 4096.0);
    return unit_from_octahedral(vec2(x, packed_normal - x * 4096.0) / 4095.0);
}

// position_m, normal: of the surface at this fragment.
IndirectLight indirect_light(vec3 position_m, vec3 normal) {
    float stride = float(view.rays.w);
    vec4 middle = view.middle_from_world * vec4(position_m, 1.0);
    vec2 at = (middle.xy / middle.w * 0.5 + 0.5) * view.size_px.xy / stride - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 part = at - vec2(low);
    ivec2 last = textureSize(indirect_guide, 0) - 1;
    float depth_m = dot(position_m - view.eye_m.xyz, view.forward.xyz);
    float per_metre = 1.0 / (stride * (view.pixel.x + view.pixel.y * depth_m));
    vec4 sky = vec4(0.0);
    vec3 rest = vec3(0.0);
    vec4 specular = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 tap = clamp(low + corner, ivec2(0), last);
        vec4 guide = texelFetch(indirect_guide, tap, 0);
        vec2 near = mix(1.0 - part, part, vec2(corner)) + 0.02;
        vec3 n = guide_normal(max(guide.w, 0.0));
        float off = max(abs(dot(guide.xyz - position_m, normal)), abs(dot(guide.xyz - position_m, n))) * per_metre;
        float turned = 1.0 - dot(n, normal);
        float weight = near.x * near.y / ((1.0 + off * off * off * off) * (1.0 + 100.0 * turned * turned));
        weight = guide.w < 0.0 ? 0.0 : weight + 1e-6;
        vec4 share = texelFetch(indirect_sky, tap, 0);
        sky += vec4(share.rgb, 1.0) * (share.a * weight);
        rest += texelFetch(indirect_rest, tap, 0).rgb * (share.a * weight);
        specular += vec4(texelFetch(indirect_specular, tap, 0).rgb, 1.0) * weight;
    }
    IndirectLight light;
    light.sky = sky.a > 0.0 ? sky.rgb / sky.a : vec3(1.0);
    light.rest = sky.a > 0.0 ? rest / sky.a : vec3(0.0);
    light.specular = specular.rgb / max(specular.a, 1e-20);
    light.coat = light.specular;
#if FACET_SAMPLE_LIGHT
    vec4 diffuse = texelFetch(sample_diffuse, ivec2(gl_FragCoord.xy), 0);
    light.sky *= 1.0 - diffuse.a;
    light.rest = mix(light.rest, diffuse.rgb, diffuse.a);
    vec4 mirrored = texelFetch(sample_specular, ivec2(gl_FragCoord.xy), 0);
    bool of_coat = mirrored.a > 1.5;
    light.specular = mix(light.specular, mirrored.rgb, of_coat ? 0.0 : mirrored.a);
    light.coat = of_coat ? mirrored.rgb : light.specular;
#endif
    return light;
}
