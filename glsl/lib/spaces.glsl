// The one statement of spaces: world is right-handed, y up, metres; clip is GL's, depth 0..1 from near to far
// in the depth buffer and -1..1 in clip space; pixel (0, 0) of a target is bottom left, of a file top left.
vec3 world_from_depth(mat4 world_from_clip, vec2 uv, float depth) {
    vec4 world = world_from_clip * vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
    return world.xyz / world.w;
}
