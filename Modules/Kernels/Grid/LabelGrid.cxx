#include "Grid/LabelGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <sstream>
#include <stdexcept>

namespace hasp
{

void CheckLabelGrid(const char* who, const GridGeometry& scan, const GridGeometry& labels)
{
  std::ostringstream text;
  text << who << ": the labels are of another grid than the volume: ";
  const auto write = [&](const char* what, const auto& a, const auto& b)
  {
    text << "their " << what << " is (" << a.x << ", " << a.y << ", " << a.z << "), the volume's ("
         << b.x << ", " << b.y << ", " << b.z << ")";
  };
  // How far the step changes what is at the far end, and then where the first sample is.
  const double tolerance =
    0.01 * glm::min(scan.spacing.x, glm::min(scan.spacing.y, scan.spacing.z));
  const glm::dvec3 size(scan.Cells());
  const auto farEndsMove = [&](const glm::dmat3& a, const glm::dmat3& b)
  {
    bool moves = false;
    for (int axis = 0; axis < 3; ++axis)
      moves = moves || !(size[axis] * glm::distance(a[axis], b[axis]) <= tolerance);
    return moves;
  };
  if (scan.dims != labels.dims)
    write("size", labels.dims, scan.dims);
  else if (!glm::all(glm::lessThanEqual(
             size * glm::abs(labels.spacing - scan.spacing), glm::dvec3(tolerance))))
    write("spacing", labels.spacing, scan.spacing);
  else if (farEndsMove(labels.IndexToWorldMatrix(), scan.IndexToWorldMatrix()))
    text << "their axes have other directions";
  else if (!(glm::distance(labels.origin, scan.origin) <= tolerance))
    write("origin", labels.origin, scan.origin);
  else
    return;
  text << "; resample them onto its grid";
  throw std::invalid_argument(text.str());
}

} // namespace hasp
