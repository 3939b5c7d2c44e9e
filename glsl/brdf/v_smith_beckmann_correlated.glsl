// Visibility for Beckmann: Smith's masking and shadowing, correlated by height, over 4 (n.v)(n.l).
//   V = 1 / (4 n.v n.l (1 + Lambda(v) + Lambda(l)))             Heitz 2014, Eqs. 99 and 66
// n_dot_v, n_dot_l            [0, 1]
// lambda_cos_v, lambda_cos_l  lambda_beckmann of each: Lambda times its cosine
// returns                     [1] >= 0
real v_smith_beckmann_correlated(real n_dot_v, real n_dot_l, real lambda_cos_v, real lambda_cos_l) {
    real cosines = n_dot_v * n_dot_l + lambda_cos_v * n_dot_l + lambda_cos_l * n_dot_v;
    return real(0.25) / max(cosines, DIVISOR_MIN);
}
