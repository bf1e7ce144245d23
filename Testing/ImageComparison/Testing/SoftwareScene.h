#pragma once
#include "RGBPicture.h"

#include <cstdint>

/// A picture like those we render, from thirty lines that need no GPU: a ball before another before
/// a bright bar, smooth shading, edges of 4x4 samples a pixel.
struct SoftwareScene
{
  int width = 200;
  int height = 150;
  double shiftX = 0; ///< pixels, everything but the background
  double shiftY = 0;
  double eye = 0;          ///< pixels; nearer things move further
  double shade = 1;        ///< factor on all colours but the background's
  bool withBar = true;     ///< the part that may be missing
  bool wrongDepth = false; ///< the far ball drawn over the near one

  hasp::RGBPicture Draw() const;
};

/// Left and right eye beside each other.
hasp::RGBPicture DrawStereo(double leftEye, double rightEye);

/// As softpipe differs from llvmpipe: at most 6 levels, 0.06 in the mean of all channels.
hasp::RGBPicture AddRendererNoise(hasp::RGBPicture picture, std::uint32_t seed);
