#include "Isosurface/LightView.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

LightView::LightView(const CellTracer& tracer, const PictureView& view,
  const TracedPicture& picture, double pixelsACorner)
  : Tracer(&tracer),
    Picture(&picture),
    Eye(glm::inverse(view.indexToClip) * glm::dvec4(0, 0, -1, 0)),
    ClipW(glm::row(view.indexToClip, 3)),
    Unit(UnitOf(tracer.Cells().geometry))
{
  if (this->Eye.w != 0.0)
    this->Eye /= this->Eye.w;
  // Pixels a millimetre across the view at w = 1. What an off-axis view adds along its direction
  // does not count.
  const glm::dvec3 spacing = tracer.Cells().geometry.spacing, w = glm::dvec3(this->ClipW) / spacing;
  double pixelsAMm = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 2; ++a)
  {
    glm::dvec3 across = glm::dvec3(glm::row(view.indexToClip, a)) / spacing;
    if (glm::dot(w, w) > 0.0)
      across -= w * (glm::dot(across, w) / glm::dot(w, w));
    pixelsAMm = std::min(pixelsAMm, 0.5 * glm::length(across) * view.size[a]);
  }
  this->UnitsACornerByW = pixelsACorner / (pixelsAMm * this->Unit);
}

double LightView::UnitOf(const GridGeometry& geometry)
{
  const glm::dvec3 extent = glm::dvec3(geometry.dims) * geometry.spacing;
  return std::max({ extent.x, extent.y, extent.z }) / FinestUnits;
}

CellHit LightView::HitOf(std::size_t pixel) const
{
  CellHit hit{};
  hit.number = this->Picture->cells[pixel];
  hit.cell = this->Picture->corners[pixel];
  hit.local = this->Picture->places[pixel];
  hit.gradient = glm::vec3(this->Picture->gradients[pixel]);
  const glm::dvec3 direction = hit.Position() * this->Eye.w - glm::dvec3(this->Eye);
  hit.fromInside = glm::dot(glm::dvec3(hit.gradient), direction) < 0.0;
  return hit;
}

LightPlace LightView::PlaceOf(const CellHit& hit) const
{
  const glm::dvec3& spacing = this->Tracer->Cells().geometry.spacing;
  const glm::dvec3 index = hit.Position(), units = index * (spacing / this->Unit);
  const double wanted = this->UnitsACornerByW * glm::dot(this->ClipW, glm::dvec4(index, 1.0));
  LightPlace place;
  const double finest = std::clamp(wanted * std::sqrt(2.0), 1.0, double(FinestUnits)); // rounds
  place.level = std::min(std::ilogb(finest), Levels - 1);
  const glm::dvec3 steps = std::ldexp(1.0, -place.level) * units, corner = glm::floor(steps);
  place.corner = glm::ivec3(corner);
  place.within = glm::vec3(steps - corner);
  const glm::dvec3 normal = (hit.fromInside ? 1.0 : -1.0) * glm::dvec3(hit.gradient) / spacing;
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  place.face = axis + (normal[axis] < 0.0 ? 3 : 0);
  return place;
}

} // namespace hasp
