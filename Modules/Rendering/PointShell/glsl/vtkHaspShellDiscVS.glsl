#version 150 core
// One disc as the rectangle of pixels that it covers: two triangles, six vertices.
//
// in   discs           two texels a disc: centre, area; normal (unit), level. Local coordinates, mm
// in   discBits        the same bits as integers, for the level (HASP_LEVELS)
// out  the disc as the fragment shader meets it, relative to its centre; see there
//Hasp::Defines
#ifndef HASP_PLANES
#define HASP_PLANES 0 // clipping planes
#endif

uniform samplerBuffer discs;
#ifdef HASP_LEVELS
uniform usamplerBuffer discBits;
uniform vec3 levelColors[8];
flat out vec3 levelColor;
#endif
uniform mat4 localToClip;
uniform mat4 localToView;
uniform mat3 normalToView;
uniform vec4 eyeLocal;       // (eye, 1), or (minus the view direction, 0) if parallel
uniform vec2 viewport;       // pixels
uniform vec2 viewportOrigin; // pixels of the window
uniform vec2 depthStep;      // clip z and w of a mm away from the eye
uniform float overlap;       // radius over that of the circle with the disc's area
uniform int culledSide;      // 0 none, 1 discs that face away, 2 those that face the eye, 3 all

flat out vec2 centerPixel;
flat out vec4 axesPixel;
flat out vec2 axesW;
flat out vec3 axesZ;
flat out float tolerance;
flat out vec4 viewNormal;
#if HASP_PLANES > 0
flat out vec3 center;
flat out vec3 axisU;
flat out vec3 axisV;
#endif
#ifdef HASP_SELECTION
flat out float number;
#endif

const float FilterPixels = 0.75; // as in the fragment shader
const float AwayShare = 1e-3;   // weight of a disc that faces away; alone it counts in full

// The least and the largest of dot(J, p) / (1 + dot(s, p)) for |p| <= 1, where |s| < 1.
vec2 Range(vec2 J, vec2 s)
{
  float slope = dot(J, s), rest = 1.0 - dot(s, s);
  return (-slope + vec2(-1.0, 1.0) * sqrt(slope * slope + rest * dot(J, J))) / rest;
}

void main()
{
  int disc = gl_VertexID / 6, corner = gl_VertexID % 6;
  vec4 first = texelFetch(discs, 2 * disc);
  vec3 normal = texelFetch(discs, 2 * disc + 1).xyz;
  float radius = overlap * sqrt(first.w * 0.3183098861838);
  vec3 u = radius * normalize(cross(normal, abs(normal.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  vec3 v = cross(normal, u);
  bool away = dot(normal, eyeLocal.xyz - eyeLocal.w * first.xyz) < 0.0;

  vec4 c = localToClip * vec4(first.xyz, 1.0);
  vec4 cu = localToClip * vec4(u, 0.0);
  vec4 cv = localToClip * vec4(v, 0.0);
  vec2 device = c.xy / c.w;
  axesW = vec2(cu.w, cv.w) / c.w;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // out of sight
  if (!(c.w > 0.0) || !(dot(axesW, axesW) < 1.0) || (culledSide & (away ? 1 : 2)) != 0)
    return;
  vec2 scale = 0.5 * viewport / c.w;
  vec2 pixelU = (cu.xy - device * cu.w) * scale;
  vec2 pixelV = (cv.xy - device * cv.w) * scale;
  axesPixel = vec4(pixelU, pixelV);
  axesZ = vec3(c.z, cu.z, cv.z) / c.w;
  vec2 rangeX = Range(vec2(pixelU.x, pixelV.x), axesW);
  vec2 rangeY = Range(vec2(pixelU.y, pixelV.y), axesW);
  vec2 low = min(vec2(rangeX.x, rangeY.x), -FilterPixels);
  vec2 high = max(vec2(rangeX.y, rangeY.y), FilterPixels);
  int which = corner < 3 ? corner : corner - 2; // 0 1 2, 1 2 3
  vec2 pixel = vec2((which & 1) != 0 ? high.x : low.x, (which & 2) != 0 ? high.y : low.y);
  gl_Position = vec4(device + pixel * 2.0 / viewport, 0.0, 1.0);
  centerPixel = viewportOrigin + (0.5 * device + 0.5) * viewport;

  float reach = max(length(mat3(localToView) * u), length(mat3(localToView) * v));
  vec2 behind = c.zw + reach * depthStep;
  tolerance = 0.5 * gl_DepthRange.diff * max(behind.x / behind.y - axesZ.x, 0.0);
  viewNormal = vec4(normalize(normalToView * normal), away ? AwayShare : 1.0);
#ifdef HASP_LEVELS
  levelColor = levelColors[int(texelFetch(discBits, 2 * disc + 1).w & 7u)];
#endif
#if HASP_PLANES > 0
  center = first.xyz;
  axisU = u;
  axisV = v;
#endif
#ifdef HASP_SELECTION
  number = float(disc + 1);
#endif
}
