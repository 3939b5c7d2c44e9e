// Unit vectors in two numbers: octahedral mapping (Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors", JCGT 3(2), Section 3.1 and listing 1).
// returns [0, 1]^2, for a two-channel unorm target; 16 bits a channel err below 4e-5 rad
vec2 octahedral_from_unit(vec3 v) {
    vec2 p = v.xy / (abs(v.x) + abs(v.y) + abs(v.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return (v.z < 0.0 ? folded : p) * 0.5 + 0.5;
}
vec3 unit_from_octahedral(vec2 e) {
    vec2 p = e * 2.0 - 1.0;
    vec3 v = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float t = max(-v.z, 0.0);
    v.x += v.x >= 0.0 ? -t : t;
    v.y += v.y >= 0.0 ? -t : t;
    return normalize(v);
}
