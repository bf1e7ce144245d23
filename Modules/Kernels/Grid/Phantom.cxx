#include "Grid/Phantom.h"
#include "Grid/PhantomAnatomy.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

Box BoxInAir(const PhantomSettings& settings)
{
  const PhantomShapes shapes = MakePhantomShapes(settings);
  Box box = PhantomSolid(settings).Bounds();
  box = { box.low - settings.scalpMm, box.high + settings.scalpMm };
  if (shapes.skin)
  {
    const Box skin = shapes.skin->Bounds();
    box = { glm::min(box.low, skin.low), glm::max(box.high, skin.high) };
  }
  constexpr double Air = 4.0;
  return { box.low - Air, box.high + Air };
}

} // namespace

std::vector<PhantomPart> PhantomParts(const PhantomSettings& settings)
{
  CheckPhantom(settings);
  std::vector<PhantomPart> parts;
  for (const auto& [part, solid] : MakePhantomShapes(settings).parts)
    parts.push_back(part);
  return parts;
}

const char* NameOf(PhantomPart part)
{
  switch (part)
  {
    case PhantomPart::Cranium:
      return "cranium";
    case PhantomPart::UpperTeeth:
      return "upper teeth";
    case PhantomPart::Mandible:
      return "mandible";
    case PhantomPart::LowerTeeth:
      return "lower teeth";
    default:
      return "fibula";
  }
}

AnalyticSolid PhantomSolid(const PhantomSettings& settings)
{
  CheckPhantom(settings);
  std::vector<AnalyticSolid> solids;
  for (const auto& [part, solid] : MakePhantomShapes(settings).parts)
    solids.push_back(solid);
  return AnalyticSolid::Union(solids);
}

AnalyticSolid PhantomSolid(const PhantomSettings& settings, PhantomPart part)
{
  CheckPhantom(settings);
  for (const auto& [name, solid] : MakePhantomShapes(settings).parts)
    if (name == part)
      return solid;
  throw std::invalid_argument(
    std::string("phantom: its anatomy has no ") + NameOf(part) + "; choose another one");
}

SolidDistance PhantomDistance(const PhantomSettings& settings, const glm::dvec3& point)
{
  return PhantomSolid(settings).Distance(point);
}

AnalyticVolume PhantomBone(const PhantomSettings& settings)
{
  return { "phantom bone",
    [solid = PhantomSolid(settings)](const glm::dvec3& p) { return -solid.Bound(p).mm; }, 1.0 };
}

std::vector<PhantomLandmark> PhantomLandmarks(const PhantomSettings& settings)
{
  CheckPhantom(settings);
  return MakePhantomShapes(settings).landmarks;
}

glm::dvec3 PhantomOuterTable(const PhantomSettings& settings, const glm::dvec3& direction)
{
  CheckPhantom(settings);
  const double along = glm::length(direction / (settings.skinRadii - settings.scalpMm));
  if (!(along > 0.0 && std::isfinite(along)))
    throw std::invalid_argument("phantom: the direction has no length");
  return settings.center + direction / along;
}

PhantomDefect DefectOf(const PhantomSettings& settings)
{
  PhantomDefect defect{};
  defect.center = PhantomOuterTable(settings, glm::normalize(glm::dvec3(-0.45, -0.70, 0.55)));
  const glm::dvec3 radii = settings.skinRadii - settings.scalpMm;
  defect.outward = glm::normalize((defect.center - settings.center) / (radii * radii));
  const glm::dvec3 sideways = glm::normalize(glm::cross(defect.outward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(sideways, defect.outward);
  defect.along = glm::normalize(0.8 * sideways + 0.6 * up); // skew: no symmetry hides a flip
  defect.across = glm::cross(defect.outward, defect.along);
  defect.lengthMm = 52.0;
  defect.widthMm = 28.0;
  return defect;
}

GridGeometry PhantomGrid(const glm::dvec3& spacing, const PhantomSettings& settings)
{
  CheckPhantom(settings);
  const Box box = BoxInAir(settings);
  GridGeometry grid;
  grid.spacing = spacing;
  for (int a = 0; a < 3; ++a)
  {
    const double steps = std::ceil((box.high[a] - box.low[a]) / spacing[a]);
    if (!(spacing[a] > 0.0 && steps < 1e6))
      throw std::invalid_argument(
        "phantom: spacing is " + std::to_string(spacing[a]) +
        " mm, must be > 0 and leave fewer than 1,000,000 samples an axis");
    grid.dims[a] = static_cast<int>(steps) + 1;
  }
  grid.origin = 0.5 * (box.low + box.high) - 0.5 * spacing * glm::dvec3(grid.dims - 1);
  grid.Validate();
  return grid;
}

GridGeometry PhantomGridOfSize(const glm::ivec3& dims, const PhantomSettings& settings)
{
  CheckPhantom(settings);
  for (int a = 0; a < 3; ++a)
    if (dims[a] < 2)
      throw std::invalid_argument(
        "phantom: " + std::to_string(dims[a]) + " samples along an axis, must be > 1");
  const Box box = BoxInAir(settings);
  GridGeometry grid;
  grid.dims = dims;
  grid.origin = box.low;
  grid.spacing = (box.high - box.low) / glm::dvec3(dims - 1);
  grid.Validate();
  return grid;
}

} // namespace hasp
