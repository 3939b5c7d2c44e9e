// Diffuse lobe: Lambert's, the same from everywhere.
//   f = color / pi                                              Lambert 1760; the 1/pi makes the albedo equal to color
// color    [0, 1] rgb  albedo
// returns  [1/sr] rgb
real3 diffuse_lambert(real3 color) { return color * (real(1.0) / PI); }
