#version 430 core
// The faces of a box that a ray leaves it by: each pixel whose ray meets the box is drawn once, be the eye
// inside or outside. 36 vertices, no buffer.
//
// in   see CellFrame.glsl
// in   boxLow, boxHigh   index coordinates
//Hasp::Defines
//Hasp::CellFrame

uniform vec3 boxLow;
uniform vec3 boxHigh;

void main()
{
  int face = gl_VertexID / 6, axis = face >> 1;
  bool high = (face & 1) != 0;
  int corner = gl_VertexID % 6; // of two triangles, 0 1 2 and 1 2 3
  corner = corner < 3 ? corner : corner - 2;
  float wall = high ? boxHigh[axis] : boxLow[axis];
  float outwards = eyeIndex[axis] - eyeIndex.w * wall;
  bool leaves = high ? outwards < 0.0 : outwards > 0.0;
  vec3 place;
  place[axis] = wall;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  place[u] = (corner & 1) != 0 ? boxHigh[u] : boxLow[u];
  place[v] = (corner & 2) != 0 ? boxHigh[v] : boxLow[v];
  vec4 clip = indexToClip * vec4(place, 1.0);
  // No plane may cut the box itself, only its rays: near and far are for the fragment shader.
  gl_Position = leaves ? vec4(clip.xy, 0.0, clip.w) : vec4(0.0);
}
