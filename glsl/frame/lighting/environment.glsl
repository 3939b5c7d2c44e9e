// What the baked environment, or a probe of the scene, sends to a surface. Included by shade.glsl.
vec3 irradiance_over_pi(vec3 n) { return textureLod(irradiance_cube, n, 0.0).rgb * view.environment.y; }

// Where a probe sees what a surface mirrors, if that stands on the sides of the box (Lagarde & Zanuttini 2012, "Local
// Image-Based Lighting with Parallax-Corrected Cubemaps"); the direction itself without a probe, or from outside.
vec3 in_box(vec3 position_m, vec3 direction) {
    bool inside = all(greaterThan(position_m, view.box_low.xyz - 1e-3)) && all(lessThan(position_m, view.box_high.xyz + 1e-3));
    if (view.box_low.w < 0.5 || !inside) return direction;
    vec3 safe = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    vec3 way = max((view.box_low.xyz - position_m) / safe, (view.box_high.xyz - position_m) / safe);
    float distance_m = max(min(way.x, min(way.y, way.z)), 0.0);
    return position_m + direction * distance_m - view.box_place.xyz;
}

#if FACET_ENVIRONMENT && !FACET_INDIRECT
// What a lobe around the mirrored direction shows of the environment, nit. w: the surface's weights; occlusion: the mean open
// direction and its share, of FACET_OCCLUSION.
vec3 mirrored_environment(ShadePoint p, vec3 normal, float roughness, BrdfValue w, vec4 occlusion) {
    vec3 mirrored = reflect(-p.to_eye, normal);
    float level = roughness * view.environment.x;
    vec3 nit = textureLod(radiance_cube, in_box(p.position_m, mirrored), level).rgb * view.environment.y;
#if FACET_OCCLUSION
    // What stands in the mirror's way is taken to be of the surface's own kind, and lit from this side.
    vec3 in_the_way = irradiance_over_pi(-mirrored) * (w.diffuse + w.specular);
    nit = mix(in_the_way, nit, specular_visible(occlusion, normal, mirrored, roughness));
#endif
    return nit;
}
#endif
