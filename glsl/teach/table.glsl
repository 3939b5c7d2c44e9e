// The table of albedos in a browser: floats as bits in integers, which every WebGL 2 can draw into and none filters.
uniform highp usampler2D albedo_table;  // A, B, mean of A + B, albedo of the diffuse lobe; as brdf/albedo.h

vec4 table_texel(ivec2 at) { return uintBitsToFloat(texelFetch(albedo_table, at, 0)); }

vec4 table_at(float n_dot_v, float roughness) {
    vec2 place = albedo_coordinates(n_dot_v, roughness) * ALBEDO_TABLE_SIZE - 0.5;
    ivec2 low = ivec2(clamp(floor(place), vec2(0.0), vec2(ALBEDO_TABLE_SIZE - 2.0)));
    vec2 share = place - vec2(low);
    vec4 below = mix(table_texel(low), table_texel(low + ivec2(1, 0)), share.x);
    vec4 above = mix(table_texel(low + ivec2(0, 1)), table_texel(low + ivec2(1, 1)), share.x);
    return mix(below, above, share.y);
}
