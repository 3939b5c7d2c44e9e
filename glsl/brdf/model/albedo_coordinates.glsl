// Where the albedo table (brdf/albedo.h) holds a direction and a roughness, as texture coordinates.
// Texel centres span the whole range: 0 and 1 are stored, not extrapolated. The roots spend texels on grazing angles
// and smooth surfaces, where the albedo turns fastest: it falls off where n.v nears alpha.
// n_dot_v, roughness  [0, 1]
// returns             [0, 1]^2, for a texture of ALBEDO_TABLE_SIZE squared with linear filter and clamped edges
real2 albedo_coordinates(real n_dot_v, real roughness) {
    real inner = (ALBEDO_TABLE_SIZE - real(1.0)) / ALBEDO_TABLE_SIZE;
    return real2(sqrt(sqrt(n_dot_v)), sqrt(roughness)) * inner + real2(real(0.5) / ALBEDO_TABLE_SIZE);
}
