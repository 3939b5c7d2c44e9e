// Highlights that are wider one way than the other: GGX with two widths in the place of the distribution and masking chosen.

// alpha     (0, 1]  width across
// strength  [0, 1]
// returns   (0, 1]^2  widths along the direction and across it                      KHR_materials_anisotropy
real2 anisotropic_alpha(real alpha, real strength) {
    return real2(alpha + (real(1.0) - alpha) * strength * strength, alpha);
}

// returns  x: n.v, y: roughness of the isotropic lobe whose albedo stands for that of the two widths, seen from v.
//          Smith's masking sees the widths stretched: the lobe of their mean (in the power 1.8, which fits best) masks v as
//          much at the cosine found here. Over roughness, strength and v the albedo is off by 0.010 in the mean of
//          squares, by 0.05 at most.
real2 anisotropic_view(real3 v, real2 alpha) {
    real mean = pow(real(0.5) * (pow(alpha.x, real(1.8)) + pow(alpha.y, real(1.8))), real(1.0) / real(1.8));
    real seen = (v.x * v.x * alpha.x * alpha.x + v.y * v.y * alpha.y * alpha.y) / (mean * mean);
    return real2(v.z / sqrt(max(v.z * v.z + seen, DIVISOR_MIN)), sqrt(mean));
}

// returns  [1/sr]  D V, directions in the frame of the two widths
real anisotropic_d_v(real3 v, real3 l, real3 h, real2 alpha) {
    return d_ggx_anisotropic(h, alpha) * v_smith_ggx_anisotropic(v, l, alpha);
}
