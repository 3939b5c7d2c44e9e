// Sphere light: directions within the cone that the sphere fills.
//   cos(theta) = 1 - u (1 - cos(theta_max)), p = 1 / (2 pi (1 - cos(theta_max))), sin(theta_max) = radius / distance
//                                                               Shirley, Wang & Zimmerman 1996, Section 3.2.1
//   radiance L = flux / (pi 4 pi radius^2)                      Lambert: physics of photometry, nit from lumen

// 1 - cos(theta_max), without cancelling where the sphere is far or small; 0 from inside, where nothing shines.
real sphere_cap(real distance2, real radius) {
    if (distance2 <= radius * radius) return real(0.0);
    real sin2 = radius * radius / distance2;
    return sin2 / (real(1.0) + safe_sqrt(real(1.0) - sin2));
}
// to_center  [m]       from the point that is lit
// u          [0, 1)^2  uniform
// returns    unit      to a place on the sphere's near side
real3 sample_sphere(real3 to_center, real radius, real2 u) {
    real distance2 = dot(to_center, to_center);
    real3 n = to_center * (real(1.0) / sqrt(max(distance2, DIVISOR_MIN * DIVISOR_MIN)));
    real below = u.x * sphere_cap(distance2, radius);  // 1 - cos(theta)
    real sine = safe_sqrt(below * (real(2.0) - below));
    real phi = real(2.0) * PI * u.y;
    real3 x = across(n);
    real3 y = cross(n, x);
    return n * (real(1.0) - below) + x * (sine * cos(phi)) + y * (sine * sin(phi));
}
// returns  [1/sr]  density of sample_sphere; 0 from inside
real pdf_sphere(real distance2, real radius) {
    real cap = sphere_cap(distance2, radius);
    return cap > real(0.0) ? real(1.0) / (real(2.0) * PI * cap) : real(0.0);
}
// returns  [m]  to the near side along a unit direction; -1 where it is missed or the point is inside
real hit_sphere(real3 to_center, real radius, real3 direction) {
    real along = dot(to_center, direction);
    real3 off = to_center - direction * along;  // not distance^2 - along^2, which cancels far away
    real beside2 = dot(off, off);
    if (along <= real(0.0) || beside2 > radius * radius || dot(to_center, to_center) <= radius * radius)
        return real(-1.0);
    return along - safe_sqrt(radius * radius - beside2);
}
