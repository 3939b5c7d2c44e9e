// What a model of the BRDF takes and gives. Terms are chosen through the slot_ functions, which are switches in
// C++ and generated one-liners in GLSL.
struct BrdfSurface {
    real3 base_color;   // [0, 1] linear Rec.709: albedo of dielectrics
    real3 metal_f0;     // [0, 1] reflectance of metals at normal incidence: base_color, or what a film makes of it
    real metallic;      // [0, 1]
    real roughness;     // [0, 1] perceptual
    real alpha;         // (0, 1] width of the distribution
    real3 dielectric_f0; // [0, 1] reflectance at normal incidence of what is no metal
    real specular;      // [0, 1] strength of its reflection, at every angle (KHR_materials_specular)
    real diffuse;       // [0, 1] share of what is not reflected that the diffuse lobe gets (transmission.glsl)
    real3 edge_tint;    // [0, 1] F82's tint at 82 degrees; 1 is Schlick
};
// One lobe a member, 1/sr per light; weights of irradiance/pi and prefiltered radiance for the environment.
struct BrdfValue {
    real3 diffuse;
    real3 specular;
};
// The factors that a light's BrdfValue is made of, for people to look at.
struct BrdfTerms {
    real d;     // [1/sr] distribution of normals
    real g;     // [0, 1] masking and shadowing
    real3 f;    // [0, 1] Fresnel reflectance, F0 mixed by metallic
    real3 k_d;  // diffuse = k_d times the diffuse lobe
    real3 k_s;  // specular = k_s D V, and what compensation adds; above 1 where it makes up for lost energy
};
// What is the same for every light of a pixel.
struct BrdfView {
    BrdfSurface surface;
    real n_dot_v;
    real a;                  // split sum: albedo of the specular lobe is F0 a + b
    real b;
    real e_average;          // hemispherical mean of a + b
    real3 diffuse_albedo;    // of the diffuse lobe at n_dot_v, without k_d
    real k_d;                // what the specular lobe leaves, times 1 - metallic
    real3 dielectric_weight; // factors on D V F of the two lobes
    real3 metal_weight;
    real3 added;             // albedo of the lobe that compensation adds
};


// base_color  [0, 1] rgb  linear Rec.709
// metallic    [0, 1]
// roughness   [0, 1]      perceptual; not clamped here: lights that are points need a lower bound
BrdfSurface brdf_surface(real3 base_color, real metallic, real roughness) {
    BrdfSurface s;
    s.base_color = base_color;
    s.metal_f0 = base_color;
    s.metallic = metallic;
    s.roughness = roughness;
    s.alpha = slot_width(roughness);
    s.dielectric_f0 = real3(DIELECTRIC_F0);
    s.specular = real(1.0);
    s.diffuse = real(1.0);
    s.edge_tint = real3(real(1.0));
    return s;
}
