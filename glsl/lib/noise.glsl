// Numbers that differ from pixel to pixel and from sample to sample.

// Interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare"), turned on by
// the golden section with each sample. at_px: of the pixel's middle. Returns [0, 1).
float pixel_noise(vec2 at_px, float sample_index) {
    return fract(52.9829189 * fract(dot(at_px, vec2(0.06711056, 0.00583715))) + sample_index * 0.6180340);
}
