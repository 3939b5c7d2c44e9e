// Sheen: visibility for Charlie.
//   V = 1 / ((1 + Lambda(v) + Lambda(l)) 4 n.v n.l)              Estevez & Kulla 2017, Section 4
// n_dot_v, n_dot_l  [0, 1]
// alpha             (0, 1]
// returns           [1]     >= 0; with smooth fibres the albedo passes 1 at grazing angles
real v_charlie(real n_dot_v, real n_dot_l, real alpha) {
    real sum = real(1.0) + lambda_charlie(n_dot_v, alpha) + lambda_charlie(n_dot_l, alpha);
    return real(1.0) / max(sum * real(4.0) * n_dot_v * n_dot_l, DIVISOR_MIN);
}
