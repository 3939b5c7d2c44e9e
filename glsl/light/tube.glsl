// Tube light: the side of a cylinder, without its ends, sampled by the part of its area that is turned to the point.
//   p = distance^2 / (area cos(theta)), area = length 2 radius acos(radius / distance from the axis)
//   radiance L = flux / (pi 2 pi radius length)

// What of the tube's girth faces a point this far from its axis, as half an angle around the axis. 0 from inside.
real tube_half_angle(real from_axis, real radius) {
    return from_axis > radius ? acos(radius / from_axis) : real(0.0);
}
// Where a point lies from the axis: unit, towards the axis' nearest place from the point; w in real4: the distance.
real4 tube_way(real3 to_center, real3 axis) {
    real3 off = to_center - axis * dot(to_center, axis);
    real distance = sqrt(max(dot(off, off), DIVISOR_MIN * DIVISOR_MIN));
    real3 unit = off * (real(1.0) / distance);
    return real4(unit.x, unit.y, unit.z, distance);
}
// to_center  [m]       from the point that is lit to the middle of the axis
// u          [0, 1)^2  uniform
// returns    unit      outward normal of a place on the side; the place is to_center + axis along + normal radius with
//                      along = (u.y - 1/2) length
real3 sample_tube_normal(real3 to_center, real3 axis, real radius, real2 u) {
    real4 way = tube_way(to_center, axis);
    real angle = (real(2.0) * u.x - real(1.0)) * tube_half_angle(way.w, radius);
    real3 facing = real3(-way.x, -way.y, -way.z);
    return facing * cos(angle) + cross(axis, facing) * sin(angle);
}
// returns  [m^2]  that sample_tube_normal spreads its places over
real tube_area(real3 to_center, real3 axis, real radius, real length) {
    return length * real(2.0) * radius * tube_half_angle(tube_way(to_center, axis).w, radius);
}
// returns  [m]  along a unit direction to the near side; -1 where it is missed
real hit_tube(real3 to_center, real3 axis, real radius, real length, real3 direction) {
    real along = dot(direction, axis);
    real3 d = direction - axis * along;
    real3 o = to_center - axis * dot(to_center, axis);
    real a = dot(d, d);
    if (a < DIVISOR_MIN || dot(o, o) <= radius * radius) return real(-1.0);
    real b = dot(o, d);
    real3 off = o - d * (b / a);
    real left2 = radius * radius - dot(off, off);
    if (b <= real(0.0) || left2 < real(0.0)) return real(-1.0);
    real distance = (b - sqrt(left2 * a)) / a;
    real height = distance * along - dot(to_center, axis);
    return abs(height) <= real(0.5) * length ? distance : real(-1.0);
}
