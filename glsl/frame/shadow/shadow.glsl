// Share of a light that reaches a point, from maps of its depths. Included by shade.glsl.
//   Percentage-closer filtering (Reeves, Salesin & Cook 1987) over a disk as wide as the penumbra, which the mean depth of
//   what stands in the way gives: Fernando 2005, "Percentage-Closer Soft Shadows".
#include "lib/noise.glsl"

uniform sampler2D shadow_atlas;
// A texel a light: first texel of its views, how many, radius (of parallel light per metre), kind; then six texels a view: four
// columns of clip_from_world; its tile's corner, width, and width of a texel; near, far, share of its width that a metre fills.
uniform samplerBuffer shadow_views;

const float SHADOW_PARALLEL = 1.0;  // frame/shadow/shadow_views.h's ShadowKind
const float SHADOW_CUBE = 3.0;
const int SHADOW_VIEW_TEXELS = 6;
const int SHADOW_TAPS = 8;
const float SHADOW_SEARCH_MAX = 0.1;  // of the map's width

struct ShadowView {
    mat4 clip_from_world;
    vec4 tile;
    vec4 range;
};
ShadowView shadow_view(int texel) {
    return ShadowView(mat4(texelFetch(shadow_views, texel), texelFetch(shadow_views, texel + 1),
                           texelFetch(shadow_views, texel + 2), texelFetch(shadow_views, texel + 3)),
                      texelFetch(shadow_views, texel + 4), texelFetch(shadow_views, texel + 5));
}

// Metres along the map's axis.
float shadow_metres(ShadowView v, bool is_parallel, float depth) {
    return is_parallel ? mix(v.range.x, v.range.y, depth) : v.range.x * v.range.y / (v.range.y - depth * (v.range.y - v.range.x));
}
float shadow_depth_at(ShadowView v, vec2 uv) {
    vec2 inside = clamp(uv, 0.5 * v.tile.w, 1.0 - 0.5 * v.tile.w);
    return textureLod(shadow_atlas, v.tile.xy + inside * v.tile.z, 0.0).r;
}

// An even spread over the unit disk (Vogel 1979), another for every pixel and sample.
vec2 shadow_tap(int i, float turn) {
    float radius = sqrt((float(i) + 0.5) / float(SHADOW_TAPS));
    float angle = float(i) * 2.3999632 + turn;
    return radius * vec2(cos(angle), sin(angle));
}

// light: in the packed order. from_light: metres, from its middle. n_dot_l: of the surface.
float shadow_share(int light, vec3 position_m, vec3 normal, vec3 from_light, float n_dot_l) {
    vec4 caster = texelFetch(shadow_views, light);
    if (caster.y < 0.5) return 1.0;
    bool is_parallel = caster.w == SHADOW_PARALLEL;
    vec3 size = abs(from_light);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    int face = axis * 2 + (from_light[axis] < 0.0 ? 1 : 0);
    int texel = int(caster.x) + (caster.w == SHADOW_CUBE ? face * SHADOW_VIEW_TEXELS : 0);
    ShadowView v = shadow_view(texel);
    if (is_parallel)
        for (int i = 1; i < int(caster.y); ++i) {
            vec2 at = abs((v.clip_from_world * vec4(position_m, 1.0)).xy);
            if (max(at.x, at.y) > 0.96) v = shadow_view(texel + i * SHADOW_VIEW_TEXELS);
        }
    // Off the surface by a texel and a half: its own depths are no shadow (acne).
    float distance_m = is_parallel ? 1.0 : (v.clip_from_world * vec4(position_m, 1.0)).w;
    float texel_m = v.tile.w * distance_m / v.range.z;
    float sine = sqrt(max(1.0 - n_dot_l * n_dot_l, 0.0));
    vec4 clip = v.clip_from_world * vec4(position_m + normal * (texel_m * (0.5 + 1.5 * sine)), 1.0);
    vec3 at = clip.xyz / clip.w * 0.5 + 0.5;
    if (clip.w <= 0.0 || any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
    float own_m = shadow_metres(v, is_parallel, at.z);
    float per_m = is_parallel ? v.range.z : v.range.z / own_m;  // share of the width, at the surface
    float turn = 6.2831853 * pixel_noise(gl_FragCoord.xy, view.pixel.z);
    // What lies before a surface that is seen at a slant rises with the distance from the middle.
    float slope = min(sine / max(n_dot_l, 0.05), 5.0);
    float filter_width = v.tile.w;
    if (caster.z > 0.0) {
        float search = min(is_parallel ? caster.z * (own_m - v.range.x) * per_m : caster.z * per_m, SHADOW_SEARCH_MAX);
        float sum_m = 0.0;
        float count = 0.0;
        for (int i = 0; i < SHADOW_TAPS; ++i) {
            vec2 tap = shadow_tap(i, turn) * search;
            float depth_m = shadow_metres(v, is_parallel, shadow_depth_at(v, at.xy + tap));
            if (depth_m < own_m - (length(tap) / per_m) * slope - texel_m) {
                sum_m += depth_m;
                count += 1.0;
            }
        }
        float blocker_m = sum_m / max(count, 1.0);
        float penumbra_m = caster.z * (own_m - blocker_m) / (is_parallel ? 1.0 : max(blocker_m, 1e-6));
        if (count > 0.0) filter_width = clamp(penumbra_m * per_m, v.tile.w, SHADOW_SEARCH_MAX);
    }
    float lit = 0.0;
    for (int i = 0; i < SHADOW_TAPS; ++i) {
        vec2 tap = shadow_tap(i, turn + 1.0) * filter_width;
        float depth_m = shadow_metres(v, is_parallel, shadow_depth_at(v, at.xy + tap));
        lit += depth_m < own_m - (length(tap) / per_m) * slope - 0.5 * texel_m ? 0.0 : 1.0;
    }
    return lit / float(SHADOW_TAPS);
}
