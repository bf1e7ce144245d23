#include "BoneSolid.h"

#include "FragmentLabels.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/GridSolid.h"
#include "Distance/KeptGrid.h"
#include "Grid/LabelGrid.h"
#include "Grid/ProgressPart.h"
#include "WorkingGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <stdexcept>
#include <string>

namespace hasp
{

GridGeometry WithSpacing(const GridGeometry& grid, double spacingMm)
{
  GridGeometry finer = grid;
  finer.dims = glm::ivec3(glm::ceil(glm::dvec3(grid.Cells()) * grid.spacing / spacingMm)) + 1;
  finer.spacing = glm::dvec3(spacingMm);
  return finer;
}

std::vector<std::uint8_t> MarkBone(const char* who, const BoneImage& bone, double isovalue,
  double ignoreBelowMm3, const ProgressFunction& progress)
{
  GeometryOf(bone.grey).Validate();
  if (!bone.labels)
    return KeepLargePieces(bone.grey, isovalue, ignoreBelowMm3, progress);
  CheckLabelGrid(who, GeometryOf(bone.grey), GeometryOf(*bone.labels));
  std::vector<std::uint8_t> mark = KeepLabel(*bone.labels, bone.label);
  std::visit(
    [&](const auto& grey)
    {
      for (std::size_t n = 0; n < mark.size(); ++n)
        mark[n] = mark[n] && double(grey.data[n]) >= isovalue;
    },
    bone.grey);
  return mark;
}

std::vector<std::uint8_t> IslandNear(const char* who, const BoneImage& bone, double isovalue,
  double ignoreBelowMm3, const glm::dvec3& place, double withinMm, const ProgressFunction& progress)
{
  const GridGeometry& ct = GeometryOf(bone.grey);
  std::vector<std::uint8_t> mark = MarkBone(who, bone, isovalue, ignoreBelowMm3, progress);
  double least = withinMm;
  std::size_t seed = mark.size();
  for (std::size_t s = 0; s < mark.size(); ++s)
    if (mark[s])
    {
      const double away =
        glm::distance(place, ct.IndexToWorld(glm::dvec3(SamplePlace(ct.dims, s))));
      if (away <= least)
        least = away, seed = s;
    }
  if (seed == mark.size())
    return {};
  FloodSamples(ct.dims, mark, seed, 1, 2);
  for (std::uint8_t& m : mark)
    m = m == 2;
  return mark;
}

SolidPointer BoneDistance::Solid() const
{
  return MakeGridSolid(this->distance, this->grid);
}

BoneDistance DistanceOfBone(const char* who, const AnyGridView& grey, double isovalue,
  std::span<const std::uint8_t> keep, double spacingMm, const ProgressFunction& progress)
{
  const GridGeometry& ct = GeometryOf(grey);
  const auto [first, last] = KeptRange(ct.dims, keep);
  if (first.x > last.x)
    throw std::invalid_argument(std::string(who) + ": there is no bone");
  BoneDistance bone;
  bone.grid = KeptGrid(ct, first, last, spacingMm);
  const GridGeometry& grid = bone.grid;
  CheckPoints(who, grid.dims, grid.spacing.x, GridRemedy);
  CoverageSettings settings;
  settings.isovalue = isovalue;
  settings.keep = keep;
  const std::vector<float> coverage = Coverage(grey, grid, settings, PartOf(progress, 0.0, 0.5));
  bone.distance = std::make_shared<const std::vector<float>>(
    CoverageDistanceBand(grid, coverage, PartOf(progress, 0.5, 1.0)));
  return bone;
}

} // namespace hasp
