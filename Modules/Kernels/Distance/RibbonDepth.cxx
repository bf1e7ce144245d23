#include "RibbonDepth.h"

#include "SolidChecks.h"

namespace hasp
{

namespace
{
constexpr double Nowhere = std::numeric_limits<double>::infinity();

/// Where the solid begins and ends in a column, mm below the tangent plane.
struct Column
{
  double upper = -Nowhere;
  double end = Nowhere;
};

/// Looks at the columns under a segment, and keeps the interval of depths.
class Columns
{
public:
  Columns(const ImplicitSolid& surface, const RibbonBand& band, const glm::dvec3& normal)
    : Surface(surface),
      Normal(normal),
      Band(band),
      Bend(RibbonBendPerWidth * band.width),
      LeastStep(1e-3 * band.width),
      Highest(-Bend)
  {
  }

  /// From a place on the segment outwards. Each column begins where the one before it met the
  /// surface, so that it stays on one bone. `isBand`: no other segment's band covers it.
  void LookAlong(const glm::dvec3& from, const glm::dvec3& direction, bool isBand)
  {
    constexpr int Count = 4;
    double depth = 0.0;
    for (int n = 0; n <= Count; ++n)
    {
      const Column column =
        this->At(from + (0.5 * n / Count) * this->Band.width * direction, depth);
      if (column.upper > -Nowhere)
        depth = column.upper;
      if (isBand)
        this->Highest = std::max(this->Highest, column.upper);
      this->Lowest = std::min(this->Lowest, column.end);
    }
  }

  double Least() const { return this->Highest - this->Band.below; }
  double Most() const { return this->Lowest + this->Band.below; }

private:
  Column At(const glm::dvec3& foot, double depth) const
  {
    if (this->Surface.At(foot - depth * this->Normal) < 0.0)
      return { this->Walk(foot, depth, -this->Bend, false), this->End(foot, depth) };
    const double below = this->Walk(foot, depth, this->Bend, true);
    // Where thin bone rises by more than its thickness, the column begins beneath it.
    const double above = this->Walk(foot, depth, -this->Bend, true);
    if (depth - above < below - depth)
      return { this->Walk(foot, above, -this->Bend, false), above };
    return below < Nowhere ? Column{ below, this->End(foot, below) } : Column{};
  }

  /// Twice as far as the band can reach, so that there is room for the middle.
  double End(const glm::dvec3& foot, double depth) const
  {
    return this->Walk(foot, depth, 2.0 * this->Band.reach, false);
  }

  /// The first depth on the way that is inside, or outside; infinite if none is. Sphere tracing.
  double Walk(const glm::dvec3& foot, double depth, double to, bool inside) const
  {
    const double way = to > depth ? 1.0 : -1.0;
    while (way * (to - depth) >= 0.0)
    {
      const double value = this->Surface.At(foot - depth * this->Normal);
      if ((value < 0.0) == inside)
        return depth;
      depth += way * std::max(std::abs(value) / this->Surface.Steepness(), this->LeastStep);
    }
    return way * Nowhere;
  }

  const ImplicitSolid& Surface;
  glm::dvec3 Normal;
  RibbonBand Band;
  double Bend, LeastStep;
  double Highest, Lowest = Nowhere;
};
} // namespace

RibbonSegment::RibbonSegment(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal, const char* where)
  : a(a),
    b(b)
{
  const glm::dvec3 up = RequireDirection(where, "the surface's mean normal", normal);
  const glm::dvec3 other = std::abs(up.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const double length = glm::distance(a, b);
  // One place twice has any direction.
  this->along = length > 0.0 ? (b - a) / length : glm::normalize(glm::cross(up, other));
  this->normal = RequireDirection(where, "the surface's mean normal, upright on the segment,",
    up - glm::dot(up, this->along) * this->along);
  this->side = glm::cross(this->normal, this->along);
}

double RibbonDepth(const ImplicitSolid& surface, const RibbonSegment& segment,
  const RibbonBand& band, bool isFirst, bool isLast, const char* where)
{
  Columns columns(surface, band, segment.normal);
  const double halves = std::ceil(2.0 * glm::distance(segment.a, segment.b) / band.width);
  const int pieces = int(std::clamp(halves, 2.0, 100.0));
  for (int n = 0; n <= pieces; ++n)
  {
    const glm::dvec3 from = glm::mix(segment.a, segment.b, double(n) / pieces);
    columns.LookAlong(from, segment.side, true);
    columns.LookAlong(from, -segment.side, true);
  }
  columns.LookAlong(segment.a, -segment.along, isFirst);
  columns.LookAlong(segment.b, segment.along, isLast);
  if (!(columns.Least() <= columns.Most()))
    throw std::invalid_argument(
      std::string(where) + ": the band reaches " + SolidNumber(columns.Least()) +
      " mm below the path, where the surface bends away under it, but bone ends at " +
      SolidNumber(columns.Most()) +
      " mm, so that its other side would get a band, too: give a narrower band, more places, or a "
      "lower side less deep");
  return std::min(band.reach, 0.5 * (columns.Least() + columns.Most()));
}

} // namespace hasp
