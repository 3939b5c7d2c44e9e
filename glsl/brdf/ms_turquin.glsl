// Energy compensation: the factor that gives a specular lobe back what single scattering loses.
//   f_ms = f_ss (1 + F0 (1 - E(v)) / E(v))                      Turquin 2019, Eq. 16
// f0       [0, 1] rgb  reflectance at normal incidence
// e_v      (0, 1]      albedo of the lobe at n.v with F = 1
// returns  [1] rgb     >= 1. Exact where f0 is 1; not reciprocal, as it knows v only
real3 ms_turquin(real3 f0, real e_v) {
    return real3(real(1.0)) + f0 * ((real(1.0) - e_v) / max(e_v, DIVISOR_MIN));
}
