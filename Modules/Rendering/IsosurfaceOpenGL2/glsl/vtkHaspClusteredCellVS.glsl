#version 430 core
// One active cell is one square point around it, or, where OpenGL would drop or cap that point, the two
// triangles of the smallest upright screen rectangle (thesis 3.2.2; Liu, Clapworthy, Dong 2009).
// Cells are pulled from the buffer; there are no attributes.
//
// in   cells, clusters   packed as CellLayout.glsl says
// in   indexToClip
// in   viewport     width and height in pixels
// out  low, high    corner samples minus the isovalue
// out  cellClip     clip coordinates of the cell's corner (0,0,0)
// out  cell         that corner in index coordinates, and the cell's id
//Hasp::Defines
#ifdef HASP_FLOAT_CORNERS
#define CELL_WORDS HaspFloatCellWords
#else
#define CELL_WORDS HaspIntegerCellWords
#endif
#define HASP_FUNCTION
//Hasp::CellLayout

layout(std430, binding = 0) readonly buffer Cells
{
  uint cells[];
};
layout(std430, binding = 1) readonly buffer Clusters
{
  uvec2 clusters[];
};
uniform mat4 indexToClip;
uniform vec2 viewport;
uniform bool points;
uniform float isovalue;
uniform int firstCell; // of this draw: large sets are drawn in ranges

flat out vec4 low;
flat out vec4 high;
flat out vec4 cellClip;
flat out ivec4 cell;

#ifdef HASP_FLOAT_CORNERS
void ReadCorners(uint word)
{
  low = vec4(uintBitsToFloat(cells[word]), uintBitsToFloat(cells[word + 1u]),
    uintBitsToFloat(cells[word + 2u]), uintBitsToFloat(cells[word + 3u]));
  high = vec4(uintBitsToFloat(cells[word + 4u]), uintBitsToFloat(cells[word + 5u]),
    uintBitsToFloat(cells[word + 6u]), uintBitsToFloat(cells[word + 7u]));
}
#else
vec2 Pair(uint word)
{
#ifdef HASP_UNSIGNED_CORNERS
  return vec2(uvec2(word & 0xFFFFu, word >> 16u));
#else
  return vec2(ivec2(int(word << 16u) >> 16, int(word) >> 16));
#endif
}
void ReadCorners(uint word)
{
  low = vec4(Pair(cells[word]), Pair(cells[word + 1u]));
  high = vec4(Pair(cells[word + 2u]), Pair(cells[word + 3u]));
}
#endif

void main()
{
  uint number = uint(gl_VertexID) / (points ? 1u : 6u);
  uint word = number * CELL_WORDS;
  uint place = cells[word];
  ReadCorners(word + 1u);
  low -= isovalue;
  high -= isovalue;
  cell = ivec4(HaspClusterOrigin(clusters[HaspCellCluster(place)]) + HaspCellInCluster(place),
    firstCell + int(number));
  cellClip = indexToClip * vec4(cell.xyz, 1.0);

  // The rectangle around the 8 projected corners, at the depth of the nearest.
  vec3 lowest = vec3(1e30), highest = vec3(-1e30);
  float leastW = 1e30, mostW = -1e30;
  for (int c = 0; c < 8; ++c)
  {
    vec4 p = cellClip + float(c & 1) * indexToClip[0] + float((c >> 1) & 1) * indexToClip[1] +
      float(c >> 2) * indexToClip[2];
    leastW = min(leastW, p.w);
    mostW = max(mostW, p.w);
    vec3 device = p.xyz / p.w;
    lowest = min(lowest, device);
    highest = max(highest, device);
  }
  if (points)
  {
    vec2 size = (highest.xy - lowest.xy) * 0.5 * viewport;
    gl_PointSize = max(size.x, size.y) + 0.0625; // rasterisers snap to 1/16 pixel at the coarsest
    gl_Position = vec4(0.5 * (lowest.xy + highest.xy), max(lowest.z, -1.0), 1.0);
    return;
  }
  // A cell around the eye has no rectangle: it gets the whole screen, on the near plane.
  // A cell behind the eye gets none.
  bool aroundEye = leastW < 1e-4 * mostW;
  vec2 from = aroundEye ? vec2(-1.0) : lowest.xy, to = aroundEye ? vec2(1.0) : highest.xy;
  float depth = aroundEye ? -1.0 : max(lowest.z, -1.0);
  if (mostW <= 0.0)
    from = to = vec2(2.0);
  uint corner = uint(gl_VertexID) % 6u; // triangles 0 1 2 and 2 1 3
  corner = corner < 3u ? corner : (corner == 3u ? 2u : (corner == 4u ? 1u : 3u));
  gl_Position =
    vec4((corner & 1u) != 0u ? to.x : from.x, (corner & 2u) != 0u ? to.y : from.y, depth, 1.0);
}
