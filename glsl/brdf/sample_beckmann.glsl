// Beckmann: a half vector by the distribution itself.
//   tan^2(theta) = -alpha^2 ln(1 - u), phi = 2 pi u'            Walter et al. 2007, Eqs. 28 and 29
// alpha    (0, 1]    root mean square slope
// u        [0, 1)^2  uniform
// returns  unit      h with z along the normal, of density D(h) (n.h) over solid angle; pdf_ndf
real3 sample_beckmann(real alpha, real2 u) {
    real tan2 = -alpha * alpha * log(max(real(1.0) - u.x, DIVISOR_MIN));
    real cosine = real(1.0) / sqrt(real(1.0) + tan2);
    real sine = sqrt(tan2) * cosine;
    real phi = real(2.0) * PI * u.y;
    return real3(sine * cos(phi), sine * sin(phi), cosine);
}
