#pragma once
#include "StereoRig.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <array>

/// Head-mounted displays: two parallel cameras that go where the head goes. Plain values and pure
/// functions; any thread.
namespace hasp
{

/// How far one eye sees, as tangents of the angles from its axis. left + right > 0, up + down > 0:
/// an axis outside of the picture is one side < 0.
struct FieldOfView
{
  double left = 1.0, right = 1.0, up = 1.0, down = 1.0;
};

struct StereoHmd
{
  std::array<FieldOfView, 2> fields{}; ///< left eye, right eye
};

/// The view of one eye of a head: from half the separation beside it, along -(right x up), whatever
/// screen there is. Its axis ends 500 mm in front of the eye.
/// Throws std::invalid_argument, with the value and the legal range, for tangents that are not
/// finite or span nothing, and for a head whose right and up are no axes at right angles.
VTKHASPRENDERINGSTEREO_EXPORT EyeView ViewOfHmdEye(
  const StereoHmd& hmd, const StereoHead& head, StereoEye eye);

} // namespace hasp
