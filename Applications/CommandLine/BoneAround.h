#pragma once
#include "Evaluation/PartClaims.h"
#include "Grid/GridView.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

class vtkImageData;

namespace hasp
{

/// What a picture of a part on its bone is to show: the volume around the box from `low` to `high`
/// (world mm), so far beyond it on all sides, without pieces that the claims ignore. A head-rest
/// and the far side of a head stay out. The volume itself where the box lies beside it. A copy of
/// that much of the volume; O(its samples).
vtkSmartPointer<vtkImageData> BoneAround(vtkImageData* bone, const PartClaims& claims,
  const glm::dvec3& low, const glm::dvec3& high, double beyondMm);
/// The same of a view; nullptr where the box lies beside the volume.
vtkSmartPointer<vtkImageData> BoneAround(const AnyGridView& bone, const PartClaims& claims,
  const glm::dvec3& low, const glm::dvec3& high, double beyondMm);

} // namespace hasp
