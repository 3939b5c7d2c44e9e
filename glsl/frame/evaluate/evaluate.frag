// The BRDF itself, one question a pixel: what `facet brdf --via gl` asks. src/frame/evaluate/evaluate.h fills the rows.
#include "generated/brdf.glsl"
#include "lib/answer.glsl"

uniform sampler2D questions;     // three rows of texels a block: cosines; roughness, metallic, f0, base; term
uniform sampler2D albedo_table;  // as lighting/shade.glsl reads it

layout(location = 0) out vec4 out_value;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    at.y *= 3;
    vec4 cosines = texelFetch(questions, at, 0);  // n.v, n.l, n.h, v.h
    vec4 material = texelFetch(questions, at + ivec2(0, 1), 0);
    int term = int(texelFetch(questions, at + ivec2(0, 2), 0).x);
    vec4 albedo = textureLod(albedo_table, albedo_coordinates(cosines.x, material.x), 0.0);
    vec2 e_l = textureLod(albedo_table, albedo_coordinates(cosines.y, material.x), 0.0).xy;
    out_value = vec4(answer(term, cosines, material, albedo, e_l.x + e_l.y));
}
