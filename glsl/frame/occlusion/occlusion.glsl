// What ambient visibility leaves of the environment. Included by shade.glsl.
uniform sampler2D ambient_occlusion;  // frame/occlusion/occlusion.frag

// Light that bounces back from what occludes, if that is of the surface's own colour: Jimenez et al. 2016, Eq. 10.
vec3 with_bounces(float visible, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324;
    vec3 b = -4.7951 * albedo + 0.6417;
    vec3 c = 2.7552 * albedo + 0.6903;
    return max(vec3(visible), ((visible * a + b) * visible + c) * visible);
}

// Share of a cone around one axis that is in one around another; half angles and the angle between, in radians. The smaller
// cap whole, none of it, or smoothly between (Oat & Sander 2007, "Ambient Aperture Lighting").
float cone_share(float lobe, float open, float apart) {
    float inner = abs(open - lobe);
    float t = 1.0 - clamp((apart - inner) / max(open + lobe - inner, 1e-4), 0.0, 1.0);
    return smoothstep(0.0, 1.0, t) * min(1.0, (1.0 - cos(open)) / max(1.0 - cos(lobe), 1e-6));
}

// Share of the mirroring lobe that is in the open, of what the horizon of the bare surface leaves of it (Jimenez et al. 2016,
// section 4): the prefiltered environment knows that one.
float specular_visible(vec4 occlusion, vec3 normal, vec3 mirrored, float roughness) {
    float lobe = acos(clamp(exp2(-3.32193 * roughness * roughness), 0.0, 1.0)) + 0.02;
    float open = acos(sqrt(clamp(1.0 - occlusion.w, 0.0, 1.0)));
    float seen = cone_share(lobe, open, acos(clamp(dot(occlusion.xyz, mirrored), -1.0, 1.0)));
    float bare = cone_share(lobe, 1.5707963, acos(clamp(dot(normal, mirrored), -1.0, 1.0)));
    return min(seen / max(bare, 1e-3), 1.0);
}
