// What a draw of one instance knows: std140, the same text for GLSL and C++.
// SPDX-License-Identifier: MIT
struct Draw {
    mat4 world_from_object;
    mat4 normal_from_object;  // cofactors of the above, 3x3 in the upper left
    vec4 base_color_opacity;
    vec4 metallic_roughness_normal_ao;  // factors; z: normal scale, w: occlusion strength
    vec4 emissive_nit_cutoff;           // rgb: radiance in nit; w: alpha cutoff
    vec4 dielectric_f0_specular;        // before their textures; F0 is not clamped
    vec4 coat;                          // strength, roughness, normal scale, unused
    vec4 sheen;                         // rgb, roughness
    vec4 transmission;                  // share, thickness in metres, ior, dispersion
    vec4 absorbed_per_m;                // rgb
    vec4 diffuse_transmission;          // rgb, share
    vec4 scattered;    // rgb: diffuse albedo of a deep layer; 0: nothing is scattered within
    vec4 anisotropy;   // strength, cosine and sine of the rotation
    vec4 iridescence;  // strength, ior, thickness in nm from and to
    vec4 uv_rows[42];  // two a texture slot: u' = dot(row.xyz, (u, v, 1)), w: UV set
    uvec4 ids;         // object, material, 1 where unlit, index of the draw
};
