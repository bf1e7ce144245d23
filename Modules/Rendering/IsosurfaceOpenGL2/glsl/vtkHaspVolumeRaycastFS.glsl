#version 430 core
// Follows the pixel's ray through the samples of a volume at a fixed step, until two neighbours lie on either
// side of the isovalue; then meets the ray with the trilinear polynomial of each cell between them. Writes the
// depth of the hit. What comes and goes between two neighbours is not seen.
//
// in   filtered       the samples, of which the driver interpolates: good enough to see a change of sign
// in   corners        the same memory, for the samples as they are
// in   blocks         least and largest sample of each block of 8^3 cells (HASP_SKIPPING)
// in   boxLow, boxHigh   of this texture's cells, index coordinates; its first sample lies at boxLow
// in   viewIndex, viewClip   a point before the eye, in both coordinates
// out  fragOutput0    colour, or what hardware selection asks for
//Hasp::Defines
#define HASP_FUNCTION
#define HASP_OUT(T) out T
//Hasp::RayRoot
//Hasp::CellFrame
//Hasp::CellShading
//Hasp::CellSelection

uniform sampler3D filtered;
#if defined(HASP_FLOAT_CORNERS)
uniform sampler3D corners;
#elif defined(HASP_UNSIGNED_CORNERS)
uniform usampler3D corners;
#else
uniform isampler3D corners;
#endif
#ifdef HASP_SKIPPING
uniform sampler3D blocks;
#endif
uniform vec3 boxLow;
uniform vec3 boxHigh;
uniform vec3 viewIndex;
uniform vec4 viewClip;
uniform vec4 viewportToDevice; // scale, offset: pixels to [-1,1]
uniform float isovalue;
uniform float threshold;       // the isovalue as the driver normalises samples
uniform float stepSize;        // voxels
uniform vec3 cellCount;        // of the volume
layout(location = 0) out vec4 fragOutput0;

// The driver's interpolation has few digits: the change of sign that it shows may lie a little beside the one
// that is there. Voxels.
const float Margin = 1.0 / 32.0;

// The ray is start + t * direction, index coordinates, t in voxels.
vec3 start, direction, inverse;
float enter, leave;

// Point and direction relative to viewIndex: see PointOnRay of vtkHaspClusteredCellFS.glsl.
bool ClipRay()
{
  vec2 device = gl_FragCoord.xy * viewportToDevice.xy + viewportToDevice.zw;
  start = viewIndex + (clipToIndex * vec4(device * viewClip.w - viewClip.xy, 0.0, 0.0)).xyz;
  direction = normalize(start * eyeIndex.w - eyeIndex.xyz);
  inverse = 1.0 / mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
  vec3 wall0 = (boxLow - start) * inverse, wall1 = (boxHigh - start) * inverse;
  vec3 near = min(wall0, wall1), far = max(wall0, wall1);
  enter = max(max(near.x, near.y), near.z);
  leave = min(min(far.x, far.y), far.z);
  for (int p = 0; p < HASP_PLANES; ++p)
  {
    float atStart = dot(planes[p], vec4(start, 1.0));
    float slope = dot(planes[p].xyz, direction);
    if (slope > 0.0)
      enter = max(enter, -atStart / slope);
    else if (slope < 0.0)
      leave = min(leave, -atStart / slope);
    else if (atStart < 0.0)
      leave = enter - 1.0;
  }
  return enter <= leave;
}

float TimeOf(float number)
{
  return min(enter + number * stepSize, leave);
}

// In texture coordinates, so that the loop has the least to do.
vec3 textureStart, textureDirection;

bool InsideAt(float t)
{
  return textureLod(filtered, textureStart + t * textureDirection, 0.0).x >= threshold;
}

#ifdef HASP_SKIPPING
// The first sample from `number` on that is on the other side than `inside`; beyond `last` if there is none.
// A block without surface has one side and is passed in one step. The samples are those of the ray without
// skipping.
float FindChange(float number, float last, bool inside)
{
  while (number <= last)
  {
    float end = last; // of the samples in the block
    while (number <= last)
    {
      ivec3 block = clamp(ivec3(start + TimeOf(number) * direction), ivec3(0), ivec3(cellCount) - 1) >> 3;
      vec2 range = texelFetch(blocks, block, 0).xy;
      vec3 wall = (vec3((block + ivec3(greaterThan(inverse, vec3(0.0)))) << 3) - start) * inverse;
      end = clamp(floor((min(min(wall.x, wall.y), wall.z) - enter) / stepSize), number, last);
      if (isovalue > range.x ? isovalue <= range.y || inside : !inside)
        break;
      number = end + 1.0;
    }
    while (number <= end)
    {
      if (InsideAt(TimeOf(number)) != inside)
        return number;
      number += 1.0;
    }
  }
  return number;
}
#else
float FindChange(float number, float last, bool inside)
{
  while (number <= last && InsideAt(TimeOf(number)) == inside)
    number += 1.0;
  return number;
}
#endif

