// What few surfaces have, as shade.glsl lights them: layers (glsl/brdf/model/layers.glsl) and highlights that are wider one way.
#if FACET_ANISOTROPY
// To the tangent's frame.
mat3 stretched_frame(ShadePoint p) {
    return transpose(mat3(p.surface.tangent, cross(p.surface.normal, p.surface.tangent), p.surface.normal));
}
float stretched_d_v(ShadePoint p, vec3 to_light, vec3 h, BrdfView brdf) {
    mat3 local = stretched_frame(p);
    vec2 alpha = anisotropic_alpha(brdf.surface.alpha, p.surface.anisotropy);
    vec3 v = local * p.to_eye;
    vec3 l = local * to_light;
    return anisotropic_d_v(vec3(v.xy, max(v.z, N_DOT_V_MIN)), vec3(l.xy, max(l.z, 0.0)), local * h, alpha);
}
#endif

// What the environment is mirrored about: bent so that what is seen is spread as a long highlight is.
vec3 mirroring_normal(ShadePoint p) {
#if FACET_ANISOTROPY
    vec3 across = cross(p.surface.normal, p.surface.tangent);
    vec3 bent = cross(cross(across, p.to_eye), across);
    float round = 1.0 - p.surface.anisotropy * (1.0 - p.surface.roughness);
    round *= round;
    return normalize(mix(bent, p.surface.normal, round * round));
#else
    return p.surface.normal;
#endif
}

#if FACET_CLEARCOAT
struct CoatPoint {
    BrdfCoat brdf;
    vec3 normal;
    bool is_mirror;
};
CoatPoint coat;  // of the point at hand

CoatPoint coat_point(ShadePoint p) {
    float n_dot_v = clamp(dot(p.surface.coat_normal, p.to_eye), N_DOT_V_MIN, 1.0);
    float roughness = max(p.surface.coat_roughness, ROUGHNESS_MIN);
    vec2 a_b = textureLod(albedo_table, albedo_coordinates(n_dot_v, roughness), 0.0).xy;
    return CoatPoint(brdf_coat(p.surface.coat, roughness, n_dot_v, a_b.x, a_b.y), p.surface.coat_normal,
                     p.surface.coat_roughness < MIRROR_ROUGHNESS);
}
#endif
#if FACET_SHEEN
uniform sampler2D sheen_table;  // brdf/sheen.h
BrdfSheen sheen;                // of the point at hand
#endif

void set_layers(ShadePoint p, float n_dot_v) {
#if FACET_CLEARCOAT
    coat = coat_point(p);
#ifdef FACET_EXPLAIN
    explained.coat = vec4(p.surface.coat, p.surface.coat_roughness, coat.brdf.albedo, 0.0);
#endif
#endif
#if FACET_SHEEN
    vec2 at = sheen_coordinates(n_dot_v, p.surface.sheen_roughness, vec2(textureSize(sheen_table, 0)));
    sheen = brdf_sheen(p.surface.sheen_color, p.surface.sheen_roughness, textureLod(sheen_table, at, 0.0).r);
#ifdef FACET_EXPLAIN
    explained.sheen = vec4(sheen.albedo, p.surface.sheen_roughness);
#endif
#endif
}

// f: of the base; n_dot_l: its cosine, which the caller multiplies with.
BrdfValue layered(BrdfValue f, vec3 to_light, vec3 h, float n_dot_v, float n_dot_l, float n_dot_h, float v_dot_h, bool has_size) {
#if FACET_SHEEN
    f = below_sheen(sheen, f, sheen_light(sheen, n_dot_v, n_dot_l, n_dot_h));
#endif
#if FACET_CLEARCOAT
    f = below_coat(coat.brdf, f);
    float coat_n_dot_l = clamp(dot(coat.normal, to_light), 0.0, 1.0);
    float coat_n_dot_h = clamp(dot(coat.normal, h), 0.0, 1.0);
    float on_coat = coat_light(coat.brdf, n_dot_l, coat_n_dot_l, coat_n_dot_h, v_dot_h);
    f.specular += coat.is_mirror && !has_size ? 0.0 : on_coat;
#endif
    return f;
}

// Weights of the environment, but the coat's own.
BrdfValue below_layers(BrdfValue w) {
#if FACET_SHEEN
    w = below_sheen(sheen, w, sheen.albedo);
#endif
#if FACET_CLEARCOAT
    w = below_coat(coat.brdf, w);
#endif
    return w;
}

#if FACET_CLEARCOAT
// Mean of what the lobes of base and coat show, by their weights. w: the base's; the coat's is added.
vec3 with_coat(inout BrdfValue w, vec3 on_base, vec3 on_coat) {
    vec3 both = w.specular * on_base + coat.brdf.albedo * on_coat;
    w.specular += coat.brdf.albedo;
    return both / max(w.specular, vec3(1e-20));
}
#endif

float coat_albedo() {
#if FACET_CLEARCOAT
    return coat.brdf.albedo;
#else
    return 0.0;
#endif
}

// Of the light, by coat and fibres, for the base.
float left_by_layers() {
    float left = 1.0 - coat_albedo();
#if FACET_SHEEN
    left *= sheen.left;
#endif
    return left;
}
