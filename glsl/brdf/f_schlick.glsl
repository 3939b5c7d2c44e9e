// Fresnel reflectance, Schlick's approximation.
//   F = F0 + (1 - F0)(1 - v.h)^5                                Schlick 1994, Eq. 15
// f0       [0, 1] rgb  reflectance at normal incidence
// v_dot_h  [0, 1]      cosine between view and half vector, not n.v
// returns  [1] rgb
real3 f_schlick(real3 f0, real v_dot_h) {
    real x = real(1.0) - v_dot_h;
    real x2 = x * x;
    real grazing = x2 * x2 * x;
    // F0 (1 - x^5) + x^5: the same sum, one multiply-add a channel.
    return f0 * (real(1.0) - grazing) + real3(grazing);
}
