// What every pass of a frame knows: std140, the same text for GLSL and C++.
// SPDX-License-Identifier: MIT
// Members are vec4, uvec4 and mat4 only, so that std140 and C++ agree; tests/gl asks the driver all
// the same.
struct View {
    mat4 clip_from_world;
    mat4 world_from_clip;
    mat4 middle_from_world;  // clip space of the pixels' middles, through the middle of the lens
    vec4 eye_m;              // xyz: the eye; w: 1 perspective, 0 orthographic
    vec4 forward;            // xyz: unit, where the camera looks; w: unused
    vec4 size_px;            // width, height, 1 / width, 1 / height
    uvec4 light_counts;      // directional lights, all lights, tiles across, unused
    vec4 environment;  // x: last level of the prefiltered cube that lights; y: nit of its 1; zw: of
                       // the one behind
    vec4 background;   // x: level of the cube that shows; y: width of the lobe that blurs it, 0:
                       // none; z: what makes that lobe's share of the sun from D n.l; w: unused
    vec4 pixel;  // x: width at the eye in metres, y: growth per metre; z: index of the sample; w:
                 // unused
    uvec4 rays;  // x: pixels a slot of light_visibility, y: slots, z: pixels across, w: stride of
                 // the indirect light
    vec4 lens;   // xy: place on it in metres; z: radius of its barrel's rim, 0: no vignetting; w:
                 // shift of the rim for each tangent off axis
    vec4 tangents;  // of the angles to the axis: zw + xy times the pixel from the bottom left
    vec4
        sun;  // of the environment. xyz: unit, to it; w: cosine of half its width, 2: there is none
    vec4 sun_nit;  // rgb
    vec4 box_low;  // xyz: metres, of what a probe shows; w: 1 where there is one
    vec4 box_high;
    vec4 box_place;  // xyz: where the probe was
    vec4 ground;     // x, y, z: metres, its middle; w: its radius
    vec4 occlusion;  // x: metres that it looks around for, yzw: unused
    vec4 key_light;  // xyz: metres where w is 1, else the unit direction to it
};
