#version 150 core
#extension GL_ARB_explicit_attrib_location : enable
// Shades each pixel by what its discs have blended, and writes their blended depth.
//
// in   hitDepth              depth of the nearest disc; 1 where there is none
// in   sumNormal, sumDepth   see vtkHaspShellDiscFS.glsl
// in   hitNumber             of the nearest disc, from 1 (HASP_SELECTION)
// out  fragOutput0           colour, or what hardware selection asks for
//Hasp::Defines
//Hasp::SurfaceShading
//Hasp::SelectionColor

uniform sampler2D hitDepth;
uniform sampler2D sumNormal;
uniform sampler2D sumDepth;
#ifdef HASP_SELECTION
uniform sampler2D hitNumber;
#endif
uniform mat4 clipToView;
uniform vec4 viewportToDevice; // scale, offset: pixels to [-1,1]

#ifdef GL_ARB_explicit_attrib_location
layout(location = 0) // where passes add others; where they do not it is 0 all the same
#endif
out vec4 fragOutput0;
// Filled by VTK's passes, like the two lines in main().
//VTK::DepthPeeling::Dec

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(hitDepth, texel, 0).x;
  if (depth >= 1.0)
    discard;
  vec4 sum = texelFetch(sumNormal, texel, 0);
  vec4 sums = texelFetch(sumDepth, texel, 0);
  depth += sums.x / sum.w;
  gl_FragDepth = depth;

  //VTK::DepthPeeling::PreColor
#ifdef HASP_SELECTION
  fragOutput0 = SelectionColor(uint(texelFetch(hitNumber, texel, 0).x - 0.5));
#else
  vec2 device = gl_FragCoord.xy * viewportToDevice.xy + viewportToDevice.zw;
  vec4 view = clipToView *
    vec4(device, (2.0 * depth - gl_DepthRange.near - gl_DepthRange.far) / gl_DepthRange.diff, 1.0);
  vec3 position = view.xyz / view.w;
#ifdef HASP_LEVELS
  Material material = ColoredMaterial(vec4(sums.yzw / sum.w, 1.0));
#else
  Material material = PropertyMaterial();
#endif
  fragOutput0 = Shade(position, FaceEye(position, normalize(sum.xyz)), material);
#endif
  //VTK::DepthPeeling::Impl
}
