// Polygon light: illuminance in closed form, and with the lobe's inverse matrix before it what a glossy surface
// mirrors of it (linearly transformed cosines).
//   E / (pi L) = 1 / (2 pi) sum theta_i (v_i x v_i+1 / |v_i x v_i+1|) . n                   Lambert 1760; Baum et al. 1989
//   specular / L = albedo times the same of the polygon's corners times M^-1                 Heitz et al. 2016, Eq. 9
// All in a surface's frame with its normal along z; what is below the horizon is cut off.

// z of theta (a x b) / |a x b| / (2 pi), with theta / sin(theta) as a quotient: Hill & Heitz 2017, "Real-Time Area
// Lighting: a Journey from Research to Production", p. 30; float's acos is too rough for it.
real polygon_edge(real3 a, real3 b) {
    real inverse = real(1.0) / sqrt(max(dot(a, a) * dot(b, b), DIVISOR_MIN * DIVISOR_MIN * DIVISOR_MIN));
    real x = clamp(dot(a, b) * inverse, real(-1.0), real(1.0));
    real y = abs(x);
    real v = (real(0.8543985) + (real(0.4965155) + real(0.0145206) * y) * y) /
             (real(3.4175940) + (real(4.1616724) + y) * y);
    real ratio = x > real(0.0) ? v : real(0.5) / sqrt(max(real(1.0) - x * x, DIVISOR_MIN)) - v;
    return (a.x * b.y - a.y * b.x) * (inverse * ratio);
}

// center, u, v  [m]      the first corner is center + u; u and v turn by the angle whose cosine and sine `turn` has
// count                  corners; they go backwards around the side that shines, as that is seen from before
// returns       [0, 1]   share of a hemisphere full of such light
real polygon_share(real3 center, real3 u, real3 v, real2 turn, int count) {
    real3 from = center + u * turn.x + v * turn.y;
    real3 leaving = real3(real(0.0));  // where the outline goes below the horizon, and
    real3 rising = real3(real(0.0));   // where it comes up again
    bool is_cut = false;
    real sum = real(0.0);
    for (int i = 0; i < count; ++i) {
        real3 to = center + u;
        bool is_from_up = from.z > real(0.0);
        bool is_to_up = to.z > real(0.0);
        bool is_crossing = is_from_up != is_to_up;
        real3 crossing = from + (to - from) * (is_crossing ? from.z / (from.z - to.z) : real(0.0));
        if (is_from_up || is_to_up)
            sum += polygon_edge(is_from_up ? from : crossing, is_to_up ? to : crossing);
        if (is_crossing) {
            is_cut = true;
            if (is_from_up)
                leaving = crossing;
            else
                rising = crossing;
        }
        from = to;
        real3 turned = u * turn.x - v * turn.y;
        v = v * turn.x + u * turn.y;
        u = turned;
    }
    // Along the horizon back to where it rises.
    if (is_cut) sum += polygon_edge(leaving, rising);
    return max(sum, real(0.0));
}

// Where the table (brdf/ltc.h) holds a direction and a roughness, as coordinates in [0, 1]^2.
real2 ltc_coordinates(real n_dot_v, real roughness) {
    return real2(roughness, safe_sqrt(real(1.0) - n_dot_v));
}
// A direction of the surface's frame, x along the view's projection, as the cosine has it. `cell` is the table's.
real3 ltc_transformed(real4 cell, real3 v) {
    return real3(cell.x * v.x + cell.y * v.z, v.y, cell.z * v.x + cell.w * v.z);
}
