#include "Distance/SolidPrisms.h"

#include "SolidChecks.h"

#include <vector>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

constexpr double Infinite = std::numeric_limits<double>::infinity();

class Prism : public ImplicitSolid
{
public:
  Prism(std::span<const glm::dvec2> corners, const glm::dmat3& axes, double round)
    : Corners(corners.begin(), corners.end()),
      Axes(axes),
      Round(round)
  {
    glm::dvec2 low = this->Corners.front(), high = low;
    for (const glm::dvec2& c : this->Corners)
    {
      low = glm::min(low, c);
      high = glm::max(high, c);
    }
    const glm::dvec2 middle = 0.5 * (low + high), half = 0.5 * (high - low) + round;
    for (int a = 0; a < 3; ++a)
      if (axes[2][a] == 0.0)
      {
        const double at = axes[0][a] * middle.x + axes[1][a] * middle.y;
        const double reach = std::abs(axes[0][a]) * half.x + std::abs(axes[1][a]) * half.y;
        this->Hull.low[a] = at - reach;
        this->Hull.high[a] = at + reach;
      }
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const Nearest nearest = this->NearestTo(this->Local(x));
    return (nearest.inside ? -1.0 : 1.0) * std::sqrt(nearest.squared) - this->Round;
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const glm::dvec2 p = this->Local(x);
    const Nearest nearest = this->NearestTo(p);
    return this->OfSide(nearest.side, p, nearest.inside);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const glm::dvec2 p = this->Local(x);
    return this->OfSide(face, p, this->NearestTo(p).inside);
  }
  std::uint32_t Faces() const noexcept override { return std::uint32_t(this->Corners.size()); }
  Box Bounds() const noexcept override { return this->Hull; }

private:
  struct Nearest
  {
    double squared = Infinite; ///< distance to the nearest side
    std::uint32_t side = 0;    ///< the first of those that tie
    bool inside = false;
  };
  glm::dvec2 Local(const glm::dvec3& x) const noexcept
  {
    return { glm::dot(this->Axes[0], x), glm::dot(this->Axes[1], x) };
  }
  /// From the nearest place of a side to p.
  glm::dvec2 From(std::uint32_t side, const glm::dvec2& p) const noexcept
  {
    const glm::dvec2 a = this->Corners[side];
    const glm::dvec2 e = this->Corners[(side + 1) % this->Corners.size()] - a, v = p - a;
    const double length = glm::dot(e, e);
    return v - (length > 0.0 ? glm::clamp(glm::dot(v, e) / length, 0.0, 1.0) : 0.0) * e;
  }
  Nearest NearestTo(const glm::dvec2& p) const noexcept
  {
    Nearest nearest;
    double least = Infinite; // what another must be below, mm
    for (std::uint32_t n = 0; n < this->Corners.size(); ++n)
    {
      const glm::dvec2 d = this->From(n, p);
      const double squared = glm::dot(d, d);
      nearest.squared = std::min(nearest.squared, squared);
      if (std::sqrt(squared) < least - SolidTieMm)
      {
        least = std::sqrt(squared);
        nearest.side = n;
      }
      const glm::dvec2 a = this->Corners[n], b = this->Corners[(n + 1) % this->Corners.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < (p.y - a.y) * (b.x - a.x) / (b.y - a.y) + a.x)
        nearest.inside = !nearest.inside;
    }
    return nearest;
  }
  Sample OfSide(std::uint32_t side, const glm::dvec2& p, bool inside) const noexcept
  {
    const glm::dvec2 d = this->From(side, p);
    const double away = glm::length(d), sign = inside ? -1.0 : 1.0;
    const glm::dvec2 out = away > 0.0 ? sign / away * d : glm::dvec2(0.0);
    return { sign * away - this->Round, this->Axes[0] * out.x + this->Axes[1] * out.y, side };
  }

  std::vector<glm::dvec2> Corners;
  glm::dmat3 Axes;
  double Round;
  Box Hull;
};

class Extrusion : public ImplicitSolid
{
public:
  Extrusion(SolidPointer part, const glm::dvec3& point, const glm::dvec3& direction)
    : Part(std::move(part)),
      Point(point),
      Along(direction)
  {
  }
  double At(const glm::dvec3& x) const noexcept override { return this->Part->At(this->Foot(x)); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return this->InPlane(this->Part->SampleAt(this->Foot(x)));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return this->InPlane(this->Part->FaceAt(face, this->Foot(x)));
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override
  {
    Box box = this->Part->Bounds();
    for (int a = 0; a < 3; ++a)
      if (this->Along[a] != 0.0)
      {
        box.low[a] = -Infinite;
        box.high[a] = Infinite;
      }
    return box;
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  glm::dvec3 Foot(const glm::dvec3& x) const noexcept
  {
    return x - glm::dot(x - this->Point, this->Along) * this->Along;
  }
  Sample InPlane(Sample s) const noexcept
  {
    s.gradient -= glm::dot(s.gradient, this->Along) * this->Along;
    return s;
  }

  SolidPointer Part;
  glm::dvec3 Point, Along;
};
} // namespace

SolidPointer MakePrism(std::span<const glm::dvec2> corners, const glm::dmat3& axes, double roundMm)
{
  if (corners.size() < 3 || corners.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument(
      "prism: " + std::to_string(corners.size()) + " corners; give three at least");
  for (const glm::dvec2& c : corners)
    RequireFinite("prism", "corner", glm::dvec3(c, 0.0));
  RequirePositive("prism", "round", roundMm);
  return std::make_shared<Prism>(corners, RequireOrthonormal("prism", axes), roundMm);
}

SolidPointer MakeExtrusion(SolidPointer part, const glm::dvec3& point, const glm::dvec3& direction)
{
  RequirePart("extrusion", part);
  RequireFinite("extrusion", "point", point);
  return std::make_shared<Extrusion>(
    std::move(part), point, RequireDirection("extrusion", "direction", direction));
}

} // namespace hasp
