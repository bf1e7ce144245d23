#include "Reduction/BakeFitBody.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/KeptGrid.h"
#include "Distance/ScanMargin.h"
#include "Grid/ProgressPart.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
template <typename Error>
[[noreturn]] void Refuse(const auto&... parts)
{
  std::ostringstream text;
  text << "fit body: ";
  (text << ... << parts);
  throw Error(text.str());
}

void CheckBake(const GridGeometry& scan, const BoneShares& shares, const FitBakeSettings& s)
{
  scan.Validate();
  if (shares.shares.size() != scan.Size() || shares.labels.size() != scan.Size())
    Refuse<std::invalid_argument>("there are ", shares.shares.size(), " shares and ",
      shares.labels.size(), " labels, must be as many as the scan has voxels, ", scan.Size());
  if (!(s.spacingMm >= 0.05 && s.spacingMm <= 5.0))
    Refuse<std::invalid_argument>("spacingMm is ", s.spacingMm, ", must be in [0.05, 5]");
  if (!(s.rangeMm >= std::max(1.0, 4.0 * s.spacingMm) && s.rangeMm <= 40.0))
    Refuse<std::invalid_argument>(
      "rangeMm is ", s.rangeMm, ", must be in [1, 40] and at least 4 times spacingMm");
}

/// About: samples that are nearer to the surface than half a step, each for a square of it.
double SurfaceMm2(const std::vector<float>& distances, double step)
{
  const auto near = [step](float mm) { return std::abs(mm) < 0.5 * step; };
  return double(std::count_if(distances.begin(), distances.end(), near)) * step * step;
}
} // namespace

BakedFitBody BakeFitBody(const GridGeometry& scan, const BoneShares& shares, std::uint16_t label,
  const FitBakeSettings& settings, const ProgressFunction& progress)
{
  CheckBake(scan, shares, settings);
  const GridView<const std::uint16_t> labels{ shares.labels.data(), scan };
  const std::vector<std::uint8_t> keep = KeepLabel(labels, label);
  const auto [first, last] = KeptRange(scan.dims, keep);
  if (label == 0 || first.x > last.x)
    Refuse<std::runtime_error>(
      "label ", label, " has no bone: nothing of it is half as bright as its own inside");
  const GridGeometry tight = KeptGrid(scan, first, last, settings.spacingMm);
  const double margin = settings.rangeMm - KeptGridMarginSteps * settings.spacingMm;
  const glm::dvec3 dims = glm::dvec3(tight.dims) + 2.0 * (margin / settings.spacingMm + 2.0);
  if (const double samples = dims.x * dims.y * dims.z; samples > double(settings.mostSamples))
    Refuse<std::invalid_argument>("label ", label, ": its grid would have ", samples,
      " samples, at most ", settings.mostSamples, " are allowed; choose a larger spacingMm (now ",
      settings.spacingMm, " mm)");
  const std::vector<float> cover = Coverage(GridView<const float>{ shares.shares.data(), scan },
    tight, { .isovalue = 0.5, .keep = keep }, PartOf(progress, 0.0, 0.2));
  if (std::none_of(cover.begin(), cover.end(), [](float share) { return share > 0.5F; }))
    Refuse<std::runtime_error>("label ", label, ": its bone is thinner than the spacing of ",
      settings.spacingMm, " mm; choose a smaller one");
  const GridGeometry grid = GeometryWithMargin(tight, margin);
  const std::vector<float> distances =
    CoverageDistance(grid, CoverageWithMargin(tight, cover, margin), PartOf(progress, 0.2, 0.8));
  BakedFitBody baked;
  baked.origin = scan.IndexToWorld(0.5 * (glm::dvec3(first) + glm::dvec3(last)));
  const GridView<const float> view{ distances.data(), grid };
  baked.map = std::make_shared<const DistanceMap>(
    view, DistanceMapSettings{ .rangeMm = settings.rangeMm, .origin = baked.origin });
  baked.shell = PointShell::OfSurface(view, baked.origin,
    { .points = int(std::clamp(SurfaceMm2(distances, settings.spacingMm) / settings.body.pointMm2,
        1024.0, double(settings.body.mostPoints))) },
    PartOf(progress, 0.8, 1.0));
  baked.body = std::make_shared<const FitBody>(baked.map, baked.shell, settings.body);
  return baked;
}

} // namespace hasp
