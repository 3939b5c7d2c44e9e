// Light from the far side of a surface (glsl/brdf/model/transmission.glsl): as rays found it at this very sample, else of the
// environment alone, as if nothing else were there. Without rays, what scatters light within is Lambert's surface of the colour
// that deep layers of it have.
#define FACET_FAR_SIDE (FACET_TRANSMISSION || FACET_DIFFUSE_TRANSMISSION)
#if FACET_FAR_SIDE
#if FACET_DIFFUSE_TRANSMISSION
bool is_deep(ShadePoint p) {
#if FACET_SAMPLE_LIGHT
    return false;
#else
    return p.surface.scattered != vec3(0.0);
#endif
}
#endif
// Factors on light that goes through, and on diffuse light.
BrdfValue far_weight(ShadePoint p, BrdfView brdf) {
    vec3 left = brdf_left(brdf) * left_by_layers();
    BrdfValue w = BrdfValue(vec3(0.0), vec3(0.0));
    float share = 1.0;
#if FACET_TRANSMISSION
    w.specular = left * p.surface.base_color * p.surface.transmission;
    share -= p.surface.transmission;
#endif
#if FACET_DIFFUSE_TRANSMISSION
    if (!is_deep(p)) w.diffuse = left * p.surface.far_color * (share * p.surface.far_share);
#endif
    return w;
}

#if FACET_SAMPLE_LIGHT
uniform sampler2D sample_far;  // rgb: nit, weighted

vec3 far_around(ShadePoint p, BrdfView brdf) { return texelFetch(sample_far, ivec2(gl_FragCoord.xy), 0).rgb; }
#else
vec3 far_around(ShadePoint p, BrdfView brdf) {
    vec3 nit = vec3(0.0);
#if FACET_ENVIRONMENT
    BrdfValue w = far_weight(p, brdf);
    nit = w.diffuse * irradiance_over_pi(-p.surface.normal);
#if FACET_TRANSMISSION
    vec3 way = -p.to_eye;
    if (p.surface.thickness_m > 0.0) {
        way = refracted(p.to_eye, p.surface.normal, max(p.surface.ior, 1.001));
        w.specular *= exp(-p.surface.absorbed_per_m * p.surface.thickness_m);
    }
    float level = p.surface.roughness * view.environment.x;
    nit += w.specular * textureLod(radiance_cube, in_box(p.position_m, way), level).rgb * view.environment.y;
#endif
#endif
    return nit;
}
#endif
#endif

// Of a light without a size behind the surface.
vec3 far_light(ShadePoint p, BrdfView brdf, vec3 to_light, vec3 illuminance) {
#if FACET_FAR_SIDE && !FACET_SAMPLE_LIGHT
    float behind = -dot(p.surface.normal, to_light);
    if (behind <= 0.0) return vec3(0.0);
    BrdfValue w = far_weight(p, brdf);
    vec3 through = vec3(0.0);
    // What is thin sends light on as it would reflect it, on the other side.
    vec3 above = to_light + p.surface.normal * (2.0 * behind);
    vec3 h = normalize(p.to_eye + above);
    float n_dot_h = clamp(dot(p.surface.normal, h), 0.0, 1.0);
    if (p.surface.roughness >= MIRROR_ROUGHNESS)
        through = w.specular * brdf_d_v(brdf, behind, n_dot_h) / max(brdf.a + brdf.b, 1e-3);
    vec3 arriving = illuminance * behind;
    vec3 nit = (w.diffuse / PI + through) * arriving;
#if FACET_LIGHT_PATHS
    paths.diffuse_direct += w.diffuse / PI * arriving;
    paths.specular_direct += through * arriving;
#endif
#ifdef FACET_EXPLAIN
    explained.far_nit.rgb += nit;
#endif
    return nit;
#else
    return vec3(0.0);
#endif
}
