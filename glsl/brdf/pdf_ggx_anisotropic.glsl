// GGX with two widths: density of the light directions that sample_ggx_anisotropic leads to.
//   p(l) = G1(v) D(h) / (4 n.v), G1 = 2 v.z / (v.z + |(ax v.x, ay v.y, v.z)|)       Heitz 2018, Eq. 3 and Section 5
// v, h     unit      in the surface's frame; v.z > 0
// alpha    (0, 1]^2
// returns  [1/sr]    over l = reflect(-v, h)
real pdf_ggx_anisotropic(real3 v, real3 h, real2 alpha) {
    real x = alpha.x * v.x;
    real y = alpha.y * v.y;
    real root = sqrt(x * x + y * y + v.z * v.z);
    return d_ggx_anisotropic(h, alpha) * (real(0.5) / max(v.z + root, DIVISOR_MIN));
}
