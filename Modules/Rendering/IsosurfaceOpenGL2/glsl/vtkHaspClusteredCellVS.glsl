#version 430 core
// One active cell is one square point around it, or, where OpenGL would drop or cap that point, the two
// triangles of the smallest upright screen rectangle (thesis 3.2.2; Liu, Clapworthy, Dong 2009).
// Cells are pulled from the buffer; there are no attributes.
//
// in   clusters, corners   packed as CellLayout.glsl says; a vertex's number is that of its cluster, relative
//                          to the first one bound, times 512, plus that of its cell in the cluster
// in   indexToClip
// in   viewport     width and height in pixels
// out  low, high    corner samples minus the isovalue
// out  cellClip     clip coordinates of the cell's corner (0,0,0)
// out  cell         that corner in index coordinates, and the cell's id
// out  label        what is said of the cell's label, see CellFrame.glsl
// out  colorLow, colorHigh   of the corners
//Hasp::Defines
#define HASP_FUNCTION
//Hasp::CellLayout
//Hasp::CellFrame

layout(std430, binding = 0) readonly buffer Clusters
{
  uint clusters[];
};
layout(std430, binding = 1) readonly buffer Corners
{
  uint corners[];
};
#ifdef HASP_COMPACT_CORNERS
uniform float levels[128];
#endif
#ifdef HASP_LABELS
layout(std430, binding = 4) readonly buffer Labels
{
  uint labels[]; // of two cells a word
};
layout(std430, binding = 5) readonly buffer LabelTable
{
  uvec2 labelTable[]; // by label; the last is for all beyond
};
uniform int firstLabelWord;
uniform int opaquePass; // 1: opaque labels alone, 0: translucent ones alone, -1: all
flat out uvec2 label;
#endif
#ifdef HASP_COLORS
layout(std430, binding = 2) readonly buffer FirstColors
{
  uint firstColors[]; // by cluster
};
layout(std430, binding = 7) readonly buffer Colors
{
  uint colors[];
};
uniform int firstColor;
uniform int clustersBefore; // in firstColors
flat out uvec4 colorLow;
flat out uvec4 colorHigh;
#endif
uniform vec2 viewport;
uniform bool points;
uniform float isovalue;
uniform int firstWord; // of the corners that are bound: large sets are drawn in parts

#ifdef HASP_SPLATS
const float Margin = 0.5; // see CellSplat.glsl
#else
const float Margin = 0.0;
#endif

const float Snap = 0.0625; // pixels; rasterisers snap to 1/16 pixel at the coarsest

flat out vec4 low;
flat out vec4 high;
flat out vec4 cellClip;
flat out ivec4 cell;

// Two corners that are stored one after the other, as samples minus the isovalue.
vec2 Pair(uint first, uvec2 place, uint number)
{
  uint width = HaspCornerWidth(place);
  uint bit = number * width;
  uint word = first + (bit >> 5u), shift = bit & 31u;
  uint low = corners[word], high = corners[word + 1u];
#ifdef HASP_FLOAT_CORNERS
  return uintBitsToFloat(uvec2(low, high)) - isovalue;
#else
  uint two = shift == 0u ? low : (low >> shift) | (high << (32u - shift));
  uvec2 stored = uvec2(two, two >> width) & HaspLowBits(width);
#ifdef HASP_COMPACT_CORNERS
  vec2 size = vec2(levels[stored.x & 127u], levels[stored.y & 127u]);
  return mix(size, -size, greaterThan(stored, uvec2(127u)));
#else
  uvec2 samples = stored + HaspCornerBase(place);
#ifdef HASP_UNSIGNED_CORNERS
  return vec2(samples & 0xFFFFu) - isovalue;
#else
  return vec2(ivec2(samples << 16u) >> 16) - isovalue;
#endif
#endif
#endif
}

uvec2 ActiveSlice(uint header, int z) // none below and above the cluster
{
  uint word = header + 2u * uint(clamp(z, 0, 7));
  return z < 0 || z > 7 ? uvec2(0u) : uvec2(clusters[word], clusters[word + 1u]);
}

// The numbers of the cell's corners (x, y) and (x, y + 1) in corner slice z; those at x + 1 come next.
uvec2 CornerNumbers(uint header, uint x, uint y, int z)
{
  uvec2 cells = ActiveSlice(header, z - 1) | ActiveSlice(header, z);
  uint halves = clusters[header + 16u + uint(max(z - 1, 0)) / 2u];
  uint before = z == 0 ? 0u : (z - 1) % 2 == 0 ? halves & 0xFFFFu : halves >> 16u;
  return before + uvec2(HaspCornersBefore(cells, x, y), HaspCornersBefore(cells, x, y + 1u));
}

