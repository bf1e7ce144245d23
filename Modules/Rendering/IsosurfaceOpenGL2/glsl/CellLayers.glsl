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

vec3 hits[3]; // nearest first
int hitCount = 0;

void AddHit(vec3 hit)
{
#ifdef HASP_PEELS
  float reach = Reach();
#else
  const float reach = 0.0;
#endif
  if (all(greaterThanEqual(hit, vec3(-reach))) && all(lessThan(hit, vec3(1.0 + reach))))
    hits[hitCount++] = hit;
}

// Where VTK's lines return, they return from here.
void DrawFrom(int first)
{
  gl_FragDepth = DepthOf(hits[first]);
  //VTK::DepthPeeling::PreColor
  vec4 color = ShadeHit(hits[first]);
#ifndef HASP_PEELS
  for (int n = first + 1; n < hitCount; ++n) // behind it
  {
    vec4 next = ShadeHit(hits[n]);
    float share = (1.0 - color.a) * next.a, sum = color.a + share;
    color = vec4(sum > 0.0 ? mix(color.rgb, next.rgb, share / sum) : color.rgb, sum);
  }
#endif
  fragOutput0 = color;
  //VTK::DepthPeeling::Impl
}

void main()
{
#ifdef HASP_LABELS
  EnterFrame(label);
#endif
  vec3 a, b, direction;
  float s;
  if (!ClipRay(a, b, direction))
    discard;
  vec4 cubic = HaspRayBernstein(low, high, a, b);
  if (!HaspFirstRoot(cubic, s))
    discard;
  vec2 later;
  int laterCount = HaspLaterRoots(cubic, s, later);
  AddHit(mix(a, b, s));
  if (laterCount > 0)
    AddHit(mix(a, b, later.x));
  if (laterCount > 1)
    AddHit(mix(a, b, later.y));
  if (hitCount == 0)
    discard;
  DrawFrom(0);
#ifdef HASP_PEELS
  for (int n = 1; n < hitCount; ++n)
  {
    vec4 written0 = fragOutput0, written1 = fragOutput1, written2 = fragOutput2;
    DrawFrom(n);
    fragOutput0 = max(fragOutput0, written0);
    fragOutput1 = max(fragOutput1, written1);
    fragOutput2 = max(fragOutput2, written2);
  }
#endif
}
