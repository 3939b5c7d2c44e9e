// Density of the directions that sample_cosine draws.
//   p(l) = (n.l) / pi                                           Malley 1988
// n_dot_l  [0, 1]
// returns  [1/sr]
real pdf_cosine(real n_dot_l) { return n_dot_l * (real(1.0) / PI); }
