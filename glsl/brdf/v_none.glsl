// Visibility with nothing hidden: G = 1, so only Cook-Torrance's divisor is left. For lessons: it gains energy.
//   V = 1 / (4 n.v n.l)                                         Cook & Torrance 1982; Walter et al. 2007, Eq. 20
// n_dot_v, n_dot_l  [0, 1]
// returns           [1]     finite also where a cosine is 0
real v_none(real n_dot_v, real n_dot_l) {
    return real(0.25) / max(n_dot_v * n_dot_l, DIVISOR_MIN);
}
