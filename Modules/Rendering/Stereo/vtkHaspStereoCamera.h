#ifndef vtkHaspStereoCamera_h
#define vtkHaspStereoCamera_h

#include "StereoRig.h" // for StereoRig

class vtkCamera;

/// Between the eye rig and VTK's cameras. Functions, not classes: nothing is kept.
/// Threads: RENDER, or the one that owns the camera.
namespace hasp
{

/// Makes `camera` the given eye: sets position, focal point, view up, angle and window centre, and
/// switches off what would add to them (VTK's off-axis projection, shear, parallel projection).
/// The clipping range stays: reset it afterwards. The viewport's aspect must be the screen's
/// width / height. Throws std::invalid_argument like ValidateStereoRig, and if the eye is so near
/// that the screen's height fills more than VTK's 179 degrees.
VTKHASPRENDERINGSTEREO_EXPORT void SetCameraToEye(
  vtkCamera* camera, const StereoRig& rig, StereoEye eye);

/// The rig of an ordinary camera: the screen stands at the focal point, filling the view, and the
/// eyes stand beside the camera's position.
///
/// aspect           width / height of the viewport, > 0
/// eyeAngleDegrees  at the focal point between the eyes, in [0, 90]; 2 is VTK's habit. The eyes are
///                  2 distance tan(angle / 2) apart.
///
/// Throws std::invalid_argument for a parallel projection (it has no eye), VTK's off-axis
/// projection or a shear.
VTKHASPRENDERINGSTEREO_EXPORT StereoRig RigFromCamera(
  vtkCamera* camera, double aspect, double eyeAngleDegrees);

} // namespace hasp

#endif
