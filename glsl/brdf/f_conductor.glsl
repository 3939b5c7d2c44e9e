// Fresnel reflectance of a conductor, exact, unpolarised, light from vacuum.
//   a^2 + b^2 = sqrt((n^2 - k^2 - sin^2)^2 + 4 n^2 k^2), a^2 = (a^2 + b^2 + n^2 - k^2 - sin^2) / 2
//   R_s = (a^2 + b^2 - 2 a c + c^2) / (a^2 + b^2 + 2 a c + c^2)
//   R_p = R_s (c^2 (a^2 + b^2) - 2 a c sin^2 + sin^4) / (c^2 (a^2 + b^2) + 2 a c sin^2 + sin^4)
//                                                               Born & Wolf 1999, Section 14.2
// v_dot_h  [0, 1]  c, cosine between view and half vector
// n, k     >= 0    real and imaginary part of the index n + ik, at one wavelength
// returns  [0, 1]
real f_conductor(real v_dot_h, real n, real k) {
    real cos2 = v_dot_h * v_dot_h;
    real sin2 = real(1.0) - cos2;
    real difference = n * n - k * k - sin2;
    real sum = sqrt(difference * difference + real(4.0) * n * n * k * k);
    // The sum cancels where k is small and n below the sine; the root must not see a negative.
    real a = safe_sqrt(real(0.5) * (sum + difference));
    real cross_s = real(2.0) * a * v_dot_h;
    real r_s = (sum - cross_s + cos2) / max(sum + cross_s + cos2, DIVISOR_MIN);
    real even_p = cos2 * sum + sin2 * sin2;
    real r_p = r_s * (even_p - cross_s * sin2) / max(even_p + cross_s * sin2, DIVISOR_MIN);
    return real(0.5) * (r_s + r_p);
}
