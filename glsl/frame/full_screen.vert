// One triangle over the whole target at the far plane, so that the depth test alone can skip the background
// (GREATER) or everything else (EQUAL): on a software renderer the cheapest skip there is.
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 1.0, 1.0);
}
