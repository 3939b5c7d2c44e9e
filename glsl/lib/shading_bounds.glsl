// How near to their edges a surface's numbers come where light falls on it.
// Below this cosine the surface is seen edge on; a shading normal may even turn away.
const float N_DOT_V_MIN = 1e-3;
// Perceptual roughness where lights are points: a narrower lobe would show them nowhere but in a dot. The reference has the
// same (trace/bsdf.h).
const float ROUGHNESS_MIN = 0.05;
