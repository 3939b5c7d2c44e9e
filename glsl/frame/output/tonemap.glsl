// Tone curves: exposed linear Rec.709 >= 0 to display-linear Rec.709 in [0, 1]. FACET_TONEMAP chooses one.
// `brightest` above 1 is a screen that shows more than white; the curves that are made for paper white stay below 1.

// Khronos PBR Neutral (Khronos 2024, "PBR Neutral Tone Mapper specification", version 1.0): keeps base
// colours below 0.8 as they are, compresses highlights towards white.
vec3 tone_map_pbr_neutral(vec3 color, float brightest) {
    const float START = 0.8 - 0.04;  // start of compression, less the Fresnel offset F90 = 0.04
    const float DESATURATION = 0.15;
    float x = min(color.r, min(color.g, color.b));
    float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    color -= offset;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < START) return color;
    float d = brightest - START;
    float new_peak = brightest - d * d / (peak + d - START);
    color *= new_peak / peak;
    float g = 1.0 - 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    return mix(color, vec3(new_peak), g);
}

// Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", Eq. 3, on luminance.
vec3 tone_map_reinhard(vec3 color) {
    float y = dot(color, vec3(0.2126, 0.7152, 0.0722));
    return color / (1.0 + y);
}

// ACES RRT and sRGB ODT, fitted by Hill (2017, in BakingLab): Rec.709 to RRT_SAT, rational fit, ODT_SAT to Rec.709.
vec3 tone_map_aces(vec3 color) {
    const mat3 RRT = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const mat3 ODT = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    vec3 v = RRT * color;
    vec3 a = v * (v + 0.0245786) - 0.000090537;
    vec3 b = v * (0.983729 * v + 0.4329510) + 0.238081;
    return ODT * (a / b);
}

// AgX (Sobotka 2023), with the sixth-order polynomial for its curve by Wrensch (2023, "Minimal AgX
// Implementation"); the last power undoes the curve's display encoding, 2.2.
vec3 tone_map_agx(vec3 color) {
    const mat3 INSET = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336,
                            0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const mat3 OUTSET = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                             -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                             -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    const float MIN_EV = -12.47393;
    const float MAX_EV = 4.026069;
    vec3 x = clamp(log2(max(INSET * color, vec3(1e-10))), MIN_EV, MAX_EV);
    x = (x - MIN_EV) / (MAX_EV - MIN_EV);
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 curve = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
    return pow(max(OUTSET * curve, vec3(0.0)), vec3(2.2));
}

vec3 tone_map(vec3 color, float brightest) {
#if FACET_TONEMAP == 0
    return tone_map_pbr_neutral(color, brightest);
#elif FACET_TONEMAP == 1
    return tone_map_agx(color);
#elif FACET_TONEMAP == 2
    return tone_map_aces(color);
#elif FACET_TONEMAP == 3
    return tone_map_reinhard(color);
#else
    return color;
#endif
}
