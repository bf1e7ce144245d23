#include "CellLabels.h"

#include "vtkMatrix4x4.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

glm::dmat4 RigidPose(vtkMatrix4x4* matrix)
{
  const auto refuse = [](const std::string& what)
  {
    throw std::invalid_argument(
      "the pose of a label must be rigid, a rotation and a translation: " + what);
  };
  const glm::dmat4 pose = glm::transpose(glm::make_mat4(matrix->GetData()));
  for (int n = 0; n < 16; ++n)
    if (!std::isfinite(glm::value_ptr(pose)[n]))
      refuse("it has an element that is not finite");
  for (int column = 0; column < 4; ++column)
    if (pose[column].w != (column == 3 ? 1.0 : 0.0))
      refuse("its last row is not 0 0 0 1");
  const glm::dmat3 turn(pose);
  const glm::dmat3 square = glm::transpose(turn) * turn;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(square[column][row] - (row == column)) <= 1e-4))
        refuse("it scales or shears (the dot product of columns " + std::to_string(column) +
               " and " + std::to_string(row) + " is " + std::to_string(square[column][row]) + ")");
  if (glm::determinant(turn) < 0.0)
    refuse("it mirrors (the determinant is -1)");
  return pose;
}

bool AnyTranslucent(const CellLabels& labels)
{
  return std::any_of(labels.begin(), labels.end(),
    [](const auto& entry)
    {
      const CellLabel& label = entry.second;
      return label.visible && label.color && label.color->a < 1.0F;
    });
}

} // namespace hasp
