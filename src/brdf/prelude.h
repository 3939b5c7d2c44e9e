// What glsl/brdf may use, for C++: the functions of GLSL and of glsl/brdf/prelude.glsl, as members
// of Terms<Real>. Included inside the class, once. Members, because a member found first keeps
// overload resolution from looking at GLM's templates, which do not take a `real` beside a `real3`
// of another type. SPDX-License-Identifier: MIT
using real = Real;
using real2 = glm::vec<2, Real>;
using real3 = glm::vec<3, Real>;
using real4 = glm::vec<4, Real>;

static constexpr real PI = real(3.14159265358979323846);
static constexpr real DIVISOR_MIN = real(1e-7);
static constexpr real DIELECTRIC_F0 = real(0.04);
static constexpr real ALBEDO_TABLE_SIZE = real(48);
static constexpr real SHEEN_ROUGHNESS_MIN = real(0.07);
static constexpr real LOBE_SHARE_MIN = real(0.1);

static real sqr(real x) { return x * x; }
static real max(real a, real b) { return a < b ? b : a; }
static real min(real a, real b) { return b < a ? b : a; }
static real clamp(real x, real low, real high) { return min(max(x, low), high); }
static real sqrt(real x) { return std::sqrt(x); }
static real safe_sqrt(real x) { return std::sqrt(max(x, real(0))); }
static real exp(real x) { return std::exp(x); }
static real pow(real x, real y) { return std::pow(x, y); }
static real log(real x) { return std::log(x); }
static real cos(real x) { return std::cos(x); }
static real sin(real x) { return std::sin(x); }
static real acos(real x) { return std::acos(x); }
static real erf(real x) { return std::erf(x); }
static real dot(const real3& a, const real3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static real3 normalize(const real3& x) { return x * (real(1) / std::sqrt(dot(x, x))); }
static real abs(real x) { return std::fabs(x); }
static real3 cross(const real3& a, const real3& b) { return glm::cross(a, b); }
static real3 max(const real3& a, const real3& b) { return glm::max(a, b); }
static real3 clamp(const real3& x, real low, real high) { return glm::clamp(x, low, high); }
