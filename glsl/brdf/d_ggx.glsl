// GGX (Trowbridge-Reitz) normal distribution, isotropic.
//   D(h) = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)        Walter et al. 2007, Eq. 33
// n_dot_h  [0, 1]  cosine between shading normal and half vector
// alpha    (0, 1]  width of the distribution, roughness squared
// returns  [1/sr]  >= 0; the integral of D(h) (n.h) over the hemisphere is 1
real d_ggx(real n_dot_h, real alpha) {
    // (1 - c)(1 + c), not 1 - c*c: the latter cancels near the highlight.
    real sin2 = (real(1.0) - n_dot_h) * (real(1.0) + n_dot_h);
    real a_cos = alpha * n_dot_h;
    real k = alpha / max(sin2 + a_cos * a_cos, DIVISOR_MIN * DIVISOR_MIN);
    return k * k * (real(1.0) / PI);
}
