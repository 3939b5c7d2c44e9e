// Directions of light drawn as the model reflects it, for the reference: one of two lobes by its share of the albedo.

// What both need of a pixel. All directions are in the frame of the normal, z along it.
struct BrdfSampler {
    real3 v;        // to the viewer, v.z > 0
    real specular;  // [0, 1] share of the samples that the specular lobe gets
};

// weight  the environment's, of all that is sampled
BrdfSampler brdf_sampler(BrdfValue weight, real3 v) {
    real diffuse = weight.diffuse.x + weight.diffuse.y + weight.diffuse.z;
    real specular = weight.specular.x + weight.specular.y + weight.specular.z;
    BrdfSampler s;
    s.v = v;
    s.specular = specular / max(specular + diffuse, DIVISOR_MIN);
    // Where both reflect, neither is left to the other's samples and their weights without bound.
    if (diffuse > real(0.0)) s.specular = clamp(s.specular, LOBE_SHARE_MIN, real(1.0) - LOBE_SHARE_MIN);
    return s;
}
BrdfSampler brdf_sampler(BrdfView view, real3 v) { return brdf_sampler(brdf_environment(view), v); }

// u        [0, 1)^2  uniform
// lobe     [0, 1)    uniform; chooses the lobe
// returns  unit      to the light; below the surface (z <= 0) where a facet sends it there: such samples count as 0
real3 brdf_sample(BrdfView view, BrdfSampler s, real2 u, real lobe) {
    if (lobe >= s.specular) return slot_sample_diffuse(u);
    real3 h = slot_sample_half(s.v, view.surface.alpha, u);
    return h * (real(2.0) * dot(s.v, h)) - s.v;
}

// returns  [1/sr]  density of brdf_sample at a direction with these cosines
real brdf_pdf(BrdfView view, BrdfSampler s, real n_dot_l, real n_dot_h, real v_dot_h) {
    real specular = slot_pdf_reflected(s.v.z, n_dot_h, v_dot_h, view.surface.alpha);
    return s.specular * specular + (real(1.0) - s.specular) * slot_pdf_diffuse(n_dot_l);
}

// Roughness 0: D V (n.l) becomes a mirror's delta, of which F and the weights of the model are left.
// returns  [1] rgb  share of the light from reflect(-v, n) that the specular lobe sends to the viewer
real3 brdf_mirror(BrdfView view) {
    real3 none = real3(real(0.0));
    if (slot_conserves()) return conserving_light(view, real(1.0), none, view.n_dot_v, real(1.0)).specular;
    return cook_torrance_light(view, real(1.0), none, view.n_dot_v).specular;
}

// Through a rough surface: density of the lights that refracted() finds for the half vectors of slot_sample_half.
//   p(l) = p(h) eta^2 |l.h| / (v.h + eta l.h)^2                                   Walter et al. 2007, Eq. 17
// v, l     unit      in the frame of the normal, v.z > 0, l.z < 0
// returns  [1/sr]    0 where no facet bends l to v
real pdf_through(real3 v, real3 l, real eta, real alpha) {
    real3 h = half_through(v, l, eta);
    real v_dot_h = dot(v, h);
    real l_dot_h = dot(l, h);
    if (v_dot_h <= real(0.0) || l_dot_h >= real(0.0) || h.z <= real(0.0)) return real(0.0);
    real bent = v_dot_h + eta * l_dot_h;
    real p_h = slot_pdf_reflected(v.z, h.z, v_dot_h, alpha) * real(4.0) * v_dot_h;
    return p_h * eta * eta * (-l_dot_h) / max(bent * bent, DIVISOR_MIN);
}
