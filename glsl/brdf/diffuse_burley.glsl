// Diffuse lobe: Burley's, with retro-reflection on rough surfaces.
//   f = color / pi (1 + (F90 - 1)(1 - n.l)^5)(1 + (F90 - 1)(1 - n.v)^5), F90 = 0.5 + 2 roughness (v.h)^2
//                                                               Burley 2012, Section 5.3
// color             [0, 1] rgb  albedo; the true albedo reaches 1.46 times that (roughness 1, grazing)
// roughness         [0, 1]      perceptual
// n_dot_v, n_dot_l  [0, 1]
// v_dot_h           [0, 1]      cosine of the difference angle, l.h = v.h
// returns           [1/sr] rgb
real3 diffuse_burley(real3 color, real roughness, real n_dot_v, real n_dot_l, real v_dot_h) {
    real rise = real(2.0) * roughness * v_dot_h * v_dot_h - real(0.5);  // F90 - 1
    real x_l = real(1.0) - n_dot_l;
    real x_v = real(1.0) - n_dot_v;
    real light = real(1.0) + rise * x_l * x_l * x_l * x_l * x_l;
    real view = real(1.0) + rise * x_v * x_v * x_v * x_v * x_v;
    return color * (light * view * (real(1.0) / PI));
}
