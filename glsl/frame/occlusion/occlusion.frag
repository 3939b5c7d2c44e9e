// Ambient visibility from the depth buffer: how far up the horizon is around each surface.
//   Jimenez, Wu, Pesce & Jarabo 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion", Eqs. 5 to 11; the bent
//   normal as in Intel's XeGTAO (2021), Algorithm 2 of that paper. In world space, with slices through the eye.
#include "shared/view.h"
layout(std140) uniform ViewBlock { View view; };
#include "lib/noise.glsl"
#include "lib/octahedral.glsl"
#include "lib/spaces.glsl"

uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_depth;
layout(location = 0) out vec4 out_occlusion;  // xyz: bent normal, unit; w: visible share of a cosine

const int SLICES = 2;
const int STEPS = 5;
const float HALF_PI = 1.5707963;

// w: 1 where there is a surface.
vec4 place_at(vec2 at_px) {
    vec2 inside = clamp(at_px, vec2(0.5), view.size_px.xy - 0.5);
    float depth = texelFetch(gbuffer_depth, ivec2(inside), 0).r;
    vec3 place = world_from_depth(view.world_from_clip, (floor(inside) + 0.5) * view.size_px.zw, min(depth, 0.999999));
    return vec4(place, depth < 1.0 ? 1.0 : 0.0);
}

float horizon(vec3 position_m, vec3 to_eye, vec2 step_px, float start, float low, float radius_m) {
    float highest = low;
    for (int i = 0; i < STEPS; ++i) {
        float t = (float(i) + start) / float(STEPS);
        vec4 place = place_at(gl_FragCoord.xy + step_px * max(t * t * float(STEPS), 1.0 / max(length(step_px), 1e-3)));
        vec3 way = place.xyz - position_m;
        float far = dot(way, way);
        float cosine = dot(way, to_eye) * inversesqrt(max(far, 1e-20));
        // What is beyond the radius counts less and less.
        float share = place.w * clamp(2.0 - 2.0 * sqrt(far) / radius_m, 0.0, 1.0);
        highest = max(highest, mix(low, cosine, share));
    }
    return acos(clamp(highest, -1.0, 1.0));
}

void main() {
    float depth = texelFetch(gbuffer_depth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 p = world_from_depth(view.world_from_clip, gl_FragCoord.xy * view.size_px.zw, depth);
    vec3 n = unit_from_octahedral(texelFetch(gbuffer_normal, ivec2(gl_FragCoord.xy), 0).rg);
    vec3 to_eye = view.eye_m.w > 0.5 ? normalize(view.eye_m.xyz - p) : -view.forward.xyz;
    float radius_m = view.occlusion.x;
    float pixel_m = view.pixel.x + view.pixel.y * dot(p - view.eye_m.xyz, view.forward.xyz);
    float radius_px = clamp(radius_m / max(pixel_m, 1e-9), 2.0, 0.3 * view.size_px.y);
    float noise = pixel_noise(gl_FragCoord.xy, view.pixel.z);
    float noise2 = fract(noise * 7.13 + view.pixel.z * 0.7548777);
    float visible = 0.0;
    vec3 bent = vec3(0.0);
    for (int i = 0; i < SLICES; ++i) {
        float phi = (float(i) + noise) * (2.0 * HALF_PI / float(SLICES));
        vec2 across = vec2(cos(phi), sin(phi));
        vec3 aside = world_from_depth(view.world_from_clip, (gl_FragCoord.xy + across) * view.size_px.zw, depth) - p;
        vec3 in_slice = aside - to_eye * dot(aside, to_eye);
        in_slice *= inversesqrt(max(dot(in_slice, in_slice), 1e-20));
        vec3 axis = cross(in_slice, to_eye);
        vec3 projected = n - axis * dot(n, axis);
        float size = max(length(projected), 1e-4);
        float cos_n = clamp(dot(projected, to_eye) / size, -1.0, 1.0);
        float gamma = (dot(projected, in_slice) < 0.0 ? -1.0 : 1.0) * acos(cos_n);
        vec2 step_px = across * (radius_px / float(STEPS));
        float h0 = -horizon(p, to_eye, -step_px, noise2, cos(gamma - HALF_PI), radius_m);
        float h1 = horizon(p, to_eye, step_px, noise2, cos(gamma + HALF_PI), radius_m);
        h0 = gamma + max(h0 - gamma, -HALF_PI);
        h1 = gamma + min(h1 - gamma, HALF_PI);
        float sin_n = sin(gamma);
        float arc = 0.25 * (2.0 * cos_n + 2.0 * (h0 + h1) * sin_n - cos(2.0 * h0 - gamma) - cos(2.0 * h1 - gamma));
        visible += size * arc;
        float t0 = (6.0 * sin(h0 - gamma) - sin(3.0 * h0 - gamma) + 6.0 * sin(h1 - gamma) - sin(3.0 * h1 - gamma) + 16.0 * sin_n -
                    3.0 * (sin(h0 + gamma) + sin(h1 + gamma))) / 12.0;
        float t1 = (-cos(3.0 * h0 - gamma) - cos(3.0 * h1 - gamma) + 8.0 * cos_n - 3.0 * (cos(h0 + gamma) + cos(h1 + gamma))) / 12.0;
        bent += (in_slice * t0 + to_eye * t1) * size;
    }
    visible = clamp(visible / float(SLICES), 0.0, 1.0);
    bent = dot(bent, bent) > 1e-8 ? normalize(bent) : n;
    out_occlusion = vec4(bent, visible);
}
