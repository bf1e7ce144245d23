#include "SlicePlace.h"

#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace hasp
{

namespace
{

bool InImage(vtkImageSlice* slice, const glm::dvec3& world)
{
  vtkNew<vtkMatrix4x4> worldToData;
  vtkMatrix4x4::Invert(slice->GetMatrix(), worldToData);
  const double from[4] = { world.x, world.y, world.z, 1.0 };
  glm::dvec4 data;
  worldToData->MultiplyPoint(from, &data.x);
  const GridGeometry geometry = ImageGeometry(slice->GetMapper()->GetInput());
  const glm::dvec3 index = geometry.WorldToIndex(glm::dvec3(data) / data.w);
  // A place on the border itself is inside, whatever the last bits say.
  const double border = 0.5 + 1e-9;
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(-border))) &&
         glm::all(glm::lessThanEqual(index, glm::dvec3(geometry.dims - 1) + border));
}

/// The share of the way from a to b at which it meets the plane; nothing if it does not.
std::optional<double> Meet(const glm::dvec3& a, const glm::dvec3& b, const SlicePlane& plane)
{
  const double from = glm::dot(plane.point - a, plane.normal);
  const double along = glm::dot(b - a, plane.normal);
  const double share = from / along;
  if (along == 0.0 || !(share >= 0.0 && share <= 1.0))
    return std::nullopt;
  return share;
}

} // namespace

std::optional<SlicePlane> PlaneOf(vtkImageSlice* slice)
{
  if (slice == nullptr || slice->GetMapper() == nullptr ||
      slice->GetMapper()->GetInput() == nullptr)
    return std::nullopt;
  SlicePlane plane;
  slice->GetMapper()->GetSlicePlane()->GetOrigin(&plane.point.x);
  slice->GetMapper()->GetSlicePlane()->GetNormal(&plane.normal.x);
  plane.normal = glm::normalize(plane.normal);
  return plane;
}

std::optional<PixelPlace> PlaceInSlice(
  const SeenDepth& view, const glm::ivec2& pixel, vtkImageSlice* slice, const SlicePlane& plane)
{
  const glm::ivec2 at = pixel - view.origin;
  if (glm::any(glm::lessThan(at, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(at, view.size)))
    return std::nullopt;
  const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
  const glm::dvec3 near = view.Unproject(middle, 0.0), far = view.Unproject(middle, 1.0);
  const std::optional<double> share = Meet(near, far, plane);
  if (!share)
    return std::nullopt;
  const glm::dvec3 world = near + *share * (far - near);
  if (!InImage(slice, world))
    return std::nullopt;
  const glm::dvec2 beside = middle + glm::dvec2(1, 0);
  const glm::dvec3 neighbour =
    glm::mix(view.Unproject(beside, 0.0), view.Unproject(beside, 1.0), *share);
  return PixelPlace{ world, glm::length(neighbour - world) };
}

} // namespace hasp
