// Lights with a size, in the open: as polygons, by linearly transformed cosines (glsl/light/polygon.glsl).
#include "light/across.glsl"
#include "light/polygon.glsl"
uniform sampler2D ltc_table;  // brdf/ltc.h

// Kinds in lights' fourth texel; frame/lighting/light_lists.h has the same numbers.
const float AREA_RECT = 1.0;
const float AREA_DISK = 2.0;
const float AREA_SPHERE = 3.0;
const float AREA_TUBE = 4.0;
const float LTC_TABLE_SIZE = 32.0;

// What of an area light is seen from the origin: flat, and turned to it with x, y and its facing side right-handed.
struct SeenArea {
    vec3 center;
    vec3 x;  // half axes, metres
    vec3 y;
    bool is_round;
    bool is_seen;
};

SeenArea seen_area(float kind, vec3 to_center, vec3 x, vec3 y) {
    SeenArea a = SeenArea(to_center, x, y, kind == AREA_DISK || kind == AREA_SPHERE, true);
    if (kind < AREA_SPHERE) {
        a.is_seen = dot(cross(x, y), to_center) < 0.0;
        return a;
    }
    // The tangents' circle of a ball, and the like of a tube: what is seen of both is as wide as that.
    vec3 axis = x * inversesqrt(max(dot(x, x), 1e-20));
    vec3 off = kind == AREA_SPHERE ? to_center : to_center - axis * dot(to_center, axis);
    float radius2 = dot(y, y);
    float distance2 = dot(off, off);
    a.is_seen = distance2 > radius2;
    float near = radius2 / max(distance2, 1e-20);
    float half_width = sqrt(radius2 * max(1.0 - near, 0.0));
    vec3 facing = -off * inversesqrt(max(distance2, 1e-20));
    a.center = to_center - off * near;
    if (kind == AREA_SPHERE) {
        axis = across(facing);
        a.x = axis * half_width;
    }
    a.y = cross(facing, axis) * half_width;
    return a;
}

// Shares of the hemisphere, of a cosine and of the mirroring lobe, that the light fills.
struct AreaShares {
    float diffuse;
    float specular;
};

// What is the same for every light.
struct AreaView {
    mat3 frame;  // x along the view's projection, z the normal
    vec4 cell;   // of the table
};
AreaView area_view(vec3 to_eye, vec3 normal, float roughness, float n_dot_v) {
    vec3 side = to_eye - normal * dot(to_eye, normal);
    float length2 = dot(side, side);
    vec3 x = length2 > 1e-8 ? side * inversesqrt(length2) : across(normal);
    float inner = (LTC_TABLE_SIZE - 1.0) / LTC_TABLE_SIZE;
    vec2 at = ltc_coordinates(n_dot_v, roughness) * inner + 0.5 / LTC_TABLE_SIZE;
    return AreaView(mat3(x, cross(normal, x), normal), textureLod(ltc_table, at, 0.0));
}

AreaShares area_shares(AreaView v, SeenArea a) {
    vec3 center = a.center * v.frame;
    vec3 half_x = a.x * v.frame;
    vec3 half_y = a.y * v.frame;
    // From corner to corner of a square, and of an octagon of the circle's area: its reach is sqrt(pi / sqrt(8)).
    vec2 turn = a.is_round ? vec2(0.7071068) : vec2(0.0, 1.0);
    vec3 first = a.is_round ? half_x * 1.0539074 : half_x + half_y;
    vec3 across_first = a.is_round ? half_y * 1.0539074 : half_y - half_x;
    int count = a.is_round ? 8 : 4;
    return AreaShares(polygon_share(center, first, across_first, turn, count),
                      polygon_share(ltc_transformed(v.cell, center), ltc_transformed(v.cell, first),
                                    ltc_transformed(v.cell, across_first), turn, count));
}

// w: the environment's weights. radiance_nit: of the light, windowed.
vec3 lit_by_area(AreaView point, BrdfValue w, SeenArea a, vec3 radiance_nit) {
    if (!a.is_seen) return vec3(0.0);
    AreaShares shares = area_shares(point, a);
    vec3 diffuse = w.diffuse * radiance_nit * shares.diffuse;
    vec3 specular = w.specular * radiance_nit * shares.specular;
#ifdef FACET_EXPLAIN
    // As if it all came at right angles: illuminance, and what of it each lobe sends on.
    vec3 lux = radiance_nit * (PI * shares.diffuse);
    float mirrored = shares.specular / max(PI * shares.diffuse, 1e-20);
    explain_lit(ExplainedLight(uvec4(0u), vec4(normalize(a.center), explain_distance_m), vec4(lux, 0.0),
                               vec4(1.0, 0.0, 0.0, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
                               vec4(w.diffuse / PI, 0.0), vec4(w.specular * mirrored, 0.0)));
#endif
#if FACET_LIGHT_PATHS
    paths.diffuse_direct += diffuse;
    paths.specular_direct += specular;
#endif
    return diffuse + specular;
}
