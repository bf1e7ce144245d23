#version 150 core
// The rectangle that a traced picture covers.
//
// in   rectangle   low x, y and high x, y, in [-1,1]
uniform vec4 rectangle;

void main()
{
  gl_Position = vec4((gl_VertexID & 1) != 0 ? rectangle.z : rectangle.x,
    (gl_VertexID & 2) != 0 ? rectangle.w : rectangle.y, 0.0, 1.0);
}
