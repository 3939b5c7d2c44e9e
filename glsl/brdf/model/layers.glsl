// What lies over the base: lacquer, and below it fibres. Each reflects, and leaves the rest to what lies below.
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

// base_n_dot_l               [0, 1]  the cosine that the caller multiplies with
// n_dot_l, n_dot_h, v_dot_h  [0, 1]  with the coat's own normal
// returns                    [1/sr]  times the coat's strength, and its own cosine over the base's
real coat_light(BrdfCoat coat, real base_n_dot_l, real n_dot_l, real n_dot_h, real v_dot_h) {
    real d_v = slot_distribution(n_dot_h, coat.alpha) *
               slot_masking(coat.n_dot_v, n_dot_l, coat.roughness, coat.alpha);
    real f = coat.strength * d_v * slot_fresnel(real3(DIELECTRIC_F0), real3(real(1.0)), v_dot_h).x;
    return f * n_dot_l / max(base_n_dot_l, real(1e-4));
}

// A coat of roughness 0: share of the light from its mirrored direction that it sends to the viewer.
real coat_mirror(BrdfCoat coat) {
    return coat.strength * slot_fresnel(real3(DIELECTRIC_F0), real3(real(1.0)), coat.n_dot_v).x;
}

// Fibres: f = f_sheen + (1 - max(colour) E_sheen(v)) f_base                                 KHR_materials_sheen
// Where E passes 1, at grazing angles of smooth fibres, the lobe is scaled to 1.
struct BrdfSheen {
    real3 color;      // [0, 1], scaled
    real alpha;       // (0, 1]
    real3 albedo;     // [0, 1]
    real left;        // [0, 1] of what lies below
};

// returns  [0, 1]^2, for a texture of brdf/sheen.h's size with linear filter and clamped edges
real2 sheen_coordinates(real n_dot_v, real roughness, real2 size) {
    real row = (max(roughness, SHEEN_ROUGHNESS_MIN) - SHEEN_ROUGHNESS_MIN) / (real(1.0) - SHEEN_ROUGHNESS_MIN);
    return (real2(sqrt(n_dot_v), sqrt(row)) * (size - real2(real(1.0))) + real2(real(0.5))) / size;
}

// e  albedo for colour 1, from the table
BrdfSheen brdf_sheen(real3 color, real roughness, real e) {
    BrdfSheen sheen;
    real width = max(roughness, SHEEN_ROUGHNESS_MIN);
    sheen.color = color / max(e, real(1.0));
    sheen.alpha = width * width;
    sheen.albedo = color * min(e, real(1.0));
    sheen.left = real(1.0) - max(sheen.albedo.x, max(sheen.albedo.y, sheen.albedo.z));
    return sheen;
}

// Under the fibres: the sheen counts as diffuse light, as it is as wide. added: f_sheen, or its albedo.
BrdfValue below_sheen(BrdfSheen sheen, BrdfValue base, real3 added) {
    BrdfValue value;
    value.diffuse = base.diffuse * sheen.left + added;
    value.specular = base.specular * sheen.left;
    return value;
}

// returns  [1/sr]  without the cosine
real3 sheen_light(BrdfSheen sheen, real n_dot_v, real n_dot_l, real n_dot_h) {
    return sheen.color * (d_charlie(n_dot_h, sheen.alpha) * v_charlie(n_dot_v, n_dot_l, sheen.alpha));
}
