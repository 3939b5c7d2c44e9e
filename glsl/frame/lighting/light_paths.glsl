// Light apart by the way it took: rows of tables/aovs.def. shade() fills it beside the sum.
struct LightPaths {
    vec3 diffuse_direct;
    vec3 diffuse_indirect;
    vec3 specular_direct;
    vec3 specular_indirect;
    vec3 emission;
    vec3 background;  // no surface's
};
LightPaths paths = LightPaths(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));

// What an unlit surface shows counts as emitted.
void add_emission(vec3 base_color, float unlit, vec3 emissive_nit) {
    float lit = 1.0 - unlit;
    paths.diffuse_direct *= lit;
    paths.diffuse_indirect *= lit;
    paths.specular_direct *= lit;
    paths.specular_indirect *= lit;
    paths.emission = base_color * unlit + emissive_nit;
}
