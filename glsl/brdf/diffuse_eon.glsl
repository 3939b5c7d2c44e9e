// Diffuse lobe: energy-preserving Oren-Nayar (EON), with its multiple scattering.
//   f_ss = color / pi A (1 + r s / t), A = 1 / (1 + (1/2 - 2/(3 pi)) r)
//   s = v.l - n.v n.l, t = max(n.v, n.l) if s > 0 else 1
//   f_ms = color_ms / pi (1 - E(v))(1 - E(l)) / (1 - E_avg), color_ms = color^2 E_avg / (1 - color (1 - E_avg))
//   E: eon_albedo, E_avg = A (1 + r (2/3 - 28/(15 pi)))
//                                          Portsmouth, Kutz & Hill 2024, "EON: a practical energy-preserving rough
//                                          diffuse BRDF", Eqs. 12 to 26
// color             [0, 1] rgb  albedo; the albedo is exactly 1 where it is 1
// roughness         [0, 1]      EON's own, here the surface's perceptual one
// n_dot_v, n_dot_l  [0, 1]
// v_dot_l           [-1, 1]
// returns           [1/sr] rgb
real3 diffuse_eon(real3 color, real roughness, real n_dot_v, real n_dot_l, real v_dot_l) {
    real scale = real(1.0) / (real(1.0) + (real(0.5) - real(2.0) / (real(3.0) * PI)) * roughness);
    real s = v_dot_l - n_dot_v * n_dot_l;
    real t = s > real(0.0) ? max(max(n_dot_v, n_dot_l), DIVISOR_MIN) : real(1.0);
    real3 single = color * (scale * (real(1.0) + roughness * s / t) / PI);
    real e_v = eon_albedo(n_dot_v, roughness, scale);
    real e_l = eon_albedo(n_dot_l, roughness, scale);
    real e_average =
        scale * (real(1.0) + roughness * (real(2.0) / real(3.0) - real(28.0) / (real(15.0) * PI)));
    real lost = max(real(1.0) - e_average, DIVISOR_MIN);  // 0 at roughness 0, where nothing is lost either
    real3 color_ms = color * color * e_average / (real3(real(1.0)) - color * (real(1.0) - e_average));
    real shape = max(real(1.0) - e_v, real(0.0)) * max(real(1.0) - e_l, real(0.0)) / (PI * lost);
    return single + color_ms * shape;
}
