#pragma once
#include "Planning/GuideRecipe.h"

#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

/// Meshes of what hasp-guide-rival takes off its shell.
namespace hasp
{

using Mesh = vtkSmartPointer<vtkPolyData>;

/// Of the landmarks, besides the width: the scan that is looked at, and how deep tools go.
constexpr double AroundMm = 12.0;
constexpr int Round = 64; ///< corners of a hole

/// Closed, of triangles, its points welded.
inline Mesh Cleaned(vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(1e-6);
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  return clean->GetOutput();
}

/// The filter is better on small triangles: each is cut into 4^finer.
inline Mesh Placed(
  vtkPolyDataAlgorithm* source, const glm::dmat3& axes, const glm::dvec3& at, int finer)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, at[row]);
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkLinearSubdivisionFilter> small;
  small->SetInputData(Cleaned(source));
  small->SetNumberOfSubdivisions(finer);
  vtkNew<vtkTransformPolyDataFilter> move;
  move->SetInputConnection(small->GetOutputPort());
  move->SetTransform(transform);
  return Cleaned(move);
}

inline std::vector<Mesh> Tools(const GuideRecipe& recipe)
{
  const double above = recipe.gapMm + recipe.thicknessMm + 8.0;
  std::vector<Mesh> tools;
  for (const GuideSlot& slot : recipe.slots)
  {
    const double below = std::min(slot.depthMm, AroundMm);
    const glm::dmat3 axes = SawAxes(slot.normal, recipe.withdrawal);
    vtkNew<vtkCubeSource> box;
    box->SetXLength(SlotWidthMm(recipe, slot.kerfMm));
    box->SetYLength(slot.lengthMm);
    box->SetZLength(above + below);
    tools.push_back(Placed(box, axes, slot.point + 0.5 * (above - below) * axes[2], 3));
  }
  for (const GuideHole& hole : recipe.holes)
  {
    const double below = std::min(hole.depthMm, AroundMm);
    const glm::dmat3 axes =
      SawAxes(std::abs(hole.axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), hole.axis);
    const glm::dvec3 up = glm::normalize(hole.axis);
    const glm::dvec3 x = glm::normalize(axes[1] - glm::dot(axes[1], up) * up);
    vtkNew<vtkCylinderSource> drill; // along its y
    drill->SetHeight(above + below);
    drill->SetRadius(0.5 * hole.diameterMm);
    drill->SetResolution(Round);
    tools.push_back(
      Placed(drill, { x, up, glm::cross(x, up) }, hole.point + 0.5 * (above - below) * up, 1));
  }
  return tools;
}

} // namespace hasp
