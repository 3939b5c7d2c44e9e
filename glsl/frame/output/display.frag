// From summed radiance to what a screen shows: average, exposure, tone curve, sRGB, dither.
#include "frame/output/tonemap.glsl"
layout(std140) uniform DisplayBlock {
    vec4 scale;       // x: exposure / frames, y: 1 / frames, z: dither in codes, w: 1 / codes
    vec4 background;  // rgb: display-linear colour to lay the picture over; w: 1 where there is one
};
uniform sampler2D radiance;
layout(location = 0) out vec4 out_color;  // straight alpha

// IEC 61966-2-1:1999, clause 4.2.
vec3 srgb_from_linear(vec3 c) {
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(max(c, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(c, vec3(0.0031308)));
}

// Interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty", p. 122).
float gradient_noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

void main() {
    vec4 sum = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
    float alpha = clamp(sum.a * scale.y, 0.0, 1.0);
    // Associated to straight; the tone curve must see the surface's radiance, not its share of the pixel.
    vec3 color = alpha > 0.0 ? sum.rgb * scale.x / alpha : vec3(0.0);
    vec3 shown = clamp(tone_map(max(color, vec3(0.0))), 0.0, 1.0);
    // A colour that the user names is the colour of the file: it takes no exposure and no tone curve.
    if (background.w > 0.5) shown = mix(background.rgb, shown, alpha);
    vec3 encoded = srgb_from_linear(shown);
    encoded += (gradient_noise(gl_FragCoord.xy) - 0.5) * scale.z * scale.w;
    out_color = vec4(encoded, max(alpha, background.w));
}
