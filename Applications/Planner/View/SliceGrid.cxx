#include "View/SliceGrid.h"

#include "Grid/Trilinear.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <glm/common.hpp>

namespace hasp
{

namespace
{

constexpr vtkIdType MostAsked = 1'000'000;

/// Of a grid one sample thick along some axis, as of one with more.
std::optional<double> SampleAnyThickness(const AnyGridView& grid, const glm::dvec3& index)
{
  const GridGeometry& geometry = GeometryOf(grid);
  const glm::dvec3 last = glm::dvec3(geometry.dims - 1);
  // What ClampInto has put onto the border may be beyond it by its last bits.
  const glm::dvec3 at = glm::clamp(index, glm::dvec3(0.0), last);
  if (glm::any(glm::greaterThan(glm::abs(at - index), glm::dvec3(1e-6))))
    return std::nullopt;
  if (geometry.dims.x > 1 && geometry.dims.y > 1 && geometry.dims.z > 1)
    return std::visit([&](const auto& view) { return SampleTrilinear(view, at); }, grid);
  const glm::ivec3 nearest = glm::ivec3(glm::round(at));
  return std::visit(
    [&](const auto& view) { return double(view(nearest.x, nearest.y, nearest.z)); }, grid);
}

} // namespace

WorldBox BoxOf(vtkImageData* image)
{
  const GridGeometry geometry = ImageGeometry(image);
  const double most = std::numeric_limits<double>::max();
  WorldBox box{ glm::dvec3(most), glm::dvec3(-most) };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 place = geometry.IndexToWorld(side * glm::dvec3(geometry.dims) - 0.5);
    box.low = glm::min(box.low, place);
    box.high = glm::max(box.high, place);
  }
  return box;
}

glm::dvec3 ClampInto(vtkImageData* image, const glm::dvec3& place)
{
  const GridGeometry geometry = ImageGeometry(image);
  const glm::dvec3 index = geometry.WorldToIndex(place);
  const glm::dvec3 inside = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(geometry.dims - 1));
  return inside == index ? place : geometry.IndexToWorld(inside);
}

double StepAlong(vtkImageData* image, int worldAxis)
{
  const GridGeometry geometry = ImageGeometry(image);
  int along = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(geometry.direction[axis][worldAxis]) >
        std::abs(geometry.direction[along][worldAxis]))
      along = axis;
  return geometry.spacing[along];
}

std::optional<double> GreyAt(vtkImageData* image, const glm::dvec3& place)
{
  try
  {
    const AnyGridView grid = ViewImage(image);
    return SampleAnyThickness(grid, GeometryOf(grid).WorldToIndex(place));
  }
  catch (const std::invalid_argument&)
  {
    return std::nullopt;
  }
}

glm::dvec2 GreyQuantiles(vtkImageData* image, double lowShare, double highShare)
{
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  if (!samples || samples->GetNumberOfTuples() == 0)
    return glm::dvec2(0.0);
  const vtkIdType count = samples->GetNumberOfTuples();
  const vtkIdType stride = (count + MostAsked - 1) / MostAsked;
  std::vector<double> values;
  values.reserve(std::size_t(count / stride + 1));
  for (vtkIdType i = 0; i < count; i += stride)
    values.push_back(samples->GetComponent(i, 0));
  const auto quantile = [&](double share)
  {
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return { quantile(lowShare), quantile(highShare) };
}

} // namespace hasp
