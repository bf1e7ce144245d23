#include "StereoWindow.h"

#include <glm/geometric.hpp>

#include <stdexcept>

namespace hasp
{

void ValidateStereoWindow(const StereoWindow& window)
{
  if (window.screen && window.hmd)
    throw std::invalid_argument(
      "stereo window: a screen and a head-mounted display at once; take one away");
  if (window.screen)
  {
    StereoRig rig; // a viewer before the middle, for the check of the screen
    rig.screen = *window.screen;
    rig.head.right = rig.screen.right;
    rig.head.position = rig.screen.center + glm::cross(rig.screen.right, rig.screen.up);
    rig.head.eyeSeparationMm = 0.0;
    ValidateStereoRig(rig);
  }
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
    if (window.hmd)
    {
      const double aspect = ViewOfHmdEye(*window.hmd, {}, eye).aspect;
      if (window.lens)
        ValidateLens(*window.lens, aspect);
    }
  if (window.lens && window.screen)
    ValidateLens(*window.lens, window.screen->widthMm / window.screen->heightMm);
}

std::array<EyeView, 2> ViewsOfEyes(
  const StereoWindow& window, StereoHead roomHead, const glm::dmat4& roomToWorld)
{
  if (window.output.layout == StereoLayout::Mono)
    roomHead.eyeSeparationMm = 0.0;
  StereoRig rig{ window.screen.value_or(StereoScreen{}), roomHead };
  if (window.screen)
    ValidateStereoRig(rig); // in the room: its errors tell millimetres
  rig = TransformStereoRig(rig, roomToWorld);
  if (window.hmd)
    return { ViewOfHmdEye(*window.hmd, rig.head, StereoEye::Left),
      ViewOfHmdEye(*window.hmd, rig.head, StereoEye::Right) };
  if (!window.screen)
    throw std::invalid_argument("stereo window: neither a screen nor a head-mounted display");
  return { ViewOfEye(rig, StereoEye::Left), ViewOfEye(rig, StereoEye::Right) };
}

} // namespace hasp
