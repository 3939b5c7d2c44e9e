// Blinn-Phong as a normal distribution, with the exponent that gives the width alpha. For lessons.
//   D(h) = (s + 2) / (2 pi) (n.h)^s, s = 2 / alpha^2 - 2       Blinn 1977; Walter et al. 2007, Eq. 30
// n_dot_h  [0, 1]  cosine between shading normal and half vector
// alpha    (0, 1]  width; Walter et al. match it to Beckmann's
// returns  [1/sr]  >= 0; the integral of D(h) (n.h) over the hemisphere is 1
real d_blinn_phong(real n_dot_h, real alpha) {
    real exponent = real(2.0) / max(alpha * alpha, DIVISOR_MIN) - real(2.0);
    // pow(0, 0) is undefined in GLSL.
    return (exponent + real(2.0)) / (real(2.0) * PI) * pow(max(n_dot_h, DIVISOR_MIN), exponent);
}
