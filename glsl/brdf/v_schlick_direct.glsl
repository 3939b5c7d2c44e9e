// Visibility: Schlick's fit to Smith's product, with the k for lights of the lecture and of Karis 2013.
//   G = G1(v) G1(l), G1(x) = n.x / (n.x (1 - k) + k)            Schlick 1994, Eq. 19
//   k = (roughness + 1)^2 / 8                                   Karis 2013, Eq. 4
// n_dot_v, n_dot_l  [0, 1]
// roughness         [0, 1]  perceptual, not alpha: the "+ 1" was chosen to calm highlights, and loses energy
// returns           [1]     G / (4 n.v n.l)
real v_schlick_direct(real n_dot_v, real n_dot_l, real roughness) {
    real k = (roughness + real(1.0)) * (roughness + real(1.0)) / real(8.0);
    real view = n_dot_v * (real(1.0) - k) + k;
    real light = n_dot_l * (real(1.0) - k) + k;
    return real(0.25) / (view * light);
}
