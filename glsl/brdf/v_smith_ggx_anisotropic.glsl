// Visibility for GGX with two widths: Smith's, correlated by height, over 4 (n.v)(n.l).
//   V = 0.5 / (l.z |(ax v.x, ay v.y, v.z)| + v.z |(ax l.x, ay l.y, l.z)|)      Heitz 2014, Eqs. 99, 72 and 86
// v, l     unit      in the surface's frame, z >= 0
// alpha    (0, 1]^2  widths along tangent and bitangent
// returns  [1]       >= 0
real v_smith_ggx_anisotropic(real3 v, real3 l, real2 alpha) {
    real vx = alpha.x * v.x;
    real vy = alpha.y * v.y;
    real lx = alpha.x * l.x;
    real ly = alpha.y * l.y;
    real view = l.z * sqrt(vx * vx + vy * vy + v.z * v.z);
    real light = v.z * sqrt(lx * lx + ly * ly + l.z * l.z);
    return real(0.5) / max(view + light, DIVISOR_MIN);
}
