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
};
