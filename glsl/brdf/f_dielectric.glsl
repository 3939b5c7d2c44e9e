// Fresnel reflectance of a dielectric, exact, unpolarised.
//   F = (R_s + R_p) / 2, R_s = ((c_i - eta c_t) / (c_i + eta c_t))^2, R_p = ((eta c_i - c_t) / (eta c_i + c_t))^2
//   c_t^2 = 1 - (1 - c_i^2) / eta^2                             Born & Wolf 1999, Section 1.5.2
// v_dot_h  [0, 1]  c_i, the cosine on the side the light comes from
// eta      (0, ..) index of the far side over index of the near side; below 1 total reflection is possible
// returns  [0, 1]
real f_dielectric(real v_dot_h, real eta) {
    real cos2_t = real(1.0) - (real(1.0) - v_dot_h) * (real(1.0) + v_dot_h) / (eta * eta);
    if (cos2_t <= real(0.0)) return real(1.0);  // total reflection
    real c_t = sqrt(cos2_t);
    // Where both indices and both cosines meet (eta 1, grazing), divisor and dividend are 0: no reflection.
    real r_s = (v_dot_h - eta * c_t) / max(v_dot_h + eta * c_t, DIVISOR_MIN);
    real r_p = (eta * v_dot_h - c_t) / max(eta * v_dot_h + c_t, DIVISOR_MIN);
    return real(0.5) * (r_s * r_s + r_p * r_p);
}
