#pragma once

class vtkRenderer;

namespace hasp
{

struct PartOnBone;

/// Looks at a part and its way off the bone from the side, the way up. RENDER.
void LookAtWay(vtkRenderer* renderer, const PartOnBone& body);

} // namespace hasp
