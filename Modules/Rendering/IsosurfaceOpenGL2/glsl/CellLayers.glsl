// Translucent cells: every hit in the cell is a layer, and each layer is to be drawn once.
//
// Cells overlap, so that no ray slips between them, and what they both see is to be one layer. A hit is the
// cell's that it lies in. HASP_PEELS: what fragments write is kept by its largest value (VTK's dual depth
// peeling), so what two write of one depth is one layer, and one fragment may write what several would. Then
// both draw what is as close to their face as they may round differently; and no more, for behind the face
// their polynomials part.
float Reach() // of rounding, in voxels
{
  float voxel = max(max(length(indexToClip[0].xy), length(indexToClip[1].xy)), length(indexToClip[2].xy));
  return min(max(max(abs(cellClip.x), abs(cellClip.y)), abs(cellClip.w)) / voxel / 4194304.0 + 1e-6, Overlap);
}

#ifdef HASP_PEELS
#ifndef PASS_OUTPUT_1 // a pass declares what it writes to
layout(location = 1) out vec4 fragOutput1;
#endif
#ifndef PASS_OUTPUT_2
layout(location = 2) out vec4 fragOutput2;
#endif
#endif

vec3 roots; // along the ray, ascending
int rootCount = 0;
vec3 rayFrom, rayTo;

// The hit of a root; false if it is another cell's.
bool OwnHit(int number, out vec3 hit)
{
  hit = mix(rayFrom, rayTo, number == 0 ? roots.x : number == 1 ? roots.y : roots.z);
#ifdef HASP_PEELS
  float reach = Reach();
#else
  const float reach = 0.0;
#endif
  return all(greaterThanEqual(hit, vec3(-reach))) && all(lessThan(hit, vec3(1.0 + reach)));
}

// False if there are none.
bool FindRoots()
{
#ifdef HASP_LABELS
  EnterFrame(label);
#endif
  vec3 direction;
  float s;
  if (!ClipRay(rayFrom, rayTo, direction))
    return false;
  vec4 cubic = HaspRayBernstein(low, high, rayFrom, rayTo);
  if (!HaspFirstRoot(cubic, s))
    return false;
  vec2 later;
  rootCount = 1 + HaspLaterRoots(cubic, s, later);
  roots = vec3(s, later);
  return true;
}

#ifdef HASP_PEELS
void DrawHit(vec3 hit) // VTK's lines return from here
{
  gl_FragDepth = DepthOf(hit);
  //VTK::DepthPeeling::PreColor
  fragOutput0 = ShadeHit(hit);
  //VTK::DepthPeeling::Impl
}

void main()
{
  if (!FindRoots())
    discard;
  vec4 largest0 = vec4(-2.0), largest1 = vec4(-2.0), largest2 = vec4(-2.0); // below what they write
  bool any = false;
  for (int n = 0; n < rootCount; ++n)
  {
    vec3 hit;
    if (!OwnHit(n, hit))
      continue;
    any = true;
    DrawHit(hit);
    largest0 = max(largest0, fragOutput0);
    largest1 = max(largest1, fragOutput1);
    largest2 = max(largest2, fragOutput2);
  }
  if (!any)
    discard;
  fragOutput0 = largest0;
  fragOutput1 = largest1;
  fragOutput2 = largest2;
}
#else
void main()
{
  if (!FindRoots())
    discard;
  vec3 hit;
  int first = 0;
  while (first < rootCount && !OwnHit(first, hit))
    ++first;
  if (first == rootCount)
    discard;
  gl_FragDepth = DepthOf(hit);
  //VTK::DepthPeeling::PreColor
  vec4 color = ShadeHit(hit);
  for (int n = first + 1; n < rootCount; ++n) // behind it
    if (OwnHit(n, hit))
    {
      vec4 next = ShadeHit(hit);
      float share = (1.0 - color.a) * next.a, sum = color.a + share;
      color = vec4(sum > 0.0 ? mix(color.rgb, next.rgb, share / sum) : color.rgb, sum);
    }
  fragOutput0 = color;
  //VTK::DepthPeeling::Impl
}
#endif
