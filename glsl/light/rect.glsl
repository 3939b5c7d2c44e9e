// Rectangle light: one-sided, sampled by solid angle.
//   Urena, Fajardo & King 2013, "An Area-Preserving Parametrization for Spherical Rectangles", CGF 32(4), Section 4
//   radiance L = flux / (pi width height)

// A rectangle as a point sees it, in the rectangle's axes; z points from the point to its plane.
struct RectView {
    real x0;
    real x1;
    real y0;
    real y1;
    real z0;           // < 0, the paper's sign
    real b0;
    real b1;
    real k;
    real solid_angle;  // [sr]; 0 from behind and from within the plane
};

real unit_clamped(real x) { return clamp(x, real(-1.0), real(1.0)); }

// to_center      [m]   from the point that is lit
// x, y, normal   unit  the rectangle's axes and the side it shines to
// width, height  [m]   along x and y
RectView rect_view(real3 to_center, real3 x, real3 y, real3 normal, real width, real height) {
    RectView v;
    real cx = dot(to_center, x);
    real cy = dot(to_center, y);
    v.x0 = cx - real(0.5) * width;
    v.x1 = cx + real(0.5) * width;
    v.y0 = cy - real(0.5) * height;
    v.y1 = cy + real(0.5) * height;
    v.z0 = dot(to_center, normal);
    v.b0 = real(0.0);
    v.b1 = real(0.0);
    v.k = real(0.0);
    v.solid_angle = real(0.0);
    if (v.z0 >= -DIVISOR_MIN) return v;
    // Normals of the four sides' planes through the point: n0 below, n1 right, n2 above, n3 left.
    real z2 = v.z0 * v.z0;
    real n0z = -v.y0 / sqrt(v.y0 * v.y0 + z2);
    real n1z = v.x1 / sqrt(v.x1 * v.x1 + z2);
    real n2z = v.y1 / sqrt(v.y1 * v.y1 + z2);
    real n3z = -v.x0 / sqrt(v.x0 * v.x0 + z2);
    real g0 = acos(unit_clamped(-n0z * n1z));
    real g1 = acos(unit_clamped(-n1z * n2z));
    real g2 = acos(unit_clamped(-n2z * n3z));
    real g3 = acos(unit_clamped(-n3z * n0z));
    v.b0 = n0z;
    v.b1 = n2z;
    v.k = real(2.0) * PI - g2 - g3;
    v.solid_angle = max(g0 + g1 - v.k, real(0.0));
    return v;
}

// u        [0, 1)^2  uniform
// returns  [m]       place of the rectangle along x and y, and its distance along z (negative), from the point
real3 sample_rect(RectView v, real2 u) {
    real au = u.x * v.solid_angle + v.k;
    real sine = sin(au);
    real fu = (cos(au) * v.b0 - v.b1) / (abs(sine) > DIVISOR_MIN ? sine : DIVISOR_MIN);
    real cu = unit_clamped((fu > real(0.0) ? real(1.0) : real(-1.0)) / sqrt(fu * fu + v.b0 * v.b0));
    real xu = clamp(-(cu * v.z0) / max(safe_sqrt(real(1.0) - cu * cu), DIVISOR_MIN), v.x0, v.x1);
    real d2 = xu * xu + v.z0 * v.z0;
    real h0 = v.y0 / sqrt(d2 + v.y0 * v.y0);
    real h1 = v.y1 / sqrt(d2 + v.y1 * v.y1);
    real hv = h0 + u.y * (h1 - h0);
    real hv2 = hv * hv;
    real yv = hv2 < real(1.0) - DIVISOR_MIN ? hv * sqrt(d2) / sqrt(real(1.0) - hv2) : v.y1;
    return real3(xu, clamp(yv, v.y0, v.y1), v.z0);
}
// returns  [m]  along a unit direction; -1 from behind and beside it
real hit_rect(real3 to_center, real3 x, real3 y, real3 normal, real width, real height, real3 direction) {
    real distance = hit_plane(to_center, normal, direction);
    real3 off = direction * distance - to_center;
    bool inside = abs(dot(off, x)) <= real(0.5) * width && abs(dot(off, y)) <= real(0.5) * height;
    return distance > real(0.0) && inside ? distance : real(-1.0);
}
