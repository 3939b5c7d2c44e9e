// A layer of lacquer over the base: it reflects, and leaves the rest to what lies below.
//   f = c f_coat + (1 - c E_coat(v)) f_base           KHR_materials_clearcoat, with E where its sample has F(n.v): so a
//                                                     rough coat conserves energy too (Kelemen & Szirmay-Kalos 2001)
// The terms are those chosen for the base, F0 is a plain dielectric's.
struct BrdfCoat {
    real strength;   // [0, 1]
    real roughness;  // [0, 1] perceptual
    real alpha;      // (0, 1]
    real n_dot_v;    // (0, 1] with the coat's own normal
    real albedo;     // [0, 1] strength times E at n_dot_v
};

// a, b  split sum's A and B at (n_dot_v, roughness)
BrdfCoat brdf_coat(real strength, real roughness, real n_dot_v, real a, real b) {
    BrdfCoat coat;
    coat.strength = strength;
    coat.roughness = roughness;
    coat.alpha = slot_width(roughness);
    coat.n_dot_v = n_dot_v;
    coat.albedo = strength * (slot_has_fresnel() ? DIELECTRIC_F0 * a + b : a + b);
    return coat;
}

// Of the light that reaches the surface, or leaves it, what passes the coat.
BrdfValue below_coat(BrdfCoat coat, BrdfValue base) {
    BrdfValue value;
    value.diffuse = base.diffuse * (real(1.0) - coat.albedo);
    value.specular = base.specular * (real(1.0) - coat.albedo);
    return value;
}

// n_dot_l, n_dot_h, v_dot_h  [0, 1]  with the coat's own normal
// returns                    [1/sr]  times the coat's strength, without the cosine
real coat_light(BrdfCoat coat, real n_dot_l, real n_dot_h, real v_dot_h) {
    real d_v = slot_distribution(n_dot_h, coat.alpha) *
               slot_masking(coat.n_dot_v, n_dot_l, coat.roughness, coat.alpha);
    return coat.strength * d_v * slot_fresnel(real3(DIELECTRIC_F0), real3(real(1.0)), v_dot_h).x;
}

// A coat of roughness 0: share of the light from its mirrored direction that it sends to the viewer.
real coat_mirror(BrdfCoat coat) {
    return coat.strength * slot_fresnel(real3(DIELECTRIC_F0), real3(real(1.0)), coat.n_dot_v).x;
}
