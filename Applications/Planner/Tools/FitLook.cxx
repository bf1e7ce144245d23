#include "Tools/FitLook.h"

#include "Tools/PartOnBone.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

void LookAtWay(vtkRenderer* renderer, const PartOnBone& body)
{
  constexpr double FromAbove = 0.6; // so that the inner side of a rim does not hide the bone
  const glm::dvec3& off = body.withdrawal;
  const glm::dvec3 head = std::abs(off.z) < 0.95 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  const glm::dvec3 to = glm::normalize(glm::normalize(glm::cross(head, off)) + FromAbove * off);
  const glm::dvec3 middle = body.Middle();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(middle.x, middle.y, middle.z);
  camera->SetPosition(middle.x + to.x, middle.y + to.y, middle.z + to.z);
  camera->SetViewUp(off.x, off.y, off.z);
  double box[6];
  body.part->GetBounds(box);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double way = PartOnBone::LiftMm * off[axis];
    box[2 * axis] += std::min(way, 0.0);
    box[2 * axis + 1] += std::max(way, 0.0);
  }
  renderer->ResetCamera(box);
}

} // namespace hasp
