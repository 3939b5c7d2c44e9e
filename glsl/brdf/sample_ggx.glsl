// GGX: a half vector among those that the viewer sees, by spherical caps.
//   the view stretched by alpha, a uniform point of the cap it sees, stretched back
//                                                               Dupuy & Benyoub 2023, "Sampling Visible GGX Normals
//                                                               with Spherical Caps", Listing 3
// v        unit      to the viewer; z along the normal, v.z > 0
// alpha    [0, 1]    width of the distribution; 0 returns the normal
// u        [0, 1)^2  uniform
// returns  unit      h, of density G1(v) D(h) (v.h) / (n.v) over solid angle; pdf_ggx is that of the mirrored view
real3 sample_ggx(real3 v, real alpha, real2 u) {
    real3 stretched = normalize(real3(v.x * alpha, v.y * alpha, v.z));
    real phi = (real(2.0) * u.x - real(1.0)) * PI;
    real z = (real(1.0) - u.y) * (real(1.0) + stretched.z) - stretched.z;
    real sine = safe_sqrt((real(1.0) - z) * (real(1.0) + z));
    real3 h = real3(sine * cos(phi), sine * sin(phi), z) + stretched;
    return normalize(real3(h.x * alpha, h.y * alpha, max(h.z, DIVISOR_MIN)));
}
