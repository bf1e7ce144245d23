#pragma once
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

class vtkImageData;
class vtkRenderer;
class vtkVolume;

namespace hasp
{

struct Passport;

/// How a volume is shown without an extracted surface; numbers are values of its samples.
struct VolumeLook
{
  std::array<double, 2> window{ 0.0, 1.0 }; ///< of the brightest values: what is dark, what bright
  std::optional<double> skin;               ///< where skin meets air; none: no skin is shown
  double boneRamp = 1.0; ///< > 0; bone is half as opaque as it gets at its value, and clear this
                         ///< far below
};

/// What suits a volume of that passport. HU: a window of bone, skin at -300, as far as the values
/// reach there. Others: all values, no skin, a ramp of a fortieth of them.
VolumeLook UsualLook(const Passport& passport);

/// "window 0 to 2000".
std::string WindowText(const VolumeLook& look);

/// Bytes of the samples that a volume is drawn from.
std::size_t VolumeBytes(vtkVolume* volume);

/// Why the renderer's OpenGL cannot hold the samples, where that is known; else empty. VTK itself
/// says it on standard output. RENDER thread, in an open window.
std::string WhyTooLarge(vtkImageData* image, vtkRenderer* renderer);

/// The brightest value along each line of sight (VTK's GPU ray caster, maximum intensity), in
/// white or another colour that its property is given: clear at the window's lower end and below,
/// opaque at its upper end and above, linear between. What is opaque and drawn before it ends the
/// lines. No shading, no depth. A sample each quarter of the smallest spacing: a voxel is missed by
/// an eighth of its width at most, on the far face of the volume by a quarter. VTK looks opacities
/// up in 1,024 steps over all values, so a value may be shown as half a step beside it. An axis
/// with one sample is shown as thick as its spacing. The image is kept, not copied, unless it has
/// such an axis. RENDER thread; the samples once more on the GPU.
vtkSmartPointer<vtkVolume> MakeBrightest(vtkImageData* image, const std::array<double, 2>& window);

/// Skin and bone, translucent, shaded by the gradient (VTK's GPU ray caster, compositing). Opacity
/// is of a length, the cube root of a voxel's volume, so that it looks alike at all spacings.
/// Otherwise as MakeBrightest; a sample each half of the smallest spacing.
vtkSmartPointer<vtkVolume> MakeTranslucent(
  vtkImageData* image, double bone, const VolumeLook& look, const std::array<double, 3>& color);

/// Moves the bone of MakeTranslucent's volume to another value, or gives it another colour.
void SetTranslucentBone(
  vtkVolume* volume, double bone, const VolumeLook& look, const std::array<double, 3>& color);

} // namespace hasp
