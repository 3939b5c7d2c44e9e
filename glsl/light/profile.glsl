// Where a light profile (IES LM-63, type C) is looked up: its polar angle from straight ahead, and the azimuth around that.
// direction   unit, from the lamp to the surface
// x, y, z     unit axes of the lamp; it shines along z, and azimuth 0 is x, 90 degrees y
// returns     [0, 1]^2 polar angle by 180 degrees, azimuth by 360
real2 profile_place(real3 direction, real3 x, real3 y, real3 z) {
    real ahead = clamp(dot(direction, z), real(-1.0), real(1.0));
    real across = dot(direction, x);
    real along = dot(direction, y);
    real aside = max(sqrt(across * across + along * along), real(1e-9));
    real azimuth = acos(clamp(across / aside, real(-1.0), real(1.0)));
    azimuth = along < real(0.0) ? real(2.0) * PI - azimuth : azimuth;
    return real2(acos(ahead) / PI, azimuth / (real(2.0) * PI));
}
