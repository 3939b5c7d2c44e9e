// A direction at right angles to another, without a branch at the poles; cross(n, across(n)) completes the frame.
//                                                               Duff et al. 2017, "Building an Orthonormal Basis,
//                                                               Revisited", JCGT 6(1), Listing 3
// n        unit
// returns  unit
real3 across(real3 n) {
    real s = n.z >= real(0.0) ? real(1.0) : real(-1.0);
    real a = real(-1.0) / (s + n.z);
    return real3(real(1.0) + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}
