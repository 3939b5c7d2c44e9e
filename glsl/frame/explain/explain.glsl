// Shaders that are compiled with FACET_EXPLAIN write down what they compute at the pixels asked for.
#include "shared/explained.h"

layout(std430, binding = 0) buffer ExplainAsked {
    uvec4 explain_size;       // width of the picture, lights, room for surfaces, room for lights
    uvec4 explain_count;      // surfaces, lights: as many as wanted room
    uint explain_asked[];     // a pixel each: index + 1 of those asked for
};
layout(std430, binding = 1) buffer ExplainSurfaces { ExplainedSurface explained_surfaces[]; };
layout(std430, binding = 2) buffer ExplainLights { ExplainedLight explained_lights[]; };

const uint EXPLAIN_GBUFFER = 0u;
const uint EXPLAIN_LIGHTING = 1u;
const uint EXPLAIN_BLEND = 2u;
const uint EXPLAIN_BACKGROUND = 3u;
const uint EXPLAIN_LAYERS = 4u;

ExplainedSurface explained;
uint explain_record = 0u;   // of `explained`
bool is_explained = false;  // whether this pixel was asked for, and there is room
uint explain_light = 0u;    // the light at hand

void explain_begin(uint stage, uint draw, uint primitive) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint asked = explain_asked[pixel.y * explain_size.x + pixel.x];
    if (asked == 0u) return;
    explain_record = atomicAdd(explain_count.x, 1u);
    is_explained = explain_record < explain_size.z;
    explained.which = uvec4(asked - 1u, stage, draw, primitive);
    explained.position.w = gl_FragCoord.z;
    explained.irradiance = vec4(0.0);  // without an environment nothing says so
    explained.prefiltered = vec4(0.0);
    explained.coat = vec4(0.0);
    explained.sheen = vec4(0.0);
    explained.far_nit = vec4(0.0);
    explained.far_weight = vec4(0.0);
}

void explain_end() {
    if (is_explained) explained_surfaces[explain_record] = explained;
}

void explain_lit(ExplainedLight light) {
    if (!is_explained) return;
    uint at = atomicAdd(explain_count.y, 1u);
    light.which = uvec4(explain_record, explain_light, 0u, 0u);
    if (at < explain_size.w) explained_lights[at] = light;
}
