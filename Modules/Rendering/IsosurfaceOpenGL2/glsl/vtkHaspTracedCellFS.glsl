#version 150 core
#extension GL_ARB_explicit_attrib_location : enable
// Shades what the ray of this pixel met on the CPU. Writes the depth of the hit.
//
// in   gradients    of the volume at the hit, per voxel; depth in [0,1], or more where nothing was met
// in   numbers      of the cell met, for selection
// in   light        HASP_TRACED_LIGHT: openness of its surroundings, share of the first light, [0,1]
// in   firstPixel   of the picture, in the window
// out  fragOutput0  colour, or what hardware selection asks for
//Hasp::Defines
//Hasp::SurfaceShading
//Hasp::SelectionColor

uniform sampler2D gradients;
#ifdef HASP_SELECTION
uniform usampler2D numbers;
#endif
#ifdef HASP_TRACED_LIGHT
uniform sampler2D light;
#endif
uniform ivec2 firstPixel;
uniform mat4 clipToIndex;
uniform mat4 indexToView;
uniform mat3 normalToView;
uniform vec4 viewportToDevice; // scale, offset: pixels to [-1,1]

#ifdef GL_ARB_explicit_attrib_location
layout(location = 0) // where passes add others; where they do not it is 0 all the same
#endif
out vec4 fragOutput0;
// Filled by VTK's passes, like the two lines in main().
//VTK::DepthPeeling::Dec

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy) - firstPixel;
  vec4 met = texelFetch(gradients, texel, 0);
  if (met.w > 1.0)
    discard;
  gl_FragDepth = gl_DepthRange.near + gl_DepthRange.diff * met.w;

  //VTK::DepthPeeling::PreColor
#ifdef HASP_SELECTION
  fragOutput0 = SelectionColor(texelFetch(numbers, texel, 0).x);
#else
  vec2 device = gl_FragCoord.xy * viewportToDevice.xy + viewportToDevice.zw;
  vec4 index = clipToIndex * vec4(device, 2.0 * met.w - 1.0, 1.0);
  vec3 position = (indexToView * (index / index.w)).xyz;
  vec3 normal = FaceEye(position, normalize(normalToView * -met.xyz));
  Material material = PropertyMaterial();
#ifdef HASP_TRACED_LIGHT
  vec2 seen = texelFetch(light, texel, 0).xy;
  material.ambient *= seen.x;
  material.diffuse *= seen.x;
  firstLightShare = seen.y;
#endif
  fragOutput0 = Shade(position, normal, material);
#endif
  //VTK::DepthPeeling::Impl
}
