#include "DiscInput.h"

#include "Haptics/PointShell.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace
{

bool IsFinite(const glm::vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void Refuse(std::size_t disc, const Discs& discs, const std::string& why)
{
  throw std::invalid_argument(
    "disc " + std::to_string(disc) + " of " + std::to_string(discs.size()) + " " + why);
}

/// Of each point: that of the circle which holds its eight nearest neighbours, over eight.
void EstimateAreas(vtkPolyData* points, Discs& discs)
{
  constexpr int neighbours = 8;
  if (discs.size() <= neighbours)
    throw std::invalid_argument("areas can be estimated for more than 8 points; give these " +
                                std::to_string(discs.size()) + " an area array");
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(points);
  locator->BuildLocator();
  vtkNew<vtkIdList> near;
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    double at[3];
    points->GetPoint(n, at);
    locator->FindClosestNPoints(neighbours + 1, at, near); // and itself
    float farthest = 0.0F;
    for (vtkIdType m = 0; m < near->GetNumberOfIds(); ++m)
      farthest = std::max(farthest, glm::distance(discs[n].center, discs[near->GetId(m)].center));
    discs[n].areaMm2 = std::numbers::pi_v<float> * farthest * farthest / neighbours;
  }
}

} // namespace

std::shared_ptr<const Discs> DiscsOfShell(const hasp::PointShell& shell, int levels)
{
  const int drawn = levels > 0 ? std::min(levels, shell.Levels()) : shell.Levels();
  auto discs = std::make_shared<Discs>();
  if (drawn == 0)
    return discs;
  const std::uint32_t count = shell.LevelEnd(drawn - 1);
  discs->resize(count);
  std::uint32_t copied = 0;
  for (int level = 0; level < drawn; ++level)
    copied += hasp::CopyDiscs(
      shell.Level(level), static_cast<std::uint32_t>(level), std::span(*discs).subspan(copied));
  discs->resize(copied);
  for (hasp::ShellDisc& disc : *discs)
    disc.areaMm2 = static_cast<float>(shell.SurfaceArea() / count);
  return discs;
}

std::shared_ptr<const Discs> DiscsOfPoints(vtkPolyData* points, const std::string& areaArray)
{
  auto discs = std::make_shared<Discs>();
  const vtkIdType count = points->GetNumberOfPoints();
  if (count == 0)
    return discs;
  vtkDataArray* normals = points->GetPointData()->GetNormals();
  if (!normals)
    throw std::invalid_argument(
      "the points have no normals; pass them through vtkPolyDataNormals or vtkPCANormalEstimation");
  vtkDataArray* areas = points->GetPointData()->GetArray(areaArray.c_str());
  if (areas && areas->GetNumberOfComponents() != 1)
    throw std::invalid_argument("the area array has " +
                                std::to_string(areas->GetNumberOfComponents()) +
                                " components; an area is one number");
  for (vtkDataArray* array : { normals, areas })
    if (array && array->GetNumberOfTuples() != count)
      throw std::invalid_argument(std::string("there are ") +
                                  std::to_string(array->GetNumberOfTuples()) +
                                  (array == normals ? " normals" : " areas") + " for " +
                                  std::to_string(count) + " points; give one for each");
  discs->resize(static_cast<std::size_t>(count));
  for (vtkIdType n = 0; n < count; ++n)
  {
    hasp::ShellDisc& disc = (*discs)[n];
    double at[3], normal[3];
    points->GetPoint(n, at);
    normals->GetTuple(n, normal);
    disc.center = { at[0], at[1], at[2] };
    if (!IsFinite(disc.center))
      Refuse(n, *discs, "is not at a finite point");
    const glm::dvec3 direction(normal[0], normal[1], normal[2]);
    const double length = glm::length(direction);
    if (!(length > 0.0) || !std::isfinite(length))
      Refuse(n, *discs, "has a normal of length " + std::to_string(length));
    disc.normal = direction / length;
    if (areas)
      disc.areaMm2 = static_cast<float>(areas->GetTuple1(n));
  }
  if (!areas)
    EstimateAreas(points, *discs);
  return discs;
}

DiscBounds CheckDiscs(const Discs& discs, double overlap)
{
  DiscBounds bounds;
  if (discs.empty())
    return bounds;
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (std::size_t n = 0; n < discs.size(); ++n)
  {
    const hasp::ShellDisc& disc = discs[n];
    if (!IsFinite(disc.center) || !std::isfinite(disc.areaMm2))
      Refuse(n, discs, "is not finite");
    const float length = glm::length(disc.normal);
    if (!(std::abs(length - 1.0F) <= 0.01F))
      Refuse(n, discs, "has a normal of length " + std::to_string(length) + "; make it unit");
    if (disc.areaMm2 < 0.0F)
      Refuse(n, discs, "has an area of " + std::to_string(disc.areaMm2) + " mm^2");
    const float radius =
      static_cast<float>(overlap) * std::sqrt(disc.areaMm2 / std::numbers::pi_v<float>);
    const glm::vec3 reach =
      radius * glm::sqrt(glm::max(1.0F - disc.normal * disc.normal, glm::vec3(0.0F)));
    low = glm::min(low, disc.center - reach);
    high = glm::max(high, disc.center + reach);
  }
  bounds.low = low;
  bounds.high = high;
  return bounds;
}
