// Sheen: visibility that only keeps grazing angles finite.
//   V = 1 / (4 (n.l + n.v - n.l n.v))                            Neubelt & Pettineo 2013, "Crafting a Next-Gen Material
//                                                                Pipeline for The Order: 1886", p. 12
// n_dot_v, n_dot_l  [0, 1]
// returns           [1]     >= 0; it gains energy: the albedo reaches 1.74
real v_neubelt(real n_dot_v, real n_dot_l) {
    return real(1.0) / max(real(4.0) * (n_dot_l + n_dot_v - n_dot_l * n_dot_v), DIVISOR_MIN);
}
