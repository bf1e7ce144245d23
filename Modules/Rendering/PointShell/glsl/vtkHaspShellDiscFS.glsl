#version 150 core
// Meets the pixel's ray with the plane of one disc; discards outside the disc and the low-pass filter.
//
// in   axesPixel, axesW, axesZ   the disc p = centre + a u + b v projects to the pixel
//                                centerPixel + (a U + b V) / (1 + a Wu + b Wv), likewise for depth
// in   tolerance                 of depth: what is so far behind the nearest disc blends with it
// in   viewNormal                unit, view coordinates; weight
// out  HASP_HITS                 depth; with HASP_SELECTION the number of the disc, from 1
// out  sums                      else: normal times weight, weight; depth behind the nearest disc times
//                                weight, colour times weight (HASP_LEVELS)
//Hasp::Defines
#ifndef HASP_PLANES
#define HASP_PLANES 0 // clipping planes
#endif

flat in vec2 centerPixel;
flat in vec4 axesPixel;
flat in vec2 axesW;
flat in vec3 axesZ;
flat in float tolerance;
flat in vec4 viewNormal;
#if HASP_PLANES > 0
uniform vec4 planes[HASP_PLANES]; // local coordinates: plane . (p, 1) >= 0 is kept
flat in vec3 center;
flat in vec3 axisU;
flat in vec3 axisV;
#endif
#ifdef HASP_LEVELS
flat in vec3 levelColor;
#endif
#ifdef HASP_HITS
#ifdef HASP_SELECTION
flat in float number;
out vec4 fragOutput0;
#endif
#else
uniform sampler2D hitDepth;
out vec4 sums[2]; // one variable: its locations are 0 and 1 also where none can be named
#endif

const float FilterPixels = 0.75; // radius of the screen-space low-pass filter
const float Sharpness = 3.0;    // of the Gaussian: exp(-3) at the rim, nearly all of which is taken off

void main()
{
  vec2 offset = gl_FragCoord.xy - centerPixel;
  vec4 m = axesPixel - axesW.xxyy * offset.xyxy;
  vec2 p = vec2(m.w * offset.x - m.z * offset.y, m.x * offset.y - m.y * offset.x) / (m.x * m.w - m.z * m.y);
  float square = dot(p, p);
  float filtered = dot(offset, offset) / (FilterPixels * FilterPixels);
  if (!(square <= 1.0)) // outside, or the plane is seen from its side
  {
    if (filtered > 1.0)
      discard;
    p = square < 1e12 ? p * inversesqrt(square) : vec2(0.0);
    square = 1.0;
  }
  float z = (axesZ.x + dot(axesZ.yz, p)) / (1.0 + dot(axesW, p));
  if (abs(z) > 1.0)
    discard;
#if HASP_PLANES > 0
  vec4 local = vec4(center + p.x * axisU + p.y * axisV, 1.0);
  for (int n = 0; n < HASP_PLANES; ++n)
    if (dot(planes[n], local) < 0.0)
      discard;
#endif
  float depth = 0.5 * (gl_DepthRange.diff * z + gl_DepthRange.near + gl_DepthRange.far);
#ifdef HASP_HITS
#ifdef HASP_SELECTION
  depth += tolerance * square; // of discs that overlap, the one whose middle is nearest is picked
  fragOutput0 = vec4(number);
#endif
  gl_FragDepth = depth;
#else
  float behind = depth - texelFetch(hitDepth, ivec2(gl_FragCoord.xy), 0).x;
  if (behind > tolerance)
    discard;
  float weight = viewNormal.w * (exp(-Sharpness * min(square, filtered)) - 0.9 * exp(-Sharpness));
  sums[0] = vec4(viewNormal.xyz, 1.0) * weight;
#ifdef HASP_LEVELS
  sums[1] = vec4(behind, levelColor) * weight;
#else
  sums[1] = vec4(behind * weight, 0.0, 0.0, 0.0);
#endif
#endif
}
