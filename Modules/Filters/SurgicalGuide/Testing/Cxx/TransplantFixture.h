#pragma once
#include "CutFixture.h"
#include "Grid/AnalyticShapes.h"
#include "Grid/Phantom.h"
#include "Planning/TransplantRecipe.h"

/// The phantom's jaw with a defect at its chin, and its fibula: two segments from one fill it.
namespace transplanttest
{

inline hasp::PhantomSettings Anatomy()
{
  hasp::PhantomSettings settings;
  settings.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
  return settings;
}

/// Its fibula's middle line: a bow of 5 mm on 340 mm.
inline std::vector<glm::dvec3> Bow()
{
  std::vector<glm::dvec3> bow;
  for (int n = -17; n <= 17; ++n)
    bow.push_back({ 150.0, -5.0 * (1.0 - n * n / 289.0), 10.0 * n });
  return bow;
}

/// A part of that world.
inline cuttest::BoneScan Scan(
  const glm::ivec3& dims, const glm::dvec3& origin, const glm::dvec3& spacing)
{
  cuttest::BoneScan scan;
  scan.grid = { dims, origin, spacing, glm::dmat3(1) };
  scan.samples = hasp::SamplePhantom(scan.grid, Anatomy());
  return scan;
}
inline cuttest::BoneScan ScanOfJaw()
{
  return Scan({ 84, 71, 45 }, { -62, -92, -125 }, glm::dvec3(1.5));
}
inline cuttest::BoneScan ScanOfLeg(const glm::dvec3& spacing = { 1.1, 1.1, 2.0 })
{
  const glm::dvec3 size(24, 24, 358);
  return Scan(glm::ivec3(glm::ceil(size / spacing)), { 138, -16, -179 }, spacing);
}

/// The jaw's middle line.
inline hasp::HorseshoeShape Arch()
{
  return { { 0, -58, -96 }, 22.0, 1.08, 61.0, 5.0, 5.5 };
}

/// From 40 mm right of the chin to 14 mm left of it. The segments' lateral faces look upwards, so
/// that the wedge between them opens to a side of the guide and not through it.
inline hasp::TransplantRecipe Recipe()
{
  hasp::TransplantRecipe r;
  r.path = { Arch().PointAt(-40.0), Arch().PointAt(-14.0), Arch().PointAt(14.0) };
  const double kerf = 1.5;
  r.resection.spacingMm = 1.2;
  const auto saw = [&](std::size_t from, std::size_t to)
  {
    const glm::dvec3 inwards = glm::normalize(r.path[to] - r.path[from]);
    r.resection.cuts.push_back(
      { { r.path[from] + 0.5 * kerf * inwards, inwards, { 0, 0, 1 }, 50.0, 60.0, kerf }, 8.0 });
  };
  saw(0, 1);
  saw(2, 1);
  r.resection.resected = { Arch().PointAt(-14.0) };
  r.outward = { { 0, 0, 1 } };
  r.leastSegmentMm = 20.0;
  r.donor.axis = { { 150, 0, -173 }, { 150, 0, 173 } };
  r.findAxis = true;
  r.donor.lateral = glm::normalize(glm::dvec3(7.8, -5.7, 0)); // square on the shaft's lateral face
  r.betweenMm = 5.0;
  r.vessel = { { 142, 2, -150 }, { 142, -3, 0 }, { 142, 2, 150 } };
  r.paddle =
    hasp::SkinPaddle{ { { 165, -5, -90 }, { 165, 15, -80 }, { 165, 15, -65 }, { 165, -5, -60 } },
      { 155, -3, -80 } };
  return r;
}

inline hasp::BoneImage ImageOf(const cuttest::BoneScan& scan)
{
  return { scan.View(), {}, 1 };
}

} // namespace transplanttest
