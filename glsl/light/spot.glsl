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
