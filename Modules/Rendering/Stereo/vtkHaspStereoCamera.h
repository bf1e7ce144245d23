#ifndef vtkHaspStereoCamera_h
#define vtkHaspStereoCamera_h

#include "StereoOutput.h" // for EyeGrid
#include "StereoRig.h"    // for StereoRig

#include <glm/mat4x4.hpp> // for the room

class vtkCamera;

/// Between the eye rig and VTK's cameras. Functions, not classes: nothing is kept.
/// Threads: RENDER, or the one that owns the camera.
namespace hasp
{

/// Makes `camera` the given eye: sets position, focal point, view up, angle and window centre, and
/// switches off what would add to them (VTK's off-axis projection, shear, parallel projection,
/// explicit projection and aspect).
/// The clipping range stays: reset it afterwards. The viewport's aspect must be the screen's
/// width / height. Throws std::invalid_argument like ValidateStereoRig, and if the eye is so near
/// that the screen's height fills more than VTK's 179 degrees.
VTKHASPRENDERINGSTEREO_EXPORT void SetCameraToEye(
  vtkCamera* camera, const StereoRig& rig, StereoEye eye);

/// The same for any eye's view, drawn into the pixels of `grid`, whatever their shape: where the
/// viewport has another aspect than the view, or the grid is shifted, the camera's user transform
/// stretches the picture: a view that one turns or moves already is drawn so, in those pixels.
VTKHASPRENDERINGSTEREO_EXPORT void SetCameraToView(
  vtkCamera* camera, const EyeView& view, StereoEye eye, const EyeGrid& grid);

/// The rig of an ordinary camera: the screen stands at the focal point, filling the view, and the
/// eyes stand beside the camera's position.
///
/// aspect           width / height of the viewport, > 0
/// eyeAngleDegrees  at the focal point between the eyes, in [0, 90]; 2 is VTK's habit. The eyes are
///                  2 distance tan(angle / 2) apart.
///
/// Throws std::invalid_argument for a parallel projection (it has no eye), VTK's off-axis
/// projection, a shear, or an explicit projection or aspect. So do the functions below.
VTKHASPRENDERINGSTEREO_EXPORT StereoRig RigFromCamera(
  vtkCamera* camera, double aspect, double eyeAngleDegrees);

/// Where a room with this screen lies in the camera's world: the screen stands at the focal point,
/// upright in the view, and is as high as the view there (as wide, where the camera's angle is the
/// horizontal one). All of the room has one scale.
VTKHASPRENDERINGSTEREO_EXPORT glm::dmat4 RoomOnScreen(
  vtkCamera* camera, const StereoScreen& roomScreen);

/// A room's screen and head in that world: head and eye separation are scaled along, so that depth
/// looks as it would on a screen of that size. Moving the camera moves the scene before the viewer.
VTKHASPRENDERINGSTEREO_EXPORT StereoRig RigOnScreen(vtkCamera* camera, const StereoRig& roomRig);

/// Moves the camera along its axis until RoomOnScreen has the scale 1: a millimetre of the world is
/// one on the screen. The focal point stays; reset the clipping range afterwards.
VTKHASPRENDERINGSTEREO_EXPORT void ShowLifeSize(vtkCamera* camera, const StereoScreen& roomScreen);

} // namespace hasp

#endif
