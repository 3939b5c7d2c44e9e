// A texel of the table of albedos, by drawing directions as the reference does: an even grid of them.
#include "generated/brdf.glsl"

layout(location = 0) out highp uvec4 out_bits;

const int STEPS_PHI = 24;
const int STEPS_R = 48;

// returns  [1]  share of the light from everywhere that the specular lobe of this F0 sends to the viewer
float albedo_of(float f0, float n_dot_v, float roughness) {
    float alpha = max(slot_width(roughness), 1e-4);
    vec3 v = vec3(sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)), 0.0, n_dot_v);
    float sum = 0.0;
    for (int i = 0; i < STEPS_PHI; ++i)
        for (int j = 0; j < STEPS_R; ++j) {
            vec2 u = (vec2(i, j) + 0.5) / vec2(STEPS_PHI, STEPS_R);
            vec3 h = slot_sample_half(v, alpha, u);
            float v_dot_h = dot(v, h);
            vec3 l = 2.0 * v_dot_h * h - v;
            if (l.z <= 0.0 || v_dot_h <= 0.0) continue;
            float pdf = slot_pdf_reflected(n_dot_v, h.z, v_dot_h, alpha);
            float f = slot_distribution(h.z, alpha) * slot_masking(n_dot_v, l.z, roughness, alpha) *
                      slot_fresnel(vec3(f0), vec3(1.0), v_dot_h).x;
            if (pdf > 0.0) sum += f * l.z / pdf;
        }
    return sum / float(STEPS_PHI * STEPS_R);
}

float diffuse_albedo_of(float n_dot_v, float roughness) {
    vec3 v = vec3(sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)), 0.0, n_dot_v);
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) {
            vec3 l = slot_sample_diffuse((vec2(i, j) + 0.5) / 16.0);
            float v_dot_h = sqrt(max(0.5 + 0.5 * dot(v, l), 0.0));
            sum += slot_diffuse(vec3(1.0), roughness, n_dot_v, l.z, v_dot_h).x * l.z / slot_pdf_diffuse(l.z);
        }
    return sum / 256.0;
}

void main() {
    vec2 at = (gl_FragCoord.xy - 0.5) / (ALBEDO_TABLE_SIZE - 1.0);  // inverse of albedo_coordinates
    float n_dot_v = max(at.x * at.x * at.x * at.x, 1e-4);
    float roughness = max(at.y * at.y, 0.01);
    float dark = albedo_of(DIELECTRIC_F0, n_dot_v, roughness);
    float bright = albedo_of(1.0, n_dot_v, roughness);
    float a = (bright - dark) / (1.0 - DIELECTRIC_F0);
    out_bits = floatBitsToUint(vec4(a, bright - a, 0.0, diffuse_albedo_of(n_dot_v, roughness)));
}
