// GGX with two widths: a half vector among those that the viewer sees, by spherical caps.
//                                                               Dupuy & Benyoub 2023, Listing 3; as sample_ggx
// v        unit      to the viewer; z along the normal, v.z > 0
// alpha    [0, 1]^2  widths along x and y
// u        [0, 1)^2  uniform
// returns  unit      h, of density G1(v) D(h) (v.h) / (n.v) over solid angle
real3 sample_ggx_anisotropic(real3 v, real2 alpha, real2 u) {
    real3 stretched = normalize(real3(v.x * alpha.x, v.y * alpha.y, v.z));
    real phi = (real(2.0) * u.x - real(1.0)) * PI;
    real z = (real(1.0) - u.y) * (real(1.0) + stretched.z) - stretched.z;
    real sine = safe_sqrt((real(1.0) - z) * (real(1.0) + z));
    real3 h = real3(sine * cos(phi), sine * sin(phi), z) + stretched;
    return normalize(real3(h.x * alpha.x, h.y * alpha.y, max(h.z, DIVISOR_MIN)));
}
