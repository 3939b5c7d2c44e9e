// A film a few wavelengths thick over the base: light that it reflects above and below interferes (KHR_materials_iridescence).
//   Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", Eqs. 3, 10,
//   13 and 14: Airy's sum over the ways through the film, each integrated over the eye's sensitivities in Fourier space.

// The CIE's colour matching functions as Gaussians, integrated over a wave of this path difference; then to linear Rec.709.
// opd_nm  optical path difference
// shift   phase that the reflections add, by channel
real3 film_sensitivity(real opd_nm, real3 shift) {
    real phase = real(2.0) * PI * opd_nm * real(1e-9);
    real p2 = phase * phase;
    real x = real(5.4856e-13) * sqrt(real(2.0) * PI * real(4.3278e9)) * cos(real(1.6810e6) * phase + shift.x) *
             exp(-real(4.3278e9) * p2);
    real y = real(4.4201e-13) * sqrt(real(2.0) * PI * real(9.3046e9)) * cos(real(1.7953e6) * phase + shift.y) *
             exp(-real(9.3046e9) * p2);
    real z = real(5.2481e-13) * sqrt(real(2.0) * PI * real(6.6121e9)) * cos(real(2.2084e6) * phase + shift.z) *
             exp(-real(6.6121e9) * p2);
    x += real(9.7470e-14) * sqrt(real(2.0) * PI * real(4.5282e9)) * cos(real(2.2399e6) * phase + shift.x) *
         exp(-real(4.5282e9) * p2);
    real3 xyz = real3(x, y, z) / real(1.0685e-7);
    return real3(real(3.2404542) * xyz.x - real(1.5371385) * xyz.y - real(0.4985314) * xyz.z,
                 real(-0.9692660) * xyz.x + real(1.8760108) * xyz.y + real(0.0415560) * xyz.z,
                 real(0.0556434) * xyz.x - real(0.2040259) * xyz.y + real(1.0572252) * xyz.z);
}

real film_f0(real ior_below, real ior_above) { return sqr((ior_below - ior_above) / (ior_below + ior_above)); }

// f0            [0, 1)   of the base in air; its index of refraction is taken from that
// film_ior      [1, ..)  goes to 1 with the thickness below 30 nm, so that no film is no film
// thickness_nm  [0, ..)
// returns       [0, 1] rgb  reflectance of film and base, linear Rec.709
real3 thin_film(real3 f0, real film_ior, real thickness_nm, real cosine) {
    real t = clamp(thickness_nm / real(30.0), real(0.0), real(1.0));
    real ior = real(1.0) + (film_ior - real(1.0)) * t * t * (real(3.0) - real(2.0) * t);
    real cos2_in = real(1.0) - (real(1.0) - cosine * cosine) / (ior * ior);
    if (cos2_in <= real(0.0)) return real3(real(1.0));
    real cos_in = sqrt(cos2_in);
    real r0 = film_f0(ior, real(1.0));
    real r12 = r0 + (real(1.0) - r0) * pow(real(1.0) - cosine, real(5.0));
    real t121 = real(1.0) - r12;
    real3 root = real3(sqrt(min(f0.x, real(0.9999))), sqrt(min(f0.y, real(0.9999))), sqrt(min(f0.z, real(0.9999))));
    real3 base = (real3(real(1.0)) + root) / (real3(real(1.0)) - root);
    real3 r1 = real3(film_f0(base.x, ior), film_f0(base.y, ior), film_f0(base.z, ior));
    real3 r23 = r1 + (real3(real(1.0)) - r1) * pow(real(1.0) - cos_in, real(5.0));
    // A reflection at what is denser turns the wave: above the film where its index is above 1, below where the base's is.
    real turned = ior < real(1.0) ? real(0.0) : PI;
    real3 shift = real3(turned + (base.x < ior ? PI : real(0.0)), turned + (base.y < ior ? PI : real(0.0)),
                        turned + (base.z < ior ? PI : real(0.0)));
    real opd_nm = real(2.0) * ior * thickness_nm * cos_in;
    real3 r123 = clamp(r23 * r12, real(1e-5), real(0.9999));
    real3 rs = r23 * (t121 * t121) / (real3(real(1.0)) - r123);
    real3 sum = real3(r12) + rs;
    real3 c = rs - real3(t121);
    real3 r = real3(sqrt(r123.x), sqrt(r123.y), sqrt(r123.z));
    for (int m = 1; m <= 2; ++m) {
        c = c * r;
        sum += c * (real(2.0) * film_sensitivity(real(m) * opd_nm, shift * real(m)));
    }
    return clamp(sum, real(0.0), real(1.0));
}

// reflectance  [0, 1] rgb  wanted at this cosine
// returns      [0, 1] rgb  F0 of which Schlick's Fresnel makes that; `f0` seen edge on, where all reflect all
real3 f0_of_reflectance(real3 reflectance, real3 f0, real cosine) {
    real s = pow(real(1.0) - cosine, real(5.0));
    if (s > real(0.999)) return f0;
    return clamp((reflectance - real3(s)) / (real(1.0) - s), real(0.0), real(1.0));
}

// A film's reflectance in the place of F0.
// strength  [0, 1]
// returns   [0, 1] rgb
real3 thin_film_f0(real3 f0, real strength, real film_ior, real thickness_nm, real cosine) {
    real3 film = f0_of_reflectance(thin_film(f0, film_ior, thickness_nm, cosine), f0, cosine);
    return f0 + (film - f0) * strength;
}
