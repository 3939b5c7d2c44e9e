// Energy compensation: albedo at v of the lobe that Kulla and Conty add; ms_kulla_conty_shape is its other half.
//   f_ms = albedo(v) shape(l) = (1 - E_v)(1 - E_l) / (pi (1 - E_avg)) F_avg^2 E_avg / (1 - F_avg (1 - E_avg))
//                                                               Kulla & Conty 2017, slides 13 to 17
//   F_avg = F0 + (1 - F0) / 21 for Schlick's Fresnel
// f0         [0, 1] rgb  reflectance at normal incidence
// e_v        [0, 1]      albedo of the single-scattering lobe at n.v with F = 1
// e_average  [0, 1]      its mean over the hemisphere, weighted with the cosine
// returns    [1] rgb     albedo of the added lobe; the whole f_ms is reciprocal
real3 ms_kulla_conty(real3 f0, real e_v, real e_average) {
    real3 f_average = f0 * (real(20.0) / real(21.0)) + real3(real(1.0) / real(21.0));
    real3 bounces = real3(real(1.0)) - f_average * (real(1.0) - e_average);
    return f_average * f_average * ((real(1.0) - e_v) * e_average) / max(bounces, real3(DIVISOR_MIN));
}
