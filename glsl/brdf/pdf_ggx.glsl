// GGX: density of the light directions that sample_ggx leads to.
//   p(l) = G1(v) D(h) / (4 n.v), G1 = 2 n.v / (n.v + sqrt(alpha^2 + (1 - alpha^2)(n.v)^2))
//                                                               Heitz 2018, "Sampling the GGX Distribution of Visible
//                                                               Normals", Eq. 3 and Section 5
// n_dot_v  (0, 1]
// n_dot_h  [0, 1]
// alpha    (0, 1]
// returns  [1/sr]  over l = reflect(-v, h)
real pdf_ggx(real n_dot_v, real n_dot_h, real alpha) {
    real alpha2 = alpha * alpha;
    real root = sqrt(alpha2 + (real(1.0) - alpha2) * n_dot_v * n_dot_v);
    return d_ggx(n_dot_h, alpha) * (real(0.5) / max(n_dot_v + root, DIVISOR_MIN));
}
