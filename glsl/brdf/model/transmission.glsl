// Light from a surface's far side, in the place of diffuse light:
//   f = f_specular + k_d ((1 - t) ((1 - d) f_diffuse + d colour f_far) + t base f_through)
//        KHR_materials_transmission (t), KHR_materials_diffuse_transmission (d: f_far is Lambert's on the far side)
// with k_d of the model, what the specular lobe leaves. f_through sends on all light that it gets, whatever its roughness,
// so a white furnace sees 1: facets that hide light from one another send it on in the end (Walter et al. 2007, Eq. 21,
// without the shadowing of the way out).

// v, h     unit      to the viewer; half vector on its side
// eta      (0, ..)   index of the far side over the near side's
// returns  unit      where light that is bent towards v comes from (Walter et al. 2007, Eq. 40); 0 at total reflection
real3 refracted(real3 v, real3 h, real eta) {
    real c = dot(v, h);
    real cos2_t = real(1.0) - (real(1.0) - c * c) / (eta * eta);
    if (cos2_t <= real(0.0)) return real3(real(0.0));
    return h * (c / eta - sqrt(cos2_t)) - v / eta;
}

// returns  unit  the h of refracted() for light from l, on v's side (Walter et al. 2007, Eq. 16)
real3 half_through(real3 v, real3 l, real eta) {
    real3 h = v + l * eta;
    if (eta > real(1.0)) h = -h;
    return normalize(h);
}

// channel  0 red .. 2 blue
// returns  index of refraction there; its spread from red to blue is (ior - 1) over the Abbe number, which is
//          20 over dispersion                                                        KHR_materials_dispersion
real dispersed_ior(real ior, real dispersion, real channel) {
    return ior + (channel - real(1.0)) * (ior - real(1.0)) * real(0.025) * dispersion;
}
