// Smith's auxiliary function Lambda for Beckmann, times the cosine so that grazing angles stay finite.
//   Lambda = (erf(a) - 1) / 2 + exp(-a^2) / (2 a sqrt(pi)), a = 1 / (alpha tan(theta))       Heitz 2014, Eq. 66
// cosine   [0, 1]  of the direction to the shading normal
// alpha    (0, 1]  root mean square slope
// returns  [1]     Lambda * cosine >= 0
real lambda_beckmann(real cosine, real alpha) {
    real sine = safe_sqrt((real(1.0) - cosine) * (real(1.0) + cosine));
    real a_tan = max(alpha * sine, DIVISOR_MIN);
    real a = cosine / a_tan;
    // cosine / a is a_tan: no division by a cosine that may be 0.
    real tail = exp(-a * a) * a_tan / (real(2.0) * sqrt(PI));
    return max(tail - real(0.5) * cosine * (real(1.0) - erf(a)), real(0.0));
}
