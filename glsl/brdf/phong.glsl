// Phong's lobe around the mirrored view. For lessons: what came before half vectors.
//   f = (s + 1) / (2 pi) (r.l)^s                                Phong 1975; the norm as Lewis 1994, Section 3
// r_dot_l   [0, 1]  cosine between the light and the view mirrored at the surface
// exponent  [0, ..) s
// returns   [1/sr]  its integral over the directions around r is 1
real phong(real r_dot_l, real exponent) {
    // pow(0, 0) is undefined in GLSL.
    return (exponent + real(1.0)) / (real(2.0) * PI) * pow(max(r_dot_l, DIVISOR_MIN), exponent);
}
