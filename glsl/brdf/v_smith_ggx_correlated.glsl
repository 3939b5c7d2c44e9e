// Visibility for GGX: Smith's masking and shadowing, correlated by height, over 4 (n.v)(n.l).
//   G2 = 1 / (1 + Lambda(v) + Lambda(l)), Lambda = (sqrt(1 + alpha^2 tan^2(theta)) - 1) / 2
//                                                               Heitz 2014, Eqs. 99 and 72
//   V = G2 / (4 n.v n.l)
//     = 0.5 / (n.l sqrt(alpha^2 + (1 - alpha^2)(n.v)^2) + n.v sqrt(alpha^2 + (1 - alpha^2)(n.l)^2))
// n_dot_v, n_dot_l  [0, 1]
// alpha             (0, 1]  roughness squared
// returns           [1]     >= 0, finite also where both cosines are 0
real v_smith_ggx_correlated(real n_dot_v, real n_dot_l, real alpha) {
    real alpha2 = alpha * alpha;
    real view = n_dot_l * sqrt(alpha2 + (real(1.0) - alpha2) * n_dot_v * n_dot_v);
    real light = n_dot_v * sqrt(alpha2 + (real(1.0) - alpha2) * n_dot_l * n_dot_l);
    return real(0.5) / max(view + light, DIVISOR_MIN);
}
