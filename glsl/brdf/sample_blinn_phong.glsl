// Blinn-Phong: a half vector by the distribution itself.
//   cos(theta) = u^(1 / (s + 2)), s = 2 / alpha^2 - 2           Walter et al. 2007, Eqs. 31 and 32
// alpha    (0, 1]    width
// u        [0, 1)^2  uniform
// returns  unit      h with z along the normal, of density D(h) (n.h) over solid angle; pdf_ndf
real3 sample_blinn_phong(real alpha, real2 u) {
    real cosine = pow(max(real(1.0) - u.x, DIVISOR_MIN), real(0.5) * alpha * alpha);
    real sine = safe_sqrt((real(1.0) - cosine) * (real(1.0) + cosine));
    real phi = real(2.0) * PI * u.y;
    return real3(sine * cos(phi), sine * sin(phi), cosine);
}
