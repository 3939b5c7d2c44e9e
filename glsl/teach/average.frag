// The table of albedos with the mean of A + B over the hemisphere, 2 integral of (A + B) n.v d(n.v), beside it.
#include "generated/brdf.glsl"
#include "teach/table.glsl"

layout(location = 0) out highp uvec4 out_bits;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float sum = 0.0;
    float n_dot_v_before = 0.0;
    float before = 0.0;
    for (int i = 0; i < int(ALBEDO_TABLE_SIZE); ++i) {
        float x = float(i) / (ALBEDO_TABLE_SIZE - 1.0);
        float n_dot_v = x * x * x * x;
        vec4 texel = table_texel(ivec2(i, at.y));
        float value = 2.0 * n_dot_v * (texel.x + texel.y);
        sum += 0.5 * (value + before) * (n_dot_v - n_dot_v_before);
        n_dot_v_before = n_dot_v;
        before = value;
    }
    vec4 texel = table_texel(at);
    out_bits = floatBitsToUint(vec4(texel.xy, sum, texel.w));
}
