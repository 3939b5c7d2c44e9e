// Sheen: Smith's Lambda for Charlie, by the authors' fit.
//   Lambda = exp(L(c)) below c = 1/2, else exp(2 L(1/2) - L(1 - c)); L(x) = a / (1 + b x^c) + d x + e
//   with each of a to e going from roughness 0 to 1 by (1 - r)^2     Estevez & Kulla 2017, Table 1 and Eq. 3
// cosine   [0, 1]
// alpha    (0, 1]   r of the paper
// returns  [1]      >= 0
real lambda_charlie_curve(real x, real blend) {
    real a = real(21.5473) + (real(25.3245) - real(21.5473)) * blend;
    real b = real(3.82987) + (real(3.32435) - real(3.82987)) * blend;
    real c = real(0.19823) + (real(0.16801) - real(0.19823)) * blend;
    real d = real(-1.97760) + (real(-1.27393) + real(1.97760)) * blend;
    real e = real(-4.32054) + (real(-4.85967) + real(4.32054)) * blend;
    return a / (real(1.0) + b * pow(max(x, DIVISOR_MIN), c)) + d * x + e;
}
real lambda_charlie(real cosine, real alpha) {
    real blend = (real(1.0) - alpha) * (real(1.0) - alpha);
    if (cosine < real(0.5)) return exp(lambda_charlie_curve(cosine, blend));
    return exp(real(2.0) * lambda_charlie_curve(real(0.5), blend) - lambda_charlie_curve(real(1.0) - cosine, blend));
}
