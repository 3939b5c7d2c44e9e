// What every term may use, for GLSL; src/brdf/prelude.h is the same for C++.
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
const real PI = 3.14159265358979323846;
const real DIVISOR_MIN = 1e-7;        // keeps 0/0 out; far below any divisor that matters
const real DIELECTRIC_F0 = 0.04;      // common dielectrics (index 1.5) at normal incidence
const real ALBEDO_TABLE_SIZE = 48.0;  // texels a side, brdf/albedo.h
const real SHEEN_ROUGHNESS_MIN = 0.07;  // below it powers of d_charlie overflow
const real LOBE_SHARE_MIN = 0.1;      // of the samples, for a lobe that reflects anything at all
real sqr(real x) { return x * x; }
real safe_sqrt(real x) { return sqrt(max(x, 0.0)); }
// Error function, |error| < 1.5e-7: Abramowitz & Stegun 1964, Eq. 7.1.26. GLSL has none of its own.
real erf(real x) {
    real t = 1.0 / (1.0 + 0.3275911 * abs(x));
    real p = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
    return sign(x) * (1.0 - p * exp(-x * x));
}
