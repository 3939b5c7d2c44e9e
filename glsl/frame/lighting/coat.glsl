// The lacquer over a surface, as shade.glsl lights it; glsl/brdf/model/layers.glsl.
struct CoatPoint {
    BrdfCoat brdf;
    vec3 normal;
    bool is_mirror;
};
CoatPoint coat;  // of the point at hand

CoatPoint coat_point(ShadePoint p) {
    float n_dot_v = clamp(dot(p.coat_normal, p.to_eye), N_DOT_V_MIN, 1.0);
    float roughness = max(p.coat_roughness, ROUGHNESS_MIN);
    vec2 a_b = textureLod(albedo_table, albedo_coordinates(n_dot_v, roughness), 0.0).xy;
    return CoatPoint(brdf_coat(p.coat, roughness, n_dot_v, a_b.x, a_b.y), p.coat_normal,
                     p.coat_roughness < MIRROR_ROUGHNESS);
}

// f: of the base; n_dot_l: its cosine, which the caller multiplies with.
BrdfValue coated(BrdfValue f, vec3 to_light, vec3 h, float n_dot_l, float v_dot_h, bool has_size) {
    BrdfValue value = below_coat(coat.brdf, f);
    float coat_n_dot_l = clamp(dot(coat.normal, to_light), 0.0, 1.0);
    float n_dot_h = clamp(dot(coat.normal, h), 0.0, 1.0);
    float on_coat = coat_light(coat.brdf, coat_n_dot_l, n_dot_h, v_dot_h) * coat_n_dot_l / max(n_dot_l, 1e-4);
    value.specular += coat.is_mirror && !has_size ? 0.0 : on_coat;
    return value;
}
