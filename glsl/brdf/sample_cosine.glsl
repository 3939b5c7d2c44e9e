// A direction of the hemisphere, as dense as its cosine: for diffuse lobes.
//   p(l) = (n.l) / pi                                           Malley 1988: a uniform disk, projected up
// u        [0, 1)^2  uniform
// returns  unit      l with z along the normal, z > 0
real3 sample_cosine(real2 u) {
    real radius = sqrt(u.x);
    real phi = real(2.0) * PI * u.y;
    return real3(radius * cos(phi), radius * sin(phi), sqrt(max(real(1.0) - u.x, DIVISOR_MIN)));
}
