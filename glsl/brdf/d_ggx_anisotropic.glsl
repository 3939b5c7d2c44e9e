// GGX normal distribution with two widths.
//   D(h) = 1 / (pi ax ay ((h.x / ax)^2 + (h.y / ay)^2 + h.z^2)^2)       Burley 2012, Eq. 13; Heitz 2014, Eq. 85
// h        unit      half vector in the surface's frame: x tangent, y bitangent, z normal
// alpha    (0, 1]^2  widths along tangent and bitangent
// returns  [1/sr]    >= 0; the integral of D(h) h.z over the hemisphere is 1
real d_ggx_anisotropic(real3 h, real2 alpha) {
    real x = h.x / alpha.x;
    real y = h.y / alpha.y;
    real sum = max(x * x + y * y + h.z * h.z, DIVISOR_MIN);
    return real(1.0) / (PI * alpha.x * alpha.y * sum * sum);
}
