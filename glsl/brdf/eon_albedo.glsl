// Albedo of the single-scattering part of energy-preserving Oren-Nayar, for white.
//   E(mu) = A (1 + r G(mu) / pi)
//   G(mu) = sin (acos(mu) - sin mu) + 2/3 ((sin / mu)(1 - sin^3) - sin)
//                                          Portsmouth, Kutz & Hill 2024, "EON: a practical energy-preserving rough
//                                          diffuse BRDF", Eqs. 14 to 16
// mu         [0, 1]  cosine of the direction
// roughness  [0, 1]
// scale              A = 1 / (1 + (1/2 - 2/(3 pi)) r)
// returns    [0, 1]
real eon_albedo(real mu, real roughness, real scale) {
    real sine = safe_sqrt((real(1.0) - mu) * (real(1.0) + mu));
    // (1 - sin^3) / mu = mu (1 + sin + sin^2) / (1 + sin): no 0/0 at grazing.
    real ratio = mu * (real(1.0) + sine + sine * sine) / (real(1.0) + sine);
    real g = sine * (acos(clamp(mu, real(-1.0), real(1.0))) - sine * mu) +
             real(2.0) / real(3.0) * sine * (ratio - real(1.0));
    return scale * (real(1.0) + roughness * g / PI);
}
