#version 150 core
#extension GL_ARB_explicit_attrib_location : enable
// Puts traced light over what was drawn.
//
// in   light        radiance times coverage, coverage; a texel a pixel of the viewport. 2 is added
//                   to the coverage where the rest shows what is behind, not what was drawn
// in   behind       what was there before anything was drawn
// in   firstPixel   of the viewport, in the window
// in   exposure     what radiance is multiplied by
// in   encoded      is radiance linear, and shown as sRGB?
// out  fragOutput0  colour times coverage, coverage: for blending with 1 and 1 - alpha
uniform sampler2D light, behind;
uniform ivec2 firstPixel;
uniform float exposure;
uniform bool encoded;

#ifdef GL_ARB_explicit_attrib_location
layout(location = 0)
#endif
out vec4 fragOutput0;

// IEC 61966-2-1
vec3 Encode(vec3 linear)
{
  vec3 low = 12.92 * linear, high = 1.055 * pow(max(linear, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, lessThan(linear, vec3(0.0031308)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - firstPixel;
  vec4 met = texelFetch(light, pixel, 0);
  if (met.a <= 0.0)
    discard;
  bool showsBehind = met.a >= 2.0;
  float coverage = showsBehind ? met.a - 2.0 : met.a;
  vec3 color = clamp(exposure * met.rgb / max(coverage, 1e-6), 0.0, 1.0);
  fragOutput0 = vec4((encoded ? Encode(color) : color) * coverage, coverage);
  if (showsBehind) // alone: whatever alpha the background has, nothing of what was drawn stays
    fragOutput0 = vec4(fragOutput0.rgb + (1.0 - coverage) * texelFetch(behind, pixel, 0).rgb, 1.0);
}
