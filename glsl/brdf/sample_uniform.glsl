// A direction of the hemisphere, as dense everywhere: for sheen, whose fibres shine at grazing angles, where a draw by
// the cosine hardly goes.
//   p(l) = 1 / (2 pi)                                            Pharr, Jakob & Humphreys 2023, Appendix A.5.2
// u        [0, 1)^2  uniform
// returns  unit      l with z along the normal
real3 sample_uniform(real2 u) {
    real sine = safe_sqrt((real(1.0) - u.x) * (real(1.0) + u.x));
    real phi = real(2.0) * PI * u.y;
    return real3(sine * cos(phi), sine * sin(phi), u.x);
}
