// Adds one jittered frame to the sum.
uniform sampler2D radiance;
layout(location = 0) out vec4 out_sum;
void main() { out_sum = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0); }
