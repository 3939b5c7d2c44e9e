// One question about the BRDF and its answer, as `facet brdf` and lessons ask it. Needs generated/brdf.glsl.
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

// cosines   n.v, n.l, n.h, v.h
// material  perceptual roughness, metallic, F0 of the dielectric, base colour
// albedo    the table's texel at n.v (brdf_view); e_l: A + B at n.l
float answer(int term, vec4 cosines, vec4 material, vec4 albedo, float e_l) {
    BrdfSurface s = brdf_surface(vec3(material.w), material.y, material.x);
    s.dielectric_f0 = vec3(material.z);
    vec3 mixed_f0 = vec3(mix(material.z, material.w, material.y));
    float v = slot_masking(cosines.x, cosines.y, s.roughness, s.alpha);
    if (term == TERM_D) return slot_distribution(cosines.z, s.alpha);
    if (term == TERM_G) return 4.0 * cosines.x * cosines.y * v;
    if (term == TERM_V) return v;
    if (term == TERM_F) return slot_fresnel(mixed_f0, vec3(1.0), cosines.w).x;
    if (term == TERM_DIFFUSE) return slot_diffuse(vec3(1.0), s.roughness, cosines.x, cosines.y, cosines.w).x;
    if (term == TERM_SPECULAR) {
        float d_v = slot_distribution(cosines.z, s.alpha) * v;
        return mixed_specular(mixed_f0, cosines.w, d_v, albedo, e_l);
    }
    BrdfValue f = brdf_light(brdf_view(s, cosines.x, albedo), cosines.y, cosines.z, cosines.w, e_l);
    if (term == TERM_MODEL_SPECULAR) return f.specular.x;
    if (term == TERM_MODEL_DIFFUSE) return f.diffuse.x;
    return f.specular.x + f.diffuse.x;
}
