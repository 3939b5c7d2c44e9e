// Directional light: parallel rays.
//   E_perp = E_0                                                KHR_lights_punctual; physics: irradiance, lux
// intensity_lux  rgb, illuminance of a surface that faces the light
// returns        [lux] illuminance at normal incidence, at any place
real3 light_directional(real3 intensity_lux) { return intensity_lux; }
