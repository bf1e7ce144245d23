#pragma once
#include "Planning/Plan.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <string>

namespace hasp
{

/// A part as it is planned, and the bone that it is put on: what a test fit needs. Immutable once
/// made.
struct PartOnBone
{
  PlanId object = 0;
  std::string called;                     ///< "guide 8"
  vtkSmartPointer<vtkPolyData> part;      ///< triangles, world mm, in its planned place
  vtkSmartPointer<vtkImageData> bone;     ///< around the part and its way, world; bone is:
  double isovalue = 226.0;                ///< value >= isovalue
  glm::dvec3 withdrawal{ 0.0, 0.0, 1.0 }; ///< unit, world: the part lifts off along it
  glm::dvec3 Middle() const               ///< of the part's box
  {
    const double* box = this->part->GetBounds();
    return 0.5 * glm::dvec3(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
  }
  static constexpr double LiftMm = 30.0; ///< so far off a test fit begins
};

} // namespace hasp
