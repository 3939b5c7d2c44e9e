// The numbers that the BRDF takes at one point, as textures and factors, or the G-buffer, give them. Members under a FACET_ switch
// are there where a material has them; opacity and emission are none of lighting's.
struct Surface {
    vec3 base_color;
    float opacity;
    vec3 normal;
    float metallic;
    float roughness;
    float ao;
    vec3 emissive_nit;
#if FACET_SPECULAR
    vec3 dielectric_f0;
    float specular;
#endif
#if FACET_CLEARCOAT
    vec3 coat_normal;
    float coat;
    float coat_roughness;
#endif
#if FACET_SHEEN
    vec3 sheen_color;
    float sheen_roughness;
#endif
#if FACET_TRANSMISSION
    float transmission;
    float thickness_m;  // 0: a thin wall
    float ior;
    vec3 absorbed_per_m;
#endif
#if FACET_DIFFUSE_TRANSMISSION
    vec3 far_color;
    float far_share;  // of diffuse light
    vec3 scattered;  // diffuse albedo of a deep layer of what is within; 0: nothing is scattered there
#endif
#if FACET_ANISOTROPY
    vec3 tangent;  // unit, square to the normal; highlights are long along it
    float anisotropy;
#endif
#if FACET_IRIDESCENCE
    float film;
    float film_ior;
    float film_nm;
#endif
};
