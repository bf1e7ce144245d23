#version 430 core
// Shades each pixel by the normal and the colours that its cells have blended, at the depth of its hit.
//
// in   hitDepth                        depth of hits; 1 where there is none
// in   blendedNormal                   sum of gradients times weights, view directions; sum of weights
// in   blendedDiffuse, blendedAmbient  sums of colours times weights
// in   clipToView, viewportToDevice
// out  fragOutput0                     colour
//Hasp::Defines
//Hasp::SurfaceShading

uniform sampler2D hitDepth;
uniform sampler2D blendedNormal;
#ifdef HASP_BLENDED_COLORS
uniform sampler2D blendedDiffuse;
uniform sampler2D blendedAmbient;
#endif
uniform mat4 clipToView;
uniform vec4 viewportToDevice;
layout(location = 0) out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(hitDepth, pixel, 0).x;
  if (depth >= 1.0)
    discard;
  vec4 sum = texelFetch(blendedNormal, pixel, 0);
  vec2 device = gl_FragCoord.xy * viewportToDevice.xy + viewportToDevice.zw;
  vec4 view = clipToView *
    vec4(device, (2.0 * depth - gl_DepthRange.near - gl_DepthRange.far) / gl_DepthRange.diff, 1.0);
  vec3 position = view.xyz / view.w;
  Material material = PropertyMaterial();
#ifdef HASP_BLENDED_COLORS
  material.diffuse = texelFetch(blendedDiffuse, pixel, 0).rgb / sum.w;
  material.ambient = texelFetch(blendedAmbient, pixel, 0).rgb / sum.w;
#endif
  fragOutput0 = Shade(position, FaceEye(position, normalize(sum.xyz)), material);
  gl_FragDepth = depth;
}
