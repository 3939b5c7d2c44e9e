// A vertex of the user interface: pixels from the top left, straight sRGB colours.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;

uniform vec4 clip_from_px;  // xy: scale, zw: offset

out vec2 vertex_uv;
out vec4 vertex_color;

void main() {
    vertex_uv = uv;
    vertex_color = color;
    gl_Position = vec4(position_px * clip_from_px.xy + clip_from_px.zw, 0.0, 1.0);
}
