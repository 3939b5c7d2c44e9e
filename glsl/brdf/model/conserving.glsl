// The default model: a dielectric and a metal lobe, each with its energy restored, mixed by metallic; the diffuse lobe
// gets what the dielectric lobe leaves. A white furnace sees 1 for a white base at every metallic and roughness.
//   f = (1 - m) (s f_dielectric + (1 - s E_dielectric(v)) f_diffuse) + m f_metal
//        glTF 2.0, Appendix B.2 (the mix); Turquin 2019 (compensation); Kelemen & Szirmay-Kalos 2001 (1 - E(v));
//        KHR_materials_specular (s, and a tinted F0: the diffuse lobe gets what its strongest channel leaves)
// F0 is not mixed first: that loses energy between dielectric and metal.

BrdfView conserving_view(BrdfView view) {
    real3 f0_d = view.surface.dielectric_f0;
    real3 f0_m = view.surface.metal_f0;
    real metal = view.surface.metallic;
    real dielectric = real(1.0) - metal;
    real specular = view.surface.specular;
    real e_v = view.a + view.b;
    real3 factor_d = slot_multiscatter(f0_d, e_v);
    real3 added_d = slot_added(f0_d, view.a, view.b, view.e_average);
    real3 albedo_d = (f0_d * view.a + real3(view.b)) * factor_d + added_d;
    real reflected = specular * max(albedo_d.x, max(albedo_d.y, albedo_d.z));
    view.k_d = dielectric * max(real(1.0) - reflected, real(0.0));
    view.dielectric_weight = factor_d * (dielectric * specular);
    view.metal_weight = slot_multiscatter(f0_m, e_v) * metal;
    view.added = added_d * (dielectric * specular) + slot_added(f0_m, view.a, view.b, view.e_average) * metal;
    return view;
}

// returns  factor on D V: Fresnel reflectance of both lobes, weighted
real3 conserving_specular_share(BrdfView view, real v_dot_h) {
    real3 f_d = slot_fresnel(view.surface.dielectric_f0, real3(real(1.0)), v_dot_h);
    real3 f_m = slot_fresnel(view.surface.metal_f0, view.surface.edge_tint, v_dot_h);
    return f_d * view.dielectric_weight + f_m * view.metal_weight;
}

// d_v       [1/sr] D V, the same for both lobes
// e_l       [0, 1] albedo of the specular lobe at n.l with F = 1; used by Kulla-Conty only
BrdfValue conserving_light(BrdfView view, real d_v, real3 diffuse, real v_dot_h, real e_l) {
    BrdfValue value;
    value.diffuse = diffuse * (view.k_d * view.surface.diffuse);
    value.specular = conserving_specular_share(view, v_dot_h) * d_v +
                     view.added * slot_added_shape(e_l, view.e_average);
    return value;
}

// The added lobe is as wide as a diffuse one, so it takes the diffuse light (Fdez-Aguera 2019, Eq. 18).
BrdfValue conserving_environment(BrdfView view) {
    real3 f0_d = view.surface.dielectric_f0;
    BrdfValue weight;
    weight.diffuse = view.diffuse_albedo * (view.k_d * view.surface.diffuse) + view.added;
    weight.specular = (f0_d * view.a + real3(view.b)) * view.dielectric_weight +
                      (view.surface.metal_f0 * view.a + real3(view.b)) * view.metal_weight;
    return weight;
}
