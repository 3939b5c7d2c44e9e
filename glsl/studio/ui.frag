// A pixel of the user interface. Colours are sRGB codes and are blended as such, as every toolkit does.
in vec2 vertex_uv;
in vec4 vertex_color;

uniform sampler2D picture;

layout(location = 0) out vec4 out_color;

void main() { out_color = vertex_color * textureLod(picture, vertex_uv, 0.0); }
