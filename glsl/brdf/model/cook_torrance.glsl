// The lecture's model: one specular lobe with F0 mixed first, and no compensation.
//   f = k_d f_diffuse + D V F, F0 = mix(s F0_dielectric, base, m), k_d = (1 - F)(1 - m)      Cook & Torrance 1982
// k_s is F, which D V F holds already. A white furnace shows what this loses, and at grazing angles gains.

real3 cook_torrance_f0(BrdfView view) {
    return view.surface.dielectric_f0 * (view.surface.specular * (real(1.0) - view.surface.metallic)) +
           view.surface.metal_f0 * view.surface.metallic;
}

real3 cook_torrance_fresnel(BrdfView view, real v_dot_h) {
    return slot_fresnel(cook_torrance_f0(view), view.surface.edge_tint, v_dot_h);
}

// What F leaves of the light that enters, before metal takes it.
real3 cook_torrance_left(real3 f) { return slot_has_fresnel() ? real3(real(1.0)) - f : real3(real(1.0)); }

// d_v  [1/sr] D V
BrdfValue cook_torrance_light(BrdfView view, real d_v, real3 diffuse, real v_dot_h) {
    real3 f = cook_torrance_fresnel(view, v_dot_h);
    BrdfValue value;
    value.diffuse = diffuse * cook_torrance_left(f) * ((real(1.0) - view.surface.metallic) * view.surface.diffuse);
    value.specular = f * d_v;
    return value;
}

// The same for light from everywhere.
real3 cook_torrance_left_around(BrdfView view) {
    if (!slot_has_fresnel()) return real3(real(1.0));
    // Mean of (1 - v.h)^5 over light from everywhere, weighted with its cosine: a cubic in n.v, fitted by least
    // squares to a 300 x 300 midpoint sum; error below 1e-4.
    real x = view.n_dot_v;
    real grazing =
        real(0.0280678) + x * (real(-0.0774536) + x * (real(0.0750714) - x * real(0.0256962)));
    return (real3(real(1.0)) - cook_torrance_f0(view)) * (real(1.0) - grazing);
}

BrdfValue cook_torrance_environment(BrdfView view) {
    real metal = view.surface.metallic;
    BrdfValue weight;
    weight.diffuse = view.diffuse_albedo * cook_torrance_left_around(view) * ((real(1.0) - metal) * view.surface.diffuse);
    weight.specular = real3(view.a + view.b);
    if (slot_has_fresnel()) weight.specular = cook_torrance_f0(view) * view.a + real3(view.b);
    return weight;
}
