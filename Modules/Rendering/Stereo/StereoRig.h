#pragma once
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// The eye rig: where two eyes look through one screen rectangle ("fish tank"). Plain values and
/// pure functions; any thread.
///
/// Each eye is an ordinary perspective camera whose axis is perpendicular to the screen and whose
/// window is shifted. The eye is then the position of the camera, so lighting, ray casting and
/// level of detail that read that position are right in every mapper. VTK's own stereo shears the
/// projection and its off-axis camera (9.1) hides the eye in the projection matrix: both are wrong
/// for volume mappers.
namespace hasp
{

/// A rectangle in space, in millimetres. In world coordinates, or those of the room (Transform).
struct StereoScreen
{
  glm::dvec3 center{ 0.0 };
  glm::dvec3 right{ 1, 0, 0 }; ///< along the lower edge; any length > 0
  glm::dvec3 up{ 0, 1, 0 }; ///< any length > 0, perpendicular to right; right x up faces the viewer
  double widthMm = 520.0;   ///< > 0
  double heightMm = 325.0;  ///< > 0
};

/// The viewer, in the coordinates of the screen.
struct StereoHead
{
  glm::dvec3 position{ 0, 0, 600 }; ///< between the eyes
  glm::dvec3 right{ 1, 0, 0 };      ///< from the left eye to the right one; any length > 0
  double eyeSeparationMm = 63.0;    ///< >= 0; adults: 54 to 74. Negative swaps the eyes: refused
  glm::dvec3 up{ 0, 1, 0 }; ///< perpendicular to right; read for head-mounted displays alone
};

struct StereoRig
{
  StereoScreen screen;
  StereoHead head;
};

enum class StereoEye
{
  Left,
  Right
};

/// What a camera needs to draw one eye's view: VTK's names and units.
struct EyeView
{
  glm::dvec3 position{ 0.0 };   ///< the eye
  glm::dvec3 focalPoint{ 0.0 }; ///< where the axis meets the screen's plane
  glm::dvec3 viewUp{ 0, 1, 0 }; ///< unit
  double viewAngleDegrees = 30; ///< vertical, in (0, 180): 2 atan(height / 2 / distance)
  glm::dvec2 windowCenter{
    0
  };                   ///< shift of the screen's middle from the axis, in half screen sizes
  double aspect = 1.0; ///< width / height of the screen
};

/// Throws std::invalid_argument, naming the value and the legal range, unless sizes are finite and
/// > 0, right and up are perpendicular (within 1e-6 of the cosine), the separation is finite and
/// >= 0, and both eyes are in front of the screen.
VTKHASPRENDERINGSTEREO_EXPORT void ValidateStereoRig(const StereoRig& rig);

/// The position of one eye: half the separation beside the head.
VTKHASPRENDERINGSTEREO_EXPORT glm::dvec3 EyePosition(const StereoHead& head, StereoEye eye);

/// The view of one eye. Throws like ValidateStereoRig.
/// With e the eye, c the screen's middle, d the distance of e from the plane, h the height:
/// angle = 2 atan(h / 2 / d), window centre = (c - e) . (right, up) / (half width, half height).
VTKHASPRENDERINGSTEREO_EXPORT EyeView ViewOfEye(const StereoRig& rig, StereoEye eye);

/// The point of the screen's plane that an eye sees at `device`, (-1,-1) lower left, (1,1) upper
/// right: the reverse of ProjectToScreen. A ray from view.position through it is that of a pixel.
VTKHASPRENDERINGSTEREO_EXPORT glm::dvec3 PointOnScreen(const EyeView& view, glm::dvec2 device);

/// The same rig in other coordinates: what the room's millimetres are in the world, say. `map` is a
/// rotation, a uniform scale > 0 and a translation (lengths scale along); otherwise throws
/// std::invalid_argument: a shear or a mirror has no viewer.
VTKHASPRENDERINGSTEREO_EXPORT StereoRig TransformStereoRig(
  const StereoRig& rig, const glm::dmat4& map);

/// Where a point lies on the screen, as an eye sees it: (-1,-1) lower left, (1,1) upper right.
/// Throws std::invalid_argument for a point at or behind the eye.
VTKHASPRENDERINGSTEREO_EXPORT glm::dvec2 ProjectToScreen(
  const StereoRig& rig, StereoEye eye, const glm::dvec3& point);

/// Disparity of a point: x on the screen for the right eye minus x for the left one, in millimetres
/// along the screen's right. Zero on the screen, positive behind it, negative in front:
/// separation * depth / (distance + depth) when the eyes are parallel to the screen.
VTKHASPRENDERINGSTEREO_EXPORT double ScreenDisparityMm(
  const StereoRig& rig, const glm::dvec3& point);

} // namespace hasp
