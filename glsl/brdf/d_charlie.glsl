// Sheen: the "Charlie" distribution of fibres that stand up from the surface.
//   D(h) = (2 + 1 / alpha) sin(theta)^(1 / alpha) / (2 pi)       Estevez & Kulla 2017, "Production Friendly Microfacet
//                                                                Sheen BRDF", Eq. 2
// n_dot_h  [0, 1]
// alpha    (0, 1]   sheen roughness squared; the caller keeps it above 0.07^2, below which powers overflow
// returns  [1/sr]   >= 0; 0 at the normal
real d_charlie(real n_dot_h, real alpha) {
    real inverse = real(1.0) / max(alpha, DIVISOR_MIN);
    real sin2 = max((real(1.0) - n_dot_h) * (real(1.0) + n_dot_h), real(0.0));
    // pow(0, x) is 0 for every x here, but logarithms of 0 are not for every driver.
    real power = sin2 > real(0.0) ? pow(sin2, real(0.5) * inverse) : real(0.0);
    return (real(2.0) + inverse) * power / (real(2.0) * PI);
}
