// Point light: inverse square, with glTF's window.
//   E_perp = I / d^2 * sat(1 - (d / range)^4)                   KHR_lights_punctual, "Range Property"
// intensity_cd       rgb, candela
// distance2_m2       squared distance, clamped below at (1 cm)^2: the source is no smaller than that
// inverse_range2     1 / range^2; 0 where the light has no range
// returns            [lux] illuminance at normal incidence
// returns            [0, 1] what glTF's window leaves
real light_window(real distance2_m2, real inverse_range2) {
    real x = distance2_m2 * inverse_range2;
    return clamp(real(1.0) - x * x, real(0.0), real(1.0));
}
real3 light_point(real3 intensity_cd, real distance2_m2, real inverse_range2) {
    real d2 = max(distance2_m2, real(1e-4));
    return intensity_cd * (light_window(d2, inverse_range2) / d2);
}
