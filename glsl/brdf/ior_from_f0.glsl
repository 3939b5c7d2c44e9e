// Index of refraction of the dielectric that reflects f0 at normal incidence, against vacuum.
//   n = (1 + sqrt(F0)) / (1 - sqrt(F0)), from F0 = ((n - 1) / (n + 1))^2        Born & Wolf 1999, Section 1.5.2
// f0       [0, 1)  reflectance; held below 1, where the index is infinite
// returns  [1, ..)
real ior_from_f0(real f0) {
    // 0.9999 is an index of 4e4: a mirror already, and no division by 0.
    real root = sqrt(clamp(f0, real(0.0), real(0.9999)));
    return (real(1.0) + root) / (real(1.0) - root);
}
