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
//Hasp::SurfaceShading
//Hasp::SelectionColor

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
// that is there; where samples differ by few grey levels, anywhere in the cell. Voxels.
const float Margin = 1.0 / 32.0, WideMargin = 1.0;

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

bool IsOtherSide(float number, bool inside)
{
  return (textureLod(filtered, textureStart + TimeOf(number) * textureDirection, 0.0).x >= threshold) != inside;
}

// The first sample in [number, end] that is on the other side than `inside`. If there is none, a number beyond
// end, up to which none is. Four at a time: a loop's turn costs as much as a sample.
float FindChangeUntil(float number, float end, bool inside)
{
  while (number <= end)
  {
    bvec4 other = bvec4(IsOtherSide(number, inside), IsOtherSide(number + 1.0, inside),
      IsOtherSide(number + 2.0, inside), IsOtherSide(number + 3.0, inside));
    if (any(other))
      return number + (other.x ? 0.0 : other.y ? 1.0 : other.z ? 2.0 : 3.0);
    number += 4.0;
  }
  return number;
}

#ifdef HASP_SKIPPING
// The block in which the ray is, from where on, and where it leaves it along each axis.
ivec3 block;
float blockEnter;
vec3 blockWall;

void EnterBlocks()
{
  block = clamp(ivec3(start + enter * direction), ivec3(0), ivec3(cellCount) - 1) >> 3;
  blockEnter = enter;
  blockWall = (vec3((block + ivec3(greaterThan(inverse, vec3(0.0)))) << 3) - start) * inverse;
}

void NextBlock(float blockLeave)
{
  bvec3 crossed = lessThanEqual(blockWall, vec3(blockLeave));
  blockWall += 8.0 * abs(inverse) * vec3(crossed);
  block = clamp(block + ivec3(sign(inverse)) * ivec3(crossed), ivec3(0), (ivec3(cellCount) - 1) >> 3);
  blockEnter = blockLeave;
}

// FindChangeUntil the last sample, but a block without surface has one side and is passed in one step.
float FindChange(float number, float last, bool inside)
{
  while (number <= last)
  {
    float blockLeave;
    while (true)
    {
      vec2 range = texelFetch(blocks, block, 0).xy;
      blockLeave = min(min(blockWall.x, blockWall.y), blockWall.z);
      if (isovalue > range.x ? isovalue <= range.y || inside : !inside)
        break;
      if (blockLeave >= leave)
        return last + 1.0;
      NextBlock(blockLeave);
    }
    float end = blockLeave >= leave ? last : floor((blockLeave - enter) / stepSize);
    number = FindChangeUntil(max(number, floor((blockEnter - enter) / stepSize) + 1.0), end, inside);
    if (number <= end)
      break;
    NextBlock(blockLeave);
  }
  return number;
}
#else
float FindChange(float number, float last, bool inside)
{
  return FindChangeUntil(number, last, inside);
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

void ReadCell(ivec3 cell, out Hit hit)
{
  hit.cell = cell;
  hit.low = vec4(Corner(cell), Corner(cell + ivec3(1, 0, 0)), Corner(cell + ivec3(0, 1, 0)),
    Corner(cell + ivec3(1, 1, 0)));
  hit.high = vec4(Corner(cell + ivec3(0, 0, 1)), Corner(cell + ivec3(1, 0, 1)), Corner(cell + ivec3(0, 1, 1)),
    Corner(cell + ivec3(1, 1, 1)));
}

// The first root between two points of the ray, cell by cell. Its cell is found first and the cubic solved then,
// outside of the loop: not every pixel needs as many cells.
bool FindRoot(float from, float to, out Hit hit)
{
  ivec3 first = ivec3(boxLow), last = ivec3(boxHigh) - 1, up = ivec3(greaterThan(inverse, vec3(0.0)));
  ivec3 cell = clamp(ivec3(floor(start + from * direction)), first, last);
  bool began = false, inside = false, over = false;
  while (!over)
  {
    bool changes = false; // the coefficients, or by rounding the value between this cell and the last
    vec3 a, b;
    vec4 c;
    while (!changes && !over)
    {
      ReadCell(cell, hit);
      vec3 wall = (vec3(cell + up) - start) * inverse;
      float end = min(min(wall.x, wall.y), wall.z);
      a = start + from * direction - vec3(cell);
      b = start + min(end, to) * direction - vec3(cell);
      c = HaspRayBernstein(hit.low, hit.high, a, b);
      inside = began ? inside : c.x >= 0.0;
      began = true;
      bvec4 side = greaterThanEqual(c, vec4(0.0));
      changes = inside ? !all(side) : any(side);
#ifdef HASP_FLOAT_CORNERS
      began = !any(isnan(c)) && !any(isinf(c)); // cells of what are no numbers are empty
      changes = changes && began;
#endif
      cell += (2 * up - 1) * ivec3(lessThanEqual(wall, vec3(end)));
      from = end;
      over = end >= to || any(lessThan(cell, first)) || any(greaterThan(cell, last));
    }
    float s = 0.0;
    if (changes && ((c.x >= 0.0) != inside || HaspFirstRoot(c, s)))
    {
      hit.place = mix(a, b, s);
      return true;
    }
  }
  return false;
}

bool FindHit(out Hit hit)
{
  vec3 texels = boxHigh - boxLow + 1.0;
  textureStart = (start - boxLow + 0.5) / texels;
  textureDirection = direction / texels;
#ifdef HASP_SKIPPING
  EnterBlocks();
#endif
  float number = 1.0, last = ceil((leave - enter) / stepSize);
  bool inside = IsOtherSide(0.0, false);
  // Each loop has little in it that not all pixels do: a processor runs several of them in step.
  while (number <= last)
  {
    number = FindChange(number, last, inside);
    if (number > last)
      break;
    bool found = false;
    for (float margin = Margin; !found && margin <= WideMargin; margin += WideMargin - Margin)
      found = FindRoot(max(TimeOf(number - 1.0) - margin, enter), min(TimeOf(number) + margin, leave), hit);
    if (found)
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
