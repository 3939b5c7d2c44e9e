// Density of the directions that sample_uniform draws.
// n_dot_l  the direction's cosine; below 0 nothing is drawn
// returns  [1/sr]
real pdf_uniform(real n_dot_l) { return n_dot_l >= real(0.0) ? real(0.5) / PI : real(0.0); }
