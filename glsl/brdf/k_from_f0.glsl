// Extinction coefficient of a conductor of index 1 + ik that reflects f0 at normal incidence.
//   F0 = ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), so with n = 1: k = 2 sqrt(F0 / (1 - F0))   Born & Wolf 1999, Section 14.2
// One reflectance cannot give both n and k. n = 1 always has a solution and is close to aluminium (1.0 + 6.6i).
// f0       [0, 1)  reflectance; held below 1, where k is infinite
// returns  >= 0
real k_from_f0(real f0) {
    real safe = clamp(f0, real(0.0), real(0.9999));
    return real(2.0) * sqrt(safe / (real(1.0) - safe));
}
