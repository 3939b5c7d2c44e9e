// Density of light directions where the half vector was drawn by the distribution itself.
//   p(l) = D(h) (n.h) / (4 v.h)                                 Walter et al. 2007, Eqs. 14 and 24
// d        [1/sr]  D(h)
// n_dot_h  [0, 1]
// v_dot_h  (0, 1]
// returns  [1/sr]  over l = reflect(-v, h)
real pdf_ndf(real d, real n_dot_h, real v_dot_h) { return d * n_dot_h / max(real(4.0) * v_dot_h, DIVISOR_MIN); }
