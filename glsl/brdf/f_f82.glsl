// Fresnel reflectance of metals: Schlick with a tint at 82 degrees.
//   F = F_S(u) - a u (1 - u)^6, a = F_S(1/7)(1 - tint) / (u_m (1 - u_m)^6) with u_m = 1/7
//                                                               Kutz, Hasan & Edmondson 2021, "Novel aspects of the
//                                                               Adobe Standard Material", Section 2.3
// f0         [0, 1] rgb  reflectance at normal incidence
// edge_tint  [0, 1] rgb  factor on Schlick's value at cosine 1/7; 1 gives Schlick
// v_dot_h    [0, 1]      u, cosine between view and half vector
// returns    [0, 1] rgb
real3 f_f82(real3 f0, real3 edge_tint, real v_dot_h) {
    // 1 / (u_m (1 - u_m)^6) = 7^7 / 6^6, and F_S(u_m) = F0 + (1 - F0)(6/7)^5.
    real scale = real(823543.0) / real(46656.0);
    real grazing_m = real(7776.0) / real(16807.0);
    real x = real(1.0) - v_dot_h;
    real x5 = x * x * x * x * x;
    real3 schlick = f0 * (real(1.0) - x5) + real3(x5);
    real3 schlick_m = f0 * (real(1.0) - grazing_m) + real3(grazing_m);
    real3 dip = schlick_m * (real3(real(1.0)) - edge_tint) * (scale * v_dot_h * x5 * x);
    return clamp(schlick - dip, real(0.0), real(1.0));
}
