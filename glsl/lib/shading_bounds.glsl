// How near to their edges a surface's numbers come where light falls on it.
// Below this cosine the surface is seen edge on; a shading normal may even turn away.
const float N_DOT_V_MIN = 1e-3;
// Perceptual roughness. Below the first a lobe is a mirror, in which lights without a size do not show; the reference has the
// same (trace/bsdf.cpp, mirror_alpha_max). The second is the least where lights are points: keeps D within half floats.
const float MIRROR_ROUGHNESS = 0.0316;
const float ROUGHNESS_MIN = 0.05;