float Corner(ivec3 sampleIndex)
{
  return float(texelFetch(corners, sampleIndex - ivec3(boxLow), 0).x) - isovalue;
}

struct Hit
{
  vec4 low, high; // corners of the cell
  ivec3 cell;
  vec3 place;     // in it
};

// The first root between two points of the ray, cell by cell.
bool FindRoot(float from, float to, out Hit hit)
{
  ivec3 first = ivec3(boxLow), last = ivec3(boxHigh) - 1;
  hit.cell = clamp(ivec3(floor(start + from * direction)), first, last);
  bool inside = false, found = false;
  for (bool began = false; from <= to; began = true)
  {
    vec3 wall = (vec3(hit.cell + ivec3(greaterThan(inverse, vec3(0.0)))) - start) * inverse;
    float end = min(min(wall.x, wall.y), wall.z);
    hit.low = vec4(Corner(hit.cell), Corner(hit.cell + ivec3(1, 0, 0)), Corner(hit.cell + ivec3(0, 1, 0)),
      Corner(hit.cell + ivec3(1, 1, 0)));
    hit.high = vec4(Corner(hit.cell + ivec3(0, 0, 1)), Corner(hit.cell + ivec3(1, 0, 1)),
      Corner(hit.cell + ivec3(0, 1, 1)), Corner(hit.cell + ivec3(1, 1, 1)));
    vec3 a = start + from * direction - vec3(hit.cell), b = start + min(end, to) * direction - vec3(hit.cell);
    vec4 c = HaspRayBernstein(hit.low, hit.high, a, b);
    float s;
    found = HaspFirstRoot(c, s);
    if (began && (c.x >= 0.0) != inside) // by rounding, the root lies between this cell and the last
    {
      found = true;
      s = 0.0;
    }
#ifdef HASP_FLOAT_CORNERS
    if (any(isnan(hit.low)) || any(isnan(hit.high)) || any(isinf(hit.low)) || any(isinf(hit.high)))
      found = false;
#endif
    hit.place = mix(a, b, s);
    if (found)
      break;
    inside = c.w >= 0.0;
    from = end;
    ivec3 next = hit.cell + ivec3(sign(inverse)) * ivec3(lessThanEqual(wall, vec3(end)));
    if (next == hit.cell || any(lessThan(next, first)) || any(greaterThan(next, last)))
      break;
    hit.cell = next;
  }
  return found;
}

bool FindHit(out Hit hit)
{
  vec3 texels = boxHigh - boxLow + 1.0;
  textureStart = (start - boxLow + 0.5) / texels;
  textureDirection = direction / texels;
  float number = 1.0, last = ceil((leave - enter) / stepSize);
  bool inside = InsideAt(enter);
  // Each loop has little in it that not all pixels do: a processor runs several of them in step.
  while (number <= last)
  {
    number = FindChange(number, last, inside);
    if (number > last)
      break;
    if (FindRoot(max(TimeOf(number - 1.0) - Margin, enter), min(TimeOf(number) + Margin, leave), hit))
      return true;
    inside = !inside;
    number += 1.0;
  }
  return false;
}

void main()
{
  Hit hit;
  if (!ClipRay() || !FindHit(hit))
    discard;
  vec3 fromView = vec3(hit.cell) - viewIndex + hit.place;
  vec2 clip = viewClip.zw + fromView.x * indexToClip[0].zw + fromView.y * indexToClip[1].zw +
    fromView.z * indexToClip[2].zw;
  if (clip.x > clip.y)
    discard; // beyond the far plane
  gl_FragDepth = 0.5 * (gl_DepthRange.diff * clip.x / clip.y + gl_DepthRange.near + gl_DepthRange.far);
#ifdef HASP_SELECTION
  uvec3 cell = uvec3(hit.cell), count = uvec3(cellCount);
  fragOutput0 = SelectionColor(cell.x + count.x * (cell.y + count.y * cell.z)); // as vtkImageData counts
#else
  vec3 position = (indexToView * vec4(vec3(hit.cell) + hit.place, 1.0)).xyz;
  vec3 normal =
    FaceEye(position, normalize(normalToView * -HaspTrilinearGradient(hit.low, hit.high, hit.place)));
  fragOutput0 = Shade(position, normal, PropertyMaterial());
#endif
}
