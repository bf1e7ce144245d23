// What one cell adds to the blended normal and colour of the pixel whose hit is in its support: the cell and
// half a cell around it, so that up to eight cells blend (EWA-like; Paper VI). The weight and its slope are
// zero at the support's border; so normals are smooth and colours continuous where trilinear ones jump.
//
// in   hitDepth, hitFrame   what HASP_HITS wrote
// out  fragOutput0          gradient of the samples in view directions times weight; weight
// out  blendDiffuse, blendAmbient   colours times weight; the weight is that of fragOutput0
uniform sampler2D hitDepth;
uniform sampler2D hitFrame;
#if defined(HASP_COLORS) || defined(HASP_LABELS)
layout(location = 1) out vec4 blendDiffuse;
layout(location = 2) out vec4 blendAmbient;
#endif

// The pixel's hit in cell coordinates: along the ray to where depth is that of the hit.
vec3 HitInCell(float depth)
{
  vec3 onRay = PointOnRay();
  vec3 direction = (onRay + vec3(cell.xyz)) * eyeIndex.w - eyeIndex.xyz;
  direction /= max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  float device = (2.0 * depth - gl_DepthRange.near - gl_DepthRange.far) / gl_DepthRange.diff;
  vec2 start = cellClip.zw + onRay.x * indexToClip[0].zw + onRay.y * indexToClip[1].zw +
    onRay.z * indexToClip[2].zw;
  vec2 slope = direction.x * indexToClip[0].zw + direction.y * indexToClip[1].zw +
    direction.z * indexToClip[2].zw;
  return onRay + direction * ((device * start.y - start.x) / (slope.x - device * slope.y));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(hitDepth, pixel, 0).x;
  if (depth >= 1.0)
    discard;
#ifdef HASP_LABELS
  EnterFrame(label);
  if (texelFetch(hitFrame, pixel, 0).x != float(label.x & LabelFrame)) // a surface that moves otherwise
    discard;
#endif
  vec3 hit = HitInCell(depth);
  vec3 off = hit - 0.5; // from the cell's middle; the support ends at 1
  vec3 hat = max(1.0 - off * off, 0.0);
  hat *= hat;
  float weight = hat.x * hat.y * hat.z;
  if (!(weight > 0.0))
    discard;
  // The gradient at the cell's middle averages all 8 corners: with that at the hit a quarter of the noise's
  // error goes, with this half.
  fragOutput0 = vec4(normalToView * -HaspTrilinearGradient(low, high, vec3(0.5)) * weight, weight);
#if defined(HASP_COLORS) || defined(HASP_LABELS)
  Material material = CellMaterial(clamp(hit, 0.0, 1.0));
  blendDiffuse = vec4(material.diffuse * weight, 0.0);
  blendAmbient = vec4(material.ambient * weight, 0.0);
#endif
}
