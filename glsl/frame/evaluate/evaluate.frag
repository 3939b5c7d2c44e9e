// The BRDF itself, one question a pixel: what `facet brdf --via gl` asks. src/frame/evaluate/evaluate.h fills the rows.
#include "generated/brdf.glsl"

uniform sampler2D questions;     // three rows of texels a block: cosines; roughness, metallic, f0, base; term
uniform sampler2D albedo_table;  // as lighting/shade.glsl reads it

layout(location = 0) out vec4 out_value;

// Numbers of brdf::QueryTerm.
const int TERM_D = 0;
const int TERM_G = 1;
const int TERM_V = 2;
const int TERM_F = 3;
const int TERM_SPECULAR = 4;
const int TERM_DIFFUSE = 5;
const int TERM_FULL = 6;
const int TERM_MODEL_SPECULAR = 7;
const int TERM_MODEL_DIFFUSE = 8;

// D V F with its compensation, F0 mixed by metallic.
float mixed_specular(vec3 f0, float v_dot_h, float d_v, vec4 albedo, float e_l) {
    float single = d_v * slot_fresnel(f0, vec3(1.0), v_dot_h).x;
    if (!slot_conserves()) return single;
    return single * slot_multiscatter(f0, albedo.x + albedo.y).x +
           slot_added(f0, albedo.x, albedo.y, albedo.z).x * slot_added_shape(e_l, albedo.z);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    at.y *= 3;
    vec4 cosines = texelFetch(questions, at, 0);  // n.v, n.l, n.h, v.h
    vec4 material = texelFetch(questions, at + ivec2(0, 1), 0);
    int term = int(texelFetch(questions, at + ivec2(0, 2), 0).x);
    BrdfSurface s = brdf_surface(vec3(material.w), material.y, material.x);
    s.dielectric_f0 = material.z;
    vec3 mixed_f0 = vec3(mix(material.z, material.w, material.y));
    float v = slot_masking(cosines.x, cosines.y, s.roughness, s.alpha);
    float value = 0.0;
    if (term == TERM_D) value = slot_distribution(cosines.z, s.alpha);
    if (term == TERM_G) value = 4.0 * cosines.x * cosines.y * v;
    if (term == TERM_V) value = v;
    if (term == TERM_F) value = slot_fresnel(mixed_f0, vec3(1.0), cosines.w).x;
    if (term == TERM_DIFFUSE) value = slot_diffuse(vec3(1.0), s.roughness, cosines.x, cosines.y, cosines.w).x;
    if (term == TERM_SPECULAR || term > TERM_DIFFUSE) {
        vec4 albedo = textureLod(albedo_table, albedo_coordinates(cosines.x, s.roughness), 0.0);
        vec2 e_l = textureLod(albedo_table, albedo_coordinates(cosines.y, s.roughness), 0.0).xy;
        if (term == TERM_SPECULAR) {
            float d_v = slot_distribution(cosines.z, s.alpha) * v;
            value = mixed_specular(mixed_f0, cosines.w, d_v, albedo, e_l.x + e_l.y);
        } else {
            BrdfValue f = brdf_light(brdf_view(s, cosines.x, albedo), cosines.y, cosines.z, cosines.w, e_l.x + e_l.y);
            if (term == TERM_FULL) value = f.specular.x + f.diffuse.x;
            if (term == TERM_MODEL_SPECULAR) value = f.specular.x;
            if (term == TERM_MODEL_DIFFUSE) value = f.diffuse.x;
        }
    }
    out_value = vec4(value);
}
