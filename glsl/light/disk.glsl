// Disk light: one-sided, sampled by area.
//   p = distance^2 / (area cos(theta)), area = pi radius^2      Shirley, Wang & Zimmerman 1996, Section 3
//   radiance L = flux / (pi area)

// x, y     unit      of the disk's plane
// u        [0, 1)^2  uniform
// returns  [m]       a place of the disk, from its centre
real3 sample_disk(real3 x, real3 y, real radius, real2 u) {
    real r = radius * sqrt(u.x);
    real phi = real(2.0) * PI * u.y;
    return x * (r * cos(phi)) + y * (r * sin(phi));
}
// Density over directions of what is uniform over an area.
// area       [m^2]
// distance2  [m^2]   to the place
// cosine     [0, 1]  between the area's normal there and the way back
// returns    [1/sr]  0 from behind
real pdf_area(real area, real distance2, real cosine) {
    return cosine > real(0.0) ? distance2 / max(area * cosine, DIVISOR_MIN * DIVISOR_MIN) : real(0.0);
}
// returns  [m]  along a unit direction to the plane through to_center with this normal; -1 from behind and beside it
real hit_plane(real3 to_center, real3 normal, real3 direction) {
    real cosine = -dot(normal, direction);
    real height = -dot(normal, to_center);
    return cosine > DIVISOR_MIN && height > real(0.0) ? height / cosine : real(-1.0);
}
real hit_disk(real3 to_center, real3 normal, real radius, real3 direction) {
    real distance = hit_plane(to_center, normal, direction);
    real3 off = direction * distance - to_center;
    return distance > real(0.0) && dot(off, off) <= radius * radius ? distance : real(-1.0);
}
