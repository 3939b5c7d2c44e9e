// Visibility for Beckmann: Smith's separable product, over 4 (n.v)(n.l).
//   V = 1 / (4 n.v (1 + Lambda(v)) n.l (1 + Lambda(l)))         Walter et al. 2007, Eq. 23; Heitz 2014, Eq. 66
// n_dot_v, n_dot_l            [0, 1]
// lambda_cos_v, lambda_cos_l  lambda_beckmann of each: Lambda times its cosine
// returns                     [1] >= 0
real v_smith_beckmann(real n_dot_v, real n_dot_l, real lambda_cos_v, real lambda_cos_l) {
    return real(0.25) / max((n_dot_v + lambda_cos_v) * (n_dot_l + lambda_cos_l), DIVISOR_MIN);
}
