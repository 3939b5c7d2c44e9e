// Clearcoat: the lobe of a thin layer of lacquer. sample_ggx and pdf_ggx draw for it.
//   f = D V F, GGX, F0 = 0.04; what lies below is dimmed by 1 - clearcoat F(n.v)      KHR_materials_clearcoat
// n_dot_v, n_dot_l, n_dot_h, v_dot_h  [0, 1]  with the coat's own normal
// roughness                           (0, 1]  the coat's, perceptual
// returns                             [1/sr]
real clearcoat(real n_dot_v, real n_dot_l, real n_dot_h, real v_dot_h, real roughness) {
    real alpha = roughness * roughness;
    real3 f = f_schlick(real3(DIELECTRIC_F0), v_dot_h);
    return d_ggx(n_dot_h, alpha) * v_smith_ggx_correlated(n_dot_v, n_dot_l, alpha) * f.x;
}
