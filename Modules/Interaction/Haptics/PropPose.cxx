#include "PropPose.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProp3D.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <stdexcept>

namespace hasp
{

RigidPose PoseOf(const vtkMatrix4x4* matrix)
{
  glm::dmat3 axes;
  glm::dvec3 place;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      axes[column][row] = matrix->GetElement(row, column);
    place[row] = matrix->GetElement(row, 3);
  }
  const glm::dmat3 square = glm::transpose(axes) * axes;
  double off = std::abs(matrix->GetElement(3, 3) - 1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      off = std::max(off, std::abs(square[column][row] - (row == column ? 1.0 : 0.0)));
  // Not <=: a number that is none must not pass.
  if (!(off <= 1e-6) || !(glm::determinant(axes) > 0.0) || !std::isfinite(glm::dot(place, place)))
    throw std::invalid_argument(
      "a prop that is touched or moved must stand rigidly in the world; its "
      "matrix scales, mirrors or shears: apply that to its data instead");
  return { place, glm::normalize(glm::quat_cast(axes)) };
}

RigidPose PoseOf(vtkProp3D* prop)
{
  return PoseOf(prop->GetMatrix());
}

void SetMatrix(vtkMatrix4x4* matrix, const RigidPose& pose)
{
  const glm::dmat3 axes = glm::mat3_cast(pose.orientation);
  matrix->Identity();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, pose.position[row]);
  }
}

void SetUserPose(vtkProp3D* prop, const RigidPose& pose)
{
  vtkNew<vtkMatrix4x4> own;
  SetMatrix(own, pose);
  prop->SetUserMatrix(own);
}

RigidPose UserPose(vtkProp3D* prop)
{
  return prop->GetUserMatrix() != nullptr ? PoseOf(prop->GetUserMatrix()) : RigidPose{};
}

} // namespace hasp
