// Albedo of the energy-preserving Oren-Nayar lobe at one angle, for any colour.
//   E = color E(v) + color_ms (1 - E(v)), color_ms = color^2 E_avg / (1 - color (1 - E_avg))
//                                          Portsmouth, Kutz & Hill 2024, Eqs. 19 to 26; terms as in diffuse_eon
// color      [0, 1] rgb
// roughness  [0, 1]
// n_dot_v    [0, 1]
// returns    [0, 1] rgb  exactly 1 where color is 1
real3 diffuse_eon_albedo(real3 color, real roughness, real n_dot_v) {
    real scale = real(1.0) / (real(1.0) + (real(0.5) - real(2.0) / (real(3.0) * PI)) * roughness);
    real e_v = eon_albedo(n_dot_v, roughness, scale);
    real e_average =
        scale * (real(1.0) + roughness * (real(2.0) / real(3.0) - real(28.0) / (real(15.0) * PI)));
    real3 color_ms = color * color * e_average / (real3(real(1.0)) - color * (real(1.0) - e_average));
    return color * e_v + color_ms * (real(1.0) - e_v);
}
