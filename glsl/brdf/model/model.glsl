// The BRDF as lighting calls it: brdf_view once a pixel, brdf_light once a light, brdf_environment once.

// n_dot_v  (0, 1]  clamped by the caller
// albedo   x, y: the split sum's A and B at (n_dot_v, roughness); z: hemispherical mean of A + B; w: albedo of the
//          diffuse lobe for white. The table's texel (brdf/albedo.h, lib/albedo_coordinates.glsl)
BrdfView brdf_view(BrdfSurface s, real n_dot_v, real4 albedo) {
    BrdfView view;
    view.surface = s;
    view.n_dot_v = n_dot_v;
    view.a = albedo.x;
    view.b = albedo.y;
    view.e_average = albedo.z;
    view.diffuse_albedo = slot_diffuse_albedo(s.base_color, s.roughness, n_dot_v, albedo.w);
    view.k_d = real(0.0);
    view.dielectric_weight = real3(real(0.0));
    view.metal_weight = real3(real(0.0));
    view.added = real3(real(0.0));
    if (slot_conserves()) return conserving_view(view);  // no ?: of a structure: WebGL has none
    return view;
}

// returns  [1/sr]  D V of the terms chosen
real brdf_d_v(BrdfView view, real n_dot_l, real n_dot_h) {
    BrdfSurface s = view.surface;
    return slot_distribution(n_dot_h, s.alpha) * slot_masking(view.n_dot_v, n_dot_l, s.roughness, s.alpha);
}

// brdf_light with another D V.
BrdfValue brdf_light_of(BrdfView view, real d_v, real n_dot_l, real v_dot_h, real e_l) {
    BrdfSurface s = view.surface;
    real3 diffuse = slot_diffuse(s.base_color, s.roughness, view.n_dot_v, n_dot_l, v_dot_h);
    if (slot_conserves()) return conserving_light(view, d_v, diffuse, v_dot_h, e_l);
    return cook_torrance_light(view, d_v, diffuse, v_dot_h);
}

// n_dot_l, n_dot_h, v_dot_h  [0, 1]
// e_l                        [0, 1] A + B at n_dot_l where FACET_BRDF_NEEDS_E_L is 1; else not used
// returns                    [1/sr] without the cosine
BrdfValue brdf_light(BrdfView view, real n_dot_l, real n_dot_h, real v_dot_h, real e_l) {
    return brdf_light_of(view, brdf_d_v(view, n_dot_l, n_dot_h), n_dot_l, v_dot_h, e_l);
}

// What brdf_light's value is made of. G = 4 n.v n.l V; F is of the mixed F0 in either model, as `facet brdf` asks it.
BrdfTerms brdf_terms(BrdfView view, real n_dot_l, real n_dot_h, real v_dot_h) {
    BrdfSurface s = view.surface;
    BrdfTerms terms;
    terms.d = slot_distribution(n_dot_h, s.alpha);
    terms.g = real(4.0) * view.n_dot_v * n_dot_l * slot_masking(view.n_dot_v, n_dot_l, s.roughness, s.alpha);
    terms.f = cook_torrance_fresnel(view, v_dot_h);
    if (slot_conserves()) {
        terms.k_d = real3(view.k_d);
        terms.k_s = conserving_specular_share(view, v_dot_h);
    } else {
        terms.k_d = cook_torrance_left(terms.f) * (real(1.0) - s.metallic);
        terms.k_s = terms.f;
    }
    return terms;
}

// returns  [0, 1] rgb  k_d: what the specular lobe leaves of light from everywhere, before it is shared out
real3 brdf_left(BrdfView view) {
    if (slot_conserves()) return real3(view.k_d);
    return cook_torrance_left_around(view) * (real(1.0) - view.surface.metallic);
}

// Split sum: (1/N) sum(L f cos / p) ~ irradiance / pi * diffuse + prefiltered radiance * specular   Karis 2013, Eq. 7
BrdfValue brdf_environment(BrdfView view) {
    if (slot_conserves()) return conserving_environment(view);
    return cook_torrance_environment(view);
}
