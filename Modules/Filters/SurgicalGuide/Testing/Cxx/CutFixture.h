#pragma once
#include "FragmentCutter.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

/// Made-up bones with closed forms, scanned, and the blades that cut them.
namespace cuttest
{

/// A scan that owns its samples.
struct BoneScan
{
  hasp::GridGeometry grid;
  std::vector<std::int16_t> samples;

  hasp::AnyGridView View() const
  {
    return hasp::GridView<const std::int16_t>{ this->samples.data(), this->grid };
  }
};

/// `distance`: mm, negative inside. Bone is 1000 HU a mm at its surface, 226 HU on it.
inline BoneScan ScanOf(const std::function<double(const glm::dvec3&)>& distance,
  const glm::dvec3& half, const glm::dvec3& spacing = { 0.6, 0.6, 0.8 }, double angle = 0.3)
{
  BoneScan scan;
  scan.grid.dims = glm::ivec3(glm::ceil(2.0 * half / spacing)) + 1;
  scan.grid.spacing = spacing;
  scan.grid.direction =
    glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::normalize(glm::dvec3(1, -2, 3))));
  scan.grid.origin = -(scan.grid.direction * (0.5 * spacing * glm::dvec3(scan.grid.Cells())));
  const hasp::AnalyticVolume volume{ "bone",
    [distance](const glm::dvec3& p) { return -distance(p); }, 1.0 };
  scan.samples = hasp::SampleAnalytic<std::int16_t>(volume, scan.grid, 1000, 226);
  return scan;
}

/// A round bar of radius 6 along x, 40 mm and its round ends: a capsule.
inline double BarDistance(const glm::dvec3& p)
{
  return glm::length(p - glm::dvec3(std::clamp(p.x, -20.0, 20.0), 0, 0)) - 6.0;
}
inline BoneScan ScanOfBar()
{
  return ScanOf(BarDistance, { 34, 16, 14 });
}

/// One blade across x.
inline hasp::CutRecipe OneCut(const glm::dvec3& point, double kerfMm = 1.0)
{
  hasp::CutRecipe recipe;
  recipe.cuts = { { { point, { 1, 0, 0 }, { 0, 1, 0 }, 30.0, 30.0, kerfMm }, 8.0 } };
  return recipe;
}

/// The phantom's jaws.
inline BoneScan ScanOfJaw()
{
  BoneScan scan;
  scan.grid = { { 105, 89, 67 }, { -62, -92, -108 }, glm::dvec3(1.2), glm::dmat3(1) };
  scan.samples = hasp::SamplePhantom(scan.grid, {});
  return scan;
}
/// The lower arch as Phantom has it, mm from its front along it, left positive.
inline hasp::HorseshoeShape LowerArch()
{
  return { { 0, -58, -96 }, 22.0, 1.08, 61.0, 5.0, 5.5 };
}
/// Two cuts through the mandible's right body, as around a tumour there.
inline hasp::CutRecipe JawCuts()
{
  const hasp::HorseshoeShape arch = LowerArch();
  const auto blade = [&](double along)
  {
    const glm::dvec3 normal =
      glm::normalize(arch.PointAt(along + 0.01) - arch.PointAt(along - 0.01));
    return hasp::BoneCut{ { arch.PointAt(along), normal, { 0, 0, 1 }, 50.0, 200.0, 1.5 }, 8.0 };
  };
  hasp::CutRecipe recipe;
  recipe.spacingMm = 0.8;
  recipe.cuts = { blade(-10.0), blade(-40.0) };
  recipe.resected = { arch.PointAt(-25.0) };
  return recipe;
}

} // namespace cuttest
