#version 150 core
// Puts two eyes' pictures into one output: StereoOutput.cxx in integers again, so that both give
// the same bytes.
//
// in   leftEye, rightEye    the eyes' pictures, 8 bits a channel; the same one twice if one is drawn
//      leftLens, rightLens  with HASP_LENS: LensTable::positions, channels one above the other
//      outputLayout         number of a hasp::StereoLayout; others show one eye as it is
//      halved               hasp::StereoResolution::Half, for interlaced and checkerboard
//      firstIsRight         the right eye has what else is the left one's
//      flip                 turned across, turned up and down
//      size, eyeSize        pixels of the output and of an eye's picture
//      origin               of the output in the framebuffer
// out  color                opaque
//Hasp::Defines
uniform sampler2D leftEye;
uniform sampler2D rightEye;
uniform int outputLayout;
uniform int halved;
uniform int firstIsRight;
uniform ivec2 flip;
uniform ivec2 size;
uniform ivec2 eyeSize;
uniform ivec2 origin;
out vec4 color;

#ifdef HASP_LENS
uniform sampler2D leftLens;
uniform sampler2D rightLens;
uniform int channels;

ivec3 Texel(sampler2D eye, ivec2 pixel)
{
  return ivec3(texelFetch(eye, clamp(pixel, ivec2(0), eyeSize - 1), 0).rgb * 255.0 + 0.5);
}

int Channel(sampler2D eye, sampler2D lens, ivec2 pixel, int channel)
{
  vec2 position =
    texelFetch(lens, ivec2(pixel.x, pixel.y + (channels == 3 ? channel * eyeSize.y : 0)), 0).rg;
  if (position.x < -8388608.0) // LensTable::Dark
    return 0;
  ivec2 at = ivec2(position);
  ivec2 low = at >> 8, part = at & 255;
  int lower = Texel(eye, low)[channel] * (256 - part.x) +
              Texel(eye, low + ivec2(1, 0))[channel] * part.x;
  int upper = Texel(eye, low + ivec2(0, 1))[channel] * (256 - part.x) +
              Texel(eye, low + ivec2(1, 1))[channel] * part.x;
  return (lower * (256 - part.y) + upper * part.y + 32768) >> 16;
}

ivec3 Eye(bool right, ivec2 pixel)
{
  ivec3 rgb;
  for (int channel = 0; channel < 3; ++channel)
    rgb[channel] = right ? Channel(rightEye, rightLens, pixel, channel)
                         : Channel(leftEye, leftLens, pixel, channel);
  return rgb;
}
#else
ivec3 Eye(bool right, ivec2 pixel)
{
  vec4 texel = right ? texelFetch(rightEye, pixel, 0) : texelFetch(leftEye, pixel, 0);
  return ivec3(texel.rgb * 255.0 + 0.5);
}
#endif

const int SideBySide = 1, TopBottom = 2, Anaglyph = 5, Interlaced = 6, Checkerboard = 7;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
  ivec2 fromTop = ivec2(pixel.x, size.y - 1 - pixel.y);
  bool second = false;
  if (outputLayout == SideBySide)
  {
    second = fromTop.x >= eyeSize.x;
    fromTop.x -= second ? eyeSize.x : 0;
  }
  else if (outputLayout == TopBottom)
  {
    second = fromTop.y >= eyeSize.y;
    fromTop.y -= second ? eyeSize.y : 0;
  }
  else if (outputLayout == Interlaced)
  {
    second = (fromTop.y & 1) != 0;
    fromTop.y >>= halved;
  }
  else if (outputLayout == Checkerboard)
  {
    second = ((fromTop.x + fromTop.y) & 1) != 0;
    fromTop.x >>= halved;
  }
  ivec2 from = ivec2(fromTop.x, eyeSize.y - 1 - fromTop.y);
  from += flip * (eyeSize - 1 - 2 * from);
  bool right = second != (firstIsRight != 0);
  ivec3 rgb = Eye(right, from);
  if (outputLayout == Anaglyph)
  {
    int red = (77 * rgb.r + 150 * rgb.g + 29 * rgb.b + 128) >> 8; // StereoOutput.cxx, Luminance
    rgb = ivec3(red, Eye(!right, from).gb);
  }
  color = vec4(vec3(rgb) / 255.0, 1.0);
}