vec4 ReadSlice(uint header, uvec2 place, uvec2 numbers)
{
  uint first = clusters[header + 20u] - uint(firstWord);
  return vec4(Pair(first, place, numbers.x), Pair(first, place, numbers.y));
}

#ifdef HASP_COLORS
uvec4 ReadColors(uint header, uvec2 numbers)
{
  uvec2 at = firstColors[header / HaspClusterWords + uint(clustersBefore)] - uint(firstColor) + numbers;
  return uvec4(colors[at.x], colors[at.x + 1u], colors[at.y], colors[at.y + 1u]);
}
#endif

#ifdef HASP_LABELS
// False if the cell is not to be drawn.
bool ReadLabel(uint id)
{
  uint number = labels[(id >> 1u) - uint(firstLabelWord)] >> (16u * (id & 1u)) & 0xFFFFu;
  label = labelTable[min(number, uint(labelTable.length()) - 1u)];
  bool opaque = (label.x & LabelColored) == 0u || label.y >> 24u == 255u;
  return (label.x & LabelHidden) == 0u && (opaquePass < 0 || opaque == (opaquePass == 1));
}
#endif

void main()
{
  uint number = uint(gl_VertexID) / (points ? 1u : 6u);
  uint header = (number >> 9u) * HaspClusterWords;
  uint inCluster = number & 511u;
  uint left = inCluster;
  int z = 0;
  for (uint count = HaspCountBits(ActiveSlice(header, 0)); left >= count && z < 7;
       count = HaspCountBits(ActiveSlice(header, z)))
  {
    left -= count;
    ++z;
  }
  uint bit = HaspSelectBit(ActiveSlice(header, z), left);
  uvec2 place = uvec2(clusters[header + 22u], clusters[header + 23u]);
  uvec2 lowNumbers = CornerNumbers(header, bit & 7u, bit >> 3u, z);
  uvec2 highNumbers = CornerNumbers(header, bit & 7u, bit >> 3u, z + 1);
  low = ReadSlice(header, place, lowNumbers);
  high = ReadSlice(header, place, highNumbers);
#ifdef HASP_COLORS
  colorLow = ReadColors(header, lowNumbers);
  colorHigh = ReadColors(header, highNumbers);
#endif
  cell = ivec4(ivec3(HaspClusterOrigin(place)) + ivec3(bit & 7u, bit >> 3u, z),
    clusters[header + 21u] + inCluster);
#ifdef HASP_LABELS
  bool drawn = ReadLabel(uint(cell.w));
  EnterFrame(label);
  if (!drawn)
  {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
    gl_PointSize = 1.0;
    return;
  }
#endif
  cellClip = indexToClip * vec4(cell.xyz, 1.0);

  // The rectangle around the 8 projected corners of the cell, or its support, at the depth of the nearest.
  vec3 lowest = vec3(1e30), highest = vec3(-1e30);
  float leastW = 1e30, mostW = -1e30;
  for (int c = 0; c < 8; ++c)
  {
    vec3 at = mix(vec3(-Margin), vec3(1.0 + Margin), vec3(c & 1, (c >> 1) & 1, c >> 2));
    vec4 p = cellClip + at.x * indexToClip[0] + at.y * indexToClip[1] + at.z * indexToClip[2];
    leastW = min(leastW, p.w);
    mostW = max(mostW, p.w);
    vec3 device = p.xyz / p.w;
    lowest = min(lowest, device);
    highest = max(highest, device);
  }
  if (points)
  {
    vec2 size = (highest.xy - lowest.xy) * 0.5 * viewport;
    gl_PointSize = max(size.x, size.y) + Snap;
    gl_Position = vec4(0.5 * (lowest.xy + highest.xy), max(lowest.z, -1.0), 1.0);
    return;
  }
  // A cell around the eye has no rectangle: it gets the whole screen, on the near plane.
  // A cell behind the eye gets none.
  bool aroundEye = leastW < 1e-4 * mostW;
  vec2 from = aroundEye ? vec2(-1.0) : lowest.xy - Snap / viewport,
       to = aroundEye ? vec2(1.0) : highest.xy + Snap / viewport;
  float depth = aroundEye ? -1.0 : max(lowest.z, -1.0);
  if (mostW <= 0.0)
    from = to = vec2(2.0);
  uint corner = uint(gl_VertexID) % 6u; // triangles 0 1 2 and 2 1 3
  corner = corner < 3u ? corner : (corner == 3u ? 2u : (corner == 4u ? 1u : 3u));
  gl_Position =
    vec4((corner & 1u) != 0u ? to.x : from.x, (corner & 2u) != 0u ? to.y : from.y, depth, 1.0);
}
