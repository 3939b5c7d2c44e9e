// Energy compensation: the share of light that leaves after more than one bounce, spread like a diffuse lobe.
//   F_ms E_ms, F_ms = F_ss F_avg / (1 - F_avg E_ms), E_ms = 1 - (A + B), F_ss = F0 A + B
//                                                               Fdez-Aguera 2019, Eqs. 12 to 17
//   F_avg = F0 + (1 - F0) / 21 for Schlick's Fresnel
// f0       [0, 1] rgb  reflectance at normal incidence
// a, b     [0, 1]      the split sum's two terms at n.v
// returns  [1] rgb     albedo of the added lobe
real3 ms_fdez_aguera(real3 f0, real a, real b) {
    real lost = max(real(1.0) - (a + b), real(0.0));
    real3 f_single = f0 * a + real3(b);
    real3 f_average = f0 * (real(20.0) / real(21.0)) + real3(real(1.0) / real(21.0));
    return f_single * f_average * lost / (real3(real(1.0)) - f_average * lost);
}
