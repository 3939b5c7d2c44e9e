// Spot light: the share of a point light that its cone lets through.
//   sat(cos(theta) * scale + offset)^2, scale = 1 / (cos inner - cos outer), offset = -cos outer * scale
//                                                               KHR_lights_punctual, "Inner and Outer Cone Angles"
// cos_theta      [-1, 1] cosine between the spot's axis and the direction to the surface
// scale, offset  as above; 0 and 1 make a point light
// returns        [0, 1]
real light_spot(real cos_theta, real scale, real offset) {
    real t = clamp(cos_theta * scale + offset, real(0.0), real(1.0));
    return t * t;
}
// Where the cone's edge begins and how steep it is: x scale, y offset of light_spot. The cosines are of the half angles;
// 0.001 is the extension's own bound for an edge without width.
real2 spot_edge(real cos_inner, real cos_outer) {
    real scale = real(1.0) / max(cos_inner - cos_outer, real(0.001));
    return real2(scale, -cos_outer * scale);
}
