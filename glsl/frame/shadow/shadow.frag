// Depth as a light sees it; a mask has holes.
#include "shared/draw.h"
layout(std140) uniform DrawBlock { Draw draw; };
#if FACET_ALPHA_MASK
#include "lib/material.glsl"
#endif
void main() {
#if FACET_ALPHA_MASK
    if (fetch_surface().opacity < draw.emissive_nit_cutoff.w) discard;
#endif
}
