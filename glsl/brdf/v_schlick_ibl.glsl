// Visibility: Schlick's fit to Smith's product, with the k for environment light of the lecture and of Karis 2013.
//   G = G1(v) G1(l), G1(x) = n.x / (n.x (1 - k) + k)            Schlick 1994, Eq. 19
//   k = roughness^2 / 2                                         Karis 2013, page 4
// n_dot_v, n_dot_l  [0, 1]
// roughness         [0, 1]  perceptual, so k is alpha / 2
// returns           [1]     G / (4 n.v n.l)
real v_schlick_ibl(real n_dot_v, real n_dot_l, real roughness) {
    real k = roughness * roughness * real(0.5);
    real view = n_dot_v * (real(1.0) - k) + k;
    real light = n_dot_l * (real(1.0) - k) + k;
    return real(0.25) / max(view * light, DIVISOR_MIN);
}
