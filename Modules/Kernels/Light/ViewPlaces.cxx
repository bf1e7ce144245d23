#include "Light/ViewPlaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

LightLattice LightLattice::Around(const LitScene::Box& box)
{
  if (!(box.low.x <= box.high.x))
    return {};
  const glm::dvec3 size = box.high - box.low;
  const double longest = std::max({ size.x, size.y, size.z, 1e-300 });
  // A whole power of two, so that a scene that grows a little has the same.
  const double unit = std::exp2(std::ceil(std::log2(5.0 * longest / FinestUnits)));
  return { 0.5 * (box.low + box.high) - 0.5 * unit * FinestUnits, unit };
}

bool LightLattice::Holds(const LitScene::Box& box) const
{
  if (!(box.low.x <= box.high.x))
    return true;
  const glm::dvec3 margin(unit * 64.0), high = low + unit * double(FinestUnits);
  // Also not lost in a lattice that is far too coarse for it.
  const glm::dvec3 size = box.high - box.low;
  return this->unit > 0.0 && glm::all(glm::greaterThan(box.low, low + margin)) &&
         glm::all(glm::lessThan(box.high, high - margin)) &&
         std::max({ size.x, size.y, size.z }) * 64.0 > unit * FinestUnits;
}

ViewPlaces::ViewPlaces(const PictureView& view, const LightLattice& lattice, double pixelsACorner)
  : Lattice(lattice),
    ClipW(glm::row(view.indexToClip, 3))
{
  // As LightView: pixels a millimetre across the view at w = 1.
  const glm::dvec3 w(this->ClipW);
  double pixelsAMm = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 2; ++a)
  {
    glm::dvec3 across(glm::row(view.indexToClip, a));
    if (glm::dot(w, w) > 0.0)
      across -= w * (glm::dot(across, w) / glm::dot(w, w));
    pixelsAMm = std::min(pixelsAMm, 0.5 * glm::length(across) * view.size[a]);
  }
  this->UnitsACornerByW = pixelsACorner / (pixelsAMm * std::max(lattice.unit, 1e-300));
}

LightPlace ViewPlaces::At(const glm::dvec3& position, const glm::dvec3& normal) const
{
  const glm::dvec3 units = (position - this->Lattice.low) / this->Lattice.unit;
  const double wanted = this->UnitsACornerByW * glm::dot(this->ClipW, glm::dvec4(position, 1.0));
  LightPlace place;
  const double finest =
    std::clamp(wanted * std::sqrt(2.0), 1.0, double(LightLattice::FinestUnits)); // rounds
  place.level = std::min(std::ilogb(finest), LightLattice::Levels - 1);
  const glm::dvec3 steps = std::ldexp(1.0, -place.level) * units, corner = glm::floor(steps);
  place.corner = glm::ivec3(corner);
  place.within = glm::vec3(steps - corner);
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  place.face = axis + (normal[axis] < 0.0 ? 3 : 0);
  return place;
}

} // namespace hasp
