#ifndef PropPose_h
#define PropPose_h

#include "Grid/RigidPose.h"
#include "vtkHaspInteractionHapticsModule.h" // for export macro

class vtkMatrix4x4;
class vtkProp3D;

/// Poses of props, for what moves rigidly. Functions; RENDER.
namespace hasp
{

/// A matrix as a pose. Throws std::invalid_argument if it scales, mirrors or shears (by more than
/// 1e-6) or is not finite.
VTKHASPINTERACTIONHAPTICS_EXPORT RigidPose PoseOf(const vtkMatrix4x4* matrix);
/// Where a prop's data lie in the world: of its matrix. Throws as above.
VTKHASPINTERACTIONHAPTICS_EXPORT RigidPose PoseOf(vtkProp3D* prop);

VTKHASPINTERACTIONHAPTICS_EXPORT void SetMatrix(vtkMatrix4x4* matrix, const RigidPose& pose);

/// Moves a prop as a body of the world: `motion` behind what its user matrix says already. A matrix
/// of its own, so that one the application shares between props is left as it is.
VTKHASPINTERACTIONHAPTICS_EXPORT void SetUserPose(vtkProp3D* prop, const RigidPose& pose);
/// Of its user matrix; the identity without one. Throws as PoseOf.
VTKHASPINTERACTIONHAPTICS_EXPORT RigidPose UserPose(vtkProp3D* prop);

} // namespace hasp

#endif
