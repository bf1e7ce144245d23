#include "DonorAxis.h"

#include "BoneSolid.h"
#include "FragmentLabels.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* Who = "donor axis";
constexpr double SliceMm = 10.0;
constexpr double LeastLengthMm = 3.0 * SliceMm;
constexpr double FarthestRadii = 3.0;

[[noreturn]] void Fail(const std::string& text)
{
  throw std::invalid_argument(std::string(Who) + ": " + text);
}

struct Slice
{
  glm::dvec3 sum{ 0.0 };
  double count = 0.0;
};
} // namespace

std::vector<glm::dvec3> FindDonorAxis(const BoneImage& donor, double isovalue,
  double ignoreBelowMm3, const glm::dvec3& firstTip, const glm::dvec3& lastTip, double radiusMm,
  const ProgressFunction& progress)
{
  const double length = glm::distance(firstTip, lastTip);
  if (!(length >= LeastLengthMm))
    Fail("the tips in donor.axis are less than 30 mm apart");
  const double farthest = FarthestRadii * radiusMm;
  const std::vector<std::uint8_t> keep = IslandNear(
    Who, donor, isovalue, ignoreBelowMm3, 0.5 * (firstTip + lastTip), farthest, progress);
  if (keep.empty())
    Fail("there is no bone between the tips in donor.axis: are they in this volume's world, and "
         "the isovalue right?");
  const GridGeometry& ct = GeometryOf(donor.grey);
  const glm::dvec3 way = (lastTip - firstTip) / length;
  const double slice = length / std::round(length / SliceMm);
  std::vector<Slice> slices(std::size_t(std::round(length / SliceMm)));
  for (std::size_t n = 0; n < keep.size(); ++n)
  {
    if (!keep[n])
      continue;
    const glm::dvec3 p = ct.IndexToWorld(glm::dvec3(SamplePlace(ct.dims, n)));
    const double along = glm::dot(p - firstTip, way);
    if (!(along >= 0.0 && along < length) || glm::length(glm::cross(p - firstTip, way)) > farthest)
      continue;
    Slice& s = slices[std::min(std::size_t(along / slice), slices.size() - 1)];
    s.sum += p;
    s.count += 1.0;
  }
  std::vector<glm::dvec3> axis{ firstTip };
  // The first and the last slice hold a tip, which is their end and not their middle.
  for (std::size_t n = 1; n + 1 < slices.size(); ++n)
  {
    if (slices[n].count == 0.0)
    {
      std::ostringstream text;
      text << "there is no bone " << (double(n) + 0.5) * slice << " mm along donor.axis";
      Fail(text.str());
    }
    axis.push_back(slices[n].sum / slices[n].count);
  }
  axis.push_back(lastTip);
  return axis;
}

} // namespace hasp
