#version 430 core
// Meets the pixel's ray with the trilinear polynomial of one cell; discards where they do not meet.
// Writes the depth of the hit.
//
// in   see vtkHaspClusteredCellVS.glsl; CellFrame.glsl, SurfaceShading.glsl, CellColors.glsl
// out  fragOutput0   colour, or what hardware selection asks for, or the number of the frame (HASP_HITS), or sums
//                    to blend (HASP_SPLATS)
//Hasp::Defines
#define HASP_FUNCTION
#define HASP_OUT(T) out T
//Hasp::RayRoot
//Hasp::SurfaceShading
//Hasp::SelectionColor

// What a scene does not have is not in its shader.
//Hasp::CellFrame
//Hasp::CellColors

uniform vec4 viewportToDevice; // scale, offset: pixels to [-1,1]
flat in vec4 low;
flat in vec4 high;
flat in vec4 cellClip;
flat in ivec4 cell;
layout(location = 0) out vec4 fragOutput0;
// Filled by VTK's passes for translucent actors, like the two lines in main().
//VTK::DepthPeeling::Dec

// Cells reach this far into their neighbours, so that no ray slips between two of them. In voxels.
const float Overlap = 1e-4;
// What is met in that overlap, and so by the neighbour too, is set back by so much: in voxels, more than
// the overlap, and in units of 2^-24 of the depth range, for it may be rounded. So the neighbour's own hit
// wins, whoever is drawn first.
const float SetBack = 2e-4;
const float SetBackDepth = 4.0 / 16777216.0;

// The point of the pixel's ray in the plane through the cell's middle, parallel to the screen, in cell
// coordinates. Points in world or eye coordinates would not do: a million voxels away float has no digits
// left. Here differences of clip coordinates are taken first; they are small, nothing cancels afterwards.
vec3 PointOnRay()
{
  vec4 middle = 0.5 * (indexToClip[0] + indexToClip[1] + indexToClip[2]); // relative to cellClip
  vec2 device = gl_FragCoord.xy * viewportToDevice.xy + viewportToDevice.zw;
  return (clipToIndex * vec4(device * (cellClip.w + middle.w) - cellClip.xy, middle.zw)).xyz;
}

// The part of the ray inside the cell and the clipping planes, as two points in cell coordinates, and its
// direction, the largest component of which is 1.
bool ClipRay(out vec3 a, out vec3 b, out vec3 direction)
{
  vec3 onRay = PointOnRay();
  vec3 cellIndex = vec3(cell.xyz);
  direction = (onRay + cellIndex) * eyeIndex.w - eyeIndex.xyz;
  direction /= max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
  vec3 wall0 = (vec3(-Overlap) - onRay) / safe, wall1 = (vec3(1.0 + Overlap) - onRay) / safe;
  vec3 enter = min(wall0, wall1), leave = max(wall0, wall1);
  float t0 = max(max(enter.x, enter.y), enter.z), t1 = min(min(leave.x, leave.y), leave.z);
  for (int p = 0; p < HASP_PLANES; ++p)
  {
    float atRay = dot(planes[p], vec4(cellIndex + onRay, 1.0));
    float slope = dot(planes[p].xyz, direction);
    if (slope > 0.0)
      t0 = max(t0, -atRay / slope);
    else if (slope < 0.0)
      t1 = min(t1, -atRay / slope);
    else if (atRay < 0.0)
      return false;
  }
  a = onRay + t0 * direction;
  b = onRay + t1 * direction;
  return t0 <= t1;
}

#ifdef HASP_SPLATS
//Hasp::CellSplat
#else
float DepthOf(vec3 place)
{
  vec2 clip = cellClip.zw + place.x * indexToClip[0].zw + place.y * indexToClip[1].zw +
    place.z * indexToClip[2].zw;
  return 0.5 * (gl_DepthRange.diff * clip.x / clip.y + gl_DepthRange.near + gl_DepthRange.far);
}

vec4 ShadeHit(vec3 hit)
{
  vec3 position = (indexToView * vec4(vec3(cell.xyz) + hit, 1.0)).xyz;
  vec3 normal = FaceEye(position, normalize(normalToView * -HaspTrilinearGradient(low, high, hit)));
  return Shade(position, normal, CellMaterial(hit));
}

#ifdef HASP_LAYERS
//Hasp::CellLayers
#else
void main()
{
#ifdef HASP_LABELS
  EnterFrame(label);
#endif
  vec3 a, b, direction;
  float s;
  if (!ClipRay(a, b, direction) || !HaspFirstRoot(HaspRayBernstein(low, high, a, b), s))
    discard;
  vec3 hit = mix(a, b, s);
  bool own = all(greaterThanEqual(hit, vec3(0.0))) && all(lessThan(hit, vec3(1.0)));
  gl_FragDepth = DepthOf(own ? hit : hit + SetBack * direction) + (own ? 0.0 : SetBackDepth);

  //VTK::DepthPeeling::PreColor
#ifdef HASP_HITS
#ifdef HASP_LABELS
  fragOutput0 = vec4(float(label.x & LabelFrame), 0.0, 0.0, 0.0);
#else
  fragOutput0 = vec4(0.0);
#endif
#elif defined(HASP_SELECTION)
  fragOutput0 = SelectionColor(uint(cell.w));
#else
  fragOutput0 = ShadeHit(hit);
#endif
  //VTK::DepthPeeling::Impl
}
#endif
#endif
