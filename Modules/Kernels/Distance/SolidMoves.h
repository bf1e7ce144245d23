#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/RigidPose.h"

namespace hasp
{

/// A solid where a pose puts it: what is at p comes to lie at pose.Place(p). A fragment's distances
/// are made once, and stay as they are while it is moved.
///
/// Values, faces and steepness are those of the part, exactly; gradients turn with it. Bounds move
/// along; of a pose that turns there are none, because values that are known to grow along the
/// part's axes are not known to do so along others.
/// Throws std::invalid_argument if the part is null, a number is not finite or the orientation's
/// length is not 1 within 1e-6. Any thread; O(1) more than the part to ask.
SolidPointer MakeMoved(SolidPointer part, const RigidPose& pose);

} // namespace hasp
