// Numbers, as bits: what the page writes beside its canvas, and the points of its curve.
#include "generated/brdf.glsl"
#include "lib/answer.glsl"
#include "teach/table.glsl"

uniform vec4 surface;  // as canvas.frag
uniform vec4 cosines;  // n.v, n.l, n.h, v.h: made by the page in double precision, as sin and cos here may be coarse
uniform float view;    // angle of the view to the left of the normal, radians
uniform int curve;     // index of teach::live_curves()

layout(location = 0) out highp uvec4 out_bits;

const float POINTS = 256.0;

// Of a light to the right of the normal, in the plane of the view.
vec4 cosines_across(float light) {
    float n_dot_v = max(cos(view), 1e-4);
    float n_dot_l = max(cos(light), 0.0);
    float v_dot_l = n_dot_v * n_dot_l - sin(view) * sin(light);
    float v_dot_h = sqrt(max(0.5 + 0.5 * v_dot_l, 0.0));
    return vec4(n_dot_v, n_dot_l, clamp((n_dot_v + n_dot_l) / max(2.0 * v_dot_h, 1e-6), 0.0, 1.0), v_dot_h);
}

float asked(int term, vec4 at) {
    vec4 at_light = table_at(at.y, surface.x);
    return answer(term, at, surface, table_at(at.x, surface.x), at_light.x + at_light.y);
}

void main() {
    float i = floor(gl_FragCoord.x);
    float value = 0.0;
    if (gl_FragCoord.y < 1.0) {
        // D G V F specular diffuse full, then the two parts, the four cosines, what a white furnace gives back
        if (i < 9.0) value = asked(int(i), cosines);
        else if (i < 13.0) value = cosines[int(i) - 9];
        else {
            BrdfSurface s = brdf_surface(vec3(surface.w), surface.y, surface.x);
            s.dielectric_f0 = vec3(surface.z);
            BrdfValue w = brdf_environment(brdf_view(s, cosines.x, table_at(cosines.x, surface.x)));
            value = i < 14.0 ? w.specular.x : w.diffuse.x;
        }
    } else {
        float share = i / (POINTS - 1.0);
        float across = radians(share * 179.0 - 89.5);
        float up = radians(share * 89.9);
        if (curve == 0) value = asked(TERM_FULL, cosines_across(across));
        if (curve == 1) value = asked(TERM_D, vec4(1.0, 1.0, cos(up), 1.0));
        if (curve == 2) value = asked(TERM_F, vec4(1.0, 1.0, 1.0, cos(up)));
        if (curve == 3) value = asked(TERM_G, vec4(vec2(max(cos(up), 1e-4)), 1.0, cos(up)));
    }
    out_bits = floatBitsToUint(vec4(value, 0.0, 0.0, 0.0));
}
