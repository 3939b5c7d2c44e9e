// Beckmann normal distribution, isotropic.
//   D(h) = exp(-tan^2(theta) / alpha^2) / (pi alpha^2 cos^4(theta))        Walter et al. 2007, Eq. 25
// n_dot_h  [0, 1]  cos(theta), between shading normal and half vector
// alpha    (0, 1]  root mean square slope; looks like GGX's alpha near the peak only
// returns  [1/sr]  >= 0; 0, not NaN, where n_dot_h is 0
real d_beckmann(real n_dot_h, real alpha) {
    real cos2 = n_dot_h * n_dot_h;
    real sin2 = (real(1.0) - n_dot_h) * (real(1.0) + n_dot_h);
    // Below this the exponential has underflowed for every alpha <= 1 (exp(-1e4)), and cos^4 soon would.
    real safe_cos2 = max(cos2, real(1e-4));
    real alpha2 = max(alpha * alpha, DIVISOR_MIN * DIVISOR_MIN);
    return exp(-sin2 / (safe_cos2 * alpha2)) / (PI * alpha2 * safe_cos2 * safe_cos2);
}
