// Energy compensation: how the lobe that Kulla and Conty add depends on the light's direction.
//   (1 - E_l) / (pi (1 - E_avg))                                Kulla & Conty 2017, slide 13
// e_l        [0, 1]  albedo of the single-scattering lobe at n.l with F = 1
// e_average  [0, 1]  its mean over the hemisphere, weighted with the cosine
// returns    [1/sr]  its integral over the hemisphere, times the cosine, is 1
real ms_kulla_conty_shape(real e_l, real e_average) {
    // Nothing is lost as roughness nears 0, and both sides of the fraction vanish.
    return (real(1.0) - e_l) / (PI * max(real(1.0) - e_average, real(1e-6)));
}
