#ifndef vtkHaspStereoPair_h
#define vtkHaspStereoPair_h

#include "vtkHaspCommonVolumeModule.h" // for export macro

#include <glm/mat4x4.hpp> // for the eyes

#include <optional> // for one eye

class vtkInformation;

/// How a rig that draws a frame for each eye tells mappers what the other one sees: with the
/// camera's vtkInformation (vtkCamera::GetInformation), for vtkCamera itself knows one eye. Which
/// of both is drawn, its LeftEye says. Functions, not classes: nothing is kept beside the keys. Any
/// thread, as long as no other thread uses the information meanwhile.
namespace hasp
{

/// World to OpenGL clip coordinates of each eye, clipping range and viewport's aspect included.
struct StereoPair
{
  glm::dmat4 left{ 1.0 }, right{ 1.0 };
};

/// Without a pair: says that there is one eye.
VTKHASPCOMMONVOLUME_EXPORT void SetStereoPair(
  vtkInformation* information, const std::optional<StereoPair>& pair);

/// What was set, bit by bit; none in mono, with VTK's own stereo, and where there is no information
/// (null).
VTKHASPCOMMONVOLUME_EXPORT std::optional<StereoPair> StereoPairOf(vtkInformation* information);

} // namespace hasp

#endif
