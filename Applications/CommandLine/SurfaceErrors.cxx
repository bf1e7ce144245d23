#include "SurfaceErrors.h"

#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double Grazing = 0.2;
constexpr double OtherSheetMm = 2.0;
}

SurfaceTruth TraceTruth(const IsosurfaceView& view,
  const std::function<std::optional<TrueHit>(const glm::dvec3&, const glm::dvec3&)>& first)
{
  SurfaceTruth truth(std::size_t(view.width) * view.height);
  ParallelFor(0, view.height, 4,
    [&](std::int64_t from, std::int64_t to)
    {
      for (auto y = int(from); y < to; ++y)
        for (int x = 0; x < view.width; ++x)
        {
          const auto [origin, direction] = view.Ray(x, y);
          truth[std::size_t(y) * view.width + x] = first(origin, direction);
        }
    });
  return truth;
}

SurfaceErrors MeasureErrors(
  const IsosurfaceView& view, const SurfaceTruth& truth, const SurfacePoints& shown)
{
  SurfaceErrors result;
  std::vector<double> errors;
  double squares = 0.0;
  int surface = 0, missed = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
  {
    const bool grazes = truth[n] && truth[n]->facing < Grazing;
    if ((!truth[n] && !shown[n]) || grazes)
      continue;
    ++surface;
    const double error =
      truth[n] && shown[n] ? glm::length(*shown[n] - truth[n]->position) : OtherSheetMm + 1.0;
    if (error > OtherSheetMm)
    {
      ++missed;
      continue;
    }
    errors.push_back(error);
    squares += error * error;
    if (error >= result.maxMm)
    {
      result.maxMm = error;
      result.maxX = static_cast<int>(n % view.width);
      result.maxY = static_cast<int>(n / view.width);
    }
  }
  result.pixels = static_cast<int>(errors.size());
  result.missed = surface > 0 ? double(missed) / surface : 0.0;
  if (errors.empty())
    return result;
  const auto p99 = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * (errors.size() - 1));
  std::nth_element(errors.begin(), p99, errors.end());
  result.p99Mm = *p99;
  result.rmsMm = std::sqrt(squares / errors.size());
  return result;
}

} // namespace hasp
