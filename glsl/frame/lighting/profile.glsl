// How bright a lamp with a profile is by direction. Included by shade.glsl.
#include "light/profile.glsl"

uniform samplerBuffer light_profiles;  // [profile, row, column], share of the brightest direction; scene/light_profile.h
const int PROFILE_ROWS = 361;
const int PROFILE_COLUMNS = 73;

// texel: the light's first. direction: unit, from the lamp; ahead: where it shines to. 1 for lights without a profile.
float profile_share(int texel, vec3 direction, vec3 ahead) {
    vec4 x_kind = texelFetch(lights, texel + 3);
    vec3 y = texelFetch(lights, texel + 4).xyz;
    vec2 place = profile_place(direction, x_kind.xyz, y, ahead) * vec2(PROFILE_ROWS - 1, PROFILE_COLUMNS - 1);
    ivec2 low = clamp(ivec2(place), ivec2(0), ivec2(PROFILE_ROWS - 2, PROFILE_COLUMNS - 2));
    vec2 on = place - vec2(low);
    int first = ((max(int(x_kind.w), 1) - 1) * PROFILE_ROWS + low.x) * PROFILE_COLUMNS + low.y;
    float a = mix(texelFetch(light_profiles, first).r, texelFetch(light_profiles, first + 1).r, on.y);
    int next = first + PROFILE_COLUMNS;
    float b = mix(texelFetch(light_profiles, next).r, texelFetch(light_profiles, next + 1).r, on.y);
    return x_kind.w < 0.5 ? 1.0 : mix(a, b, on.x);
}
