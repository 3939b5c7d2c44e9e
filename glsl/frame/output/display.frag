// From summed radiance to what a screen shows: average, exposure, white balance, tone curve, gamut, code, dither.
layout(std140) uniform DisplayBlock {
    vec4 scale;       // x: exposure / frames, y: 1 / frames, z: dither in codes, w: 1 / codes
    vec4 background;  // rgb: display-linear colour to lay the picture over; w: 1 where there is one
    mat4 balance;     // of linear Rec.709 before the tone curve
    mat4 primaries;   // the display's from linear Rec.709
    vec4 screen;      // x: brightest that it shows, 1 is its white; y: nit of 1 where the code is PQ, else 0
};
#include "frame/output/tonemap.glsl"
uniform sampler2D radiance;
layout(location = 0) out vec4 out_color;  // straight alpha

// IEC 61966-2-1:1999, clause 4.2.
vec3 srgb_from_linear(vec3 c) {
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(max(c, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(c, vec3(0.0031308)));
}

// SMPTE ST 2084:2014, Eq. 5.1: nit up to 10,000 to codes.
vec3 pq_from_nit(vec3 nit) {
    const float M1 = 2610.0 / 16384.0;
    const float M2 = 2523.0 / 4096.0 * 128.0;
    const float C1 = 3424.0 / 4096.0;
    const float C2 = 2413.0 / 4096.0 * 32.0;
    const float C3 = 2392.0 / 4096.0 * 32.0;
    vec3 y = pow(clamp(nit / 10000.0, 0.0, 1.0), vec3(M1));
    return pow((C1 + C2 * y) / (1.0 + C3 * y), vec3(M2));
}

// Interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty", p. 122).
float gradient_noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

void main() {
    vec4 sum = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
    float alpha = clamp(sum.a * scale.y, 0.0, 1.0);
    // Associated to straight; the tone curve must see the surface's radiance, not its share of the pixel.
    vec3 color = alpha > 0.0 ? sum.rgb * scale.x / alpha : vec3(0.0);
    vec3 shown = clamp(tone_map(max(mat3(balance) * color, vec3(0.0)), screen.x), 0.0, screen.x);
    // A colour that the user names is the colour of the file: it takes no exposure and no tone curve.
    if (background.w > 0.5) shown = mix(background.rgb, shown, alpha);
    shown = mat3(primaries) * shown;
    vec3 encoded = screen.y > 0.0 ? pq_from_nit(shown * screen.y) : srgb_from_linear(shown);
    encoded += (gradient_noise(gl_FragCoord.xy) - 0.5) * scale.z * scale.w;
    out_color = vec4(encoded, max(alpha, background.w));
}
