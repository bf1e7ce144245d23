#include "BoneAround.h"

#include "LargePieces.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <variant>
#include <vector>

namespace hasp
{
namespace
{

/// Some of a volume's samples, from the first on each axis.
template <typename T>
vtkSmartPointer<vtkImageData> Part(
  const GridView<const T>& whole, const glm::ivec3& first, const glm::ivec3& dims)
{
  GridGeometry geometry = whole.geometry;
  geometry.origin = whole.geometry.IndexToWorld(glm::dvec3(first));
  geometry.dims = dims;
  std::vector<T> samples;
  samples.reserve(geometry.Size());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
    {
      const glm::ivec3& d = whole.geometry.dims;
      const T* row = whole.data + (std::size_t(first.z + k) * d.y + first.y + j) * d.x + first.x;
      samples.insert(samples.end(), row, row + dims.x);
    }
  return MakeImage(geometry, samples);
}

} // namespace

vtkSmartPointer<vtkImageData> BoneAround(vtkImageData* bone, const PartClaims& claims,
  const glm::dvec3& low, const glm::dvec3& high, double beyondMm)
{
  vtkSmartPointer<vtkImageData> around = BoneAround(ViewImage(bone), claims, low, high, beyondMm);
  if (!around)
    around = bone;
  return around;
}

vtkSmartPointer<vtkImageData> BoneAround(const AnyGridView& view, const PartClaims& claims,
  const glm::dvec3& low, const glm::dvec3& high, double beyondMm)
{
  const GridGeometry& g = GeometryOf(view);
  glm::dvec3 least(HUGE_VAL), most(-HUGE_VAL);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 index = g.WorldToIndex(glm::mix(low - beyondMm, high + beyondMm, side));
    least = glm::min(least, index);
    most = glm::max(most, index);
  }
  const glm::dvec3 last(g.dims - 1);
  const glm::ivec3 first(glm::clamp(glm::floor(least), glm::dvec3(0.0), last)),
    end(glm::clamp(glm::ceil(most), glm::dvec3(0.0), last));
  if (glm::any(glm::lessThan(end - first, glm::ivec3(1))))
    return nullptr;
  const vtkSmartPointer<vtkImageData> around =
    std::visit([&](const auto& whole) { return Part(whole, first, end - first + 1); }, view);
  const vtkSmartPointer<vtkImageData> pieces =
    LargePiecesOf(around, claims.isovalue, claims.ignoreBelowMm3);
  return pieces ? pieces : around;
}

} // namespace hasp
