// Visibility for GGX: Smith's separable product, over 4 (n.v)(n.l).
//   G = G1(v) G1(l), G1(x) = 2 n.x / (n.x + sqrt(alpha^2 + (1 - alpha^2)(n.x)^2))   Walter et al. 2007, Eqs. 23, 34
// n_dot_v, n_dot_l  [0, 1]
// alpha             (0, 1]  roughness squared
// returns           [1]     G / (4 n.v n.l) >= 0; darker than the height-correlated form, most at grazing angles
real v_smith_ggx(real n_dot_v, real n_dot_l, real alpha) {
    real alpha2 = alpha * alpha;
    real view = n_dot_v + sqrt(alpha2 + (real(1.0) - alpha2) * n_dot_v * n_dot_v);
    real light = n_dot_l + sqrt(alpha2 + (real(1.0) - alpha2) * n_dot_l * n_dot_l);
    return real(1.0) / max(view * light, DIVISOR_MIN);
}
