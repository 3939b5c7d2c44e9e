// A ball of the lesson's surface, seen from far away, lit by one light or by a white furnace.
#include "generated/brdf.glsl"
#include "teach/table.glsl"

uniform vec2 size_px;
uniform vec4 surface;      // perceptual roughness, metallic, F0 of the dielectric, base colour
uniform vec3 base_tint;    // times base colour
uniform vec3 to_light;     // unit
uniform float intensity;   // of the light: a white Lambert surface that faces it shows this
uniform int view;          // index of teach::live_views()
uniform bool furnace;
uniform vec3 page_color;   // sRGB, beside the ball

layout(location = 0) out vec4 out_color;

vec3 encoded(vec3 linear) {
    vec3 c = clamp(linear, vec3(0.0), vec3(1.0));
    return mix(1.055 * pow(max(c, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, c * 12.92, lessThan(c, vec3(0.0031308)));
}

vec3 shown(vec3 n) {
    float n_dot_v = clamp(n.z, 1e-3, 1.0);
    float n_dot_l = max(dot(n, to_light), 0.0);
    vec3 sum = vec3(0.0, 0.0, 1.0) + to_light;
    vec3 h = sum * inversesqrt(max(dot(sum, sum), 1e-12));
    float n_dot_h = clamp(dot(n, h), 0.0, 1.0);
    float v_dot_h = clamp(h.z, 0.0, 1.0);
    BrdfSurface s = brdf_surface(base_tint * surface.w, surface.y, surface.x);
    s.dielectric_f0 = vec3(surface.z);
    BrdfView seen = brdf_view(s, n_dot_v, table_at(n_dot_v, surface.x));
    if (view > 2) {
        BrdfTerms terms = brdf_terms(seen, n_dot_l, n_dot_h, v_dot_h);
        if (view == 3) return vec3(terms.d / (1.0 + terms.d));
        if (view == 4) return vec3(terms.g);
        if (view == 5) return terms.f;
        if (view == 6) return terms.k_d;
        if (view == 7) return min(terms.k_s, vec3(1.0));
        if (view == 8) return vec3(n_dot_h);
        if (view == 9) return vec3(n_dot_l);
        return vec3(view == 10 ? n_dot_v : v_dot_h);
    }
    vec3 specular;
    vec3 diffuse;
    if (furnace) {
        BrdfValue w = brdf_environment(seen);
        specular = w.specular;
        diffuse = w.diffuse;
    } else {
        vec4 at_light = table_at(n_dot_l, surface.x);
        BrdfValue f = brdf_light(seen, n_dot_l, n_dot_h, v_dot_h, at_light.x + at_light.y);
        specular = f.specular * n_dot_l * PI * intensity;
        diffuse = f.diffuse * n_dot_l * PI * intensity;
    }
    if (view == 1) return specular;
    if (view == 2) return diffuse;
    return specular + diffuse;
}

void main() {
    vec2 at = (gl_FragCoord.xy * 2.0 - size_px) / min(size_px.x, size_px.y) * 1.12;
    float r = length(at);
    const float FURNACE_GRAY = 0.6;  // what a radiance of 1 is shown as, so that a gain shows too
    vec3 beside = furnace && view < 3 ? encoded(vec3(FURNACE_GRAY)) : page_color;
    vec3 color = beside;
    float edge = fwidth(r);
    if (r < 1.0 + edge) {
        vec2 inside = at * min(1.0, 0.9999 / max(r, 1e-6));
        vec3 n = vec3(inside, sqrt(max(1.0 - dot(inside, inside), 0.0)));
        vec3 value = shown(n);
        // Numbers are codes as they are, light is encoded.
        vec3 ball = view < 3 ? encoded(value * (furnace ? FURNACE_GRAY : 1.0)) : clamp(value, vec3(0.0), vec3(1.0));
        color = mix(ball, beside, smoothstep(1.0 - edge, 1.0 + edge, r));
    }
    out_color = vec4(color, 1.0);
}
