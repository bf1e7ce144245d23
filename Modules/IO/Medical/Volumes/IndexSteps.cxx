#include "Volumes/IndexSteps.h"
#include "Files/FileError.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{

double SkewDegrees(const glm::dmat3& steps)
{
  double worst = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const glm::dvec3 one = glm::normalize(steps[a]), other = glm::normalize(steps[(a + 1) % 3]);
    const double degrees = std::abs(glm::degrees(std::asin(glm::dot(one, other))));
    if (!std::isfinite(degrees))
      return std::numeric_limits<double>::quiet_NaN();
    worst = std::max(worst, degrees);
  }
  return worst;
}

void SetIndexSteps(
  const std::filesystem::path& file, const glm::dmat3& steps, GridGeometry& geometry)
{
  for (int a = 0; a < 3; ++a)
  {
    // hypot: neither 1e-200 nor 1e200 is lost on the way
    geometry.spacing[a] = std::hypot(steps[a].x, steps[a].y, steps[a].z);
    geometry.direction[a] = steps[a] / geometry.spacing[a];
  }
  try
  {
    GridGeometry upright = geometry;
    upright.direction = glm::dmat3(1.0);
    upright.Validate(); // sizes, spacing and origin: only then an angle means something
    if (const double skew = SkewDegrees(geometry.direction); !(skew <= SkewLimitDegrees))
      ThrowFileError(file, "its axes are " + Text(skew) +
                             " degrees off right angles; resample it to a right-angled grid in the "
                             "program it comes from");
    geometry.Validate();
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
}

} // namespace hasp
