#pragma once
#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

/// It passes if the figure is no larger than the limit; what is no number does not.
inline void AddCase(ReportContext& context, const std::string& id, const std::string& text,
  double figure, double limit, const std::string& unit)
{
  context.report.stability.push_back({ id, text, figure <= limit, figure, limit, unit });
}

/// 0 if the call is refused by std::invalid_argument, else 1.
template <typename Call>
double Accepted(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument&)
  {
    return 0.0;
  }
  return 1.0;
}

/// Transforms of coverage; of binary ones the mask of it counts.
struct NamedTransform
{
  const char* name;
  std::vector<float> (*run)(const GridGeometry&, const std::vector<float>& coverage);
};
inline constexpr NamedTransform TrialTransforms[] = {
  { "chamfer", [](const GridGeometry& grid, const std::vector<float>& coverage)
    { return ChamferDistance(grid, coverage); } },
  { "exact", [](const GridGeometry& grid, const std::vector<float>& coverage)
    { return SignedEuclideanDistance(grid, MaskOf(coverage)); } },
  { "guide", [](const GridGeometry& grid, const std::vector<float>& coverage)
    { return CoverageDistance(grid, coverage); } },
};

} // namespace hasp
