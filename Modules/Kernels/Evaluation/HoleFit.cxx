#include "Evaluation/HoleFit.h"

#include "Evaluation/LeastSquares.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hasp
{

namespace
{
constexpr double StepMm = 0.25;
constexpr int Rays = 48, RaysOfASection = 36;
constexpr double Facing = 0.5, FacingStraight = 0.866; // cosines of 60 and 30 degrees

struct Cylinder
{
  double x = 0.0, y = 0.0;   ///< of its axis at z = 0
  double dx = 0.0, dy = 0.0; ///< per mm of z
  double radius = 0.0;

  glm::dvec2 Off(const glm::dvec3& p) const
  {
    return { p.x - this->x - this->dx * p.z, p.y - this->y - this->dy * p.z };
  }
};

/// Places of the wall in the hole's own axes, z from the middle of its sections.
Cylinder FitCylinder(const std::vector<glm::dvec3>& wall, bool tilts)
{
  Cylinder c;
  for (const glm::dvec3& p : wall)
    c.radius += std::hypot(p.x, p.y) / double(wall.size());
  for (int n = 0; n < 20; ++n)
  {
    NormalEquations<5> five;
    NormalEquations<3> three;
    for (const glm::dvec3& p : wall)
    {
      const glm::dvec2 off = c.Off(p);
      const double r = std::max(glm::length(off), 1e-9);
      const glm::dvec2 out = off / r;
      five.Add({ out.x, out.y, out.x * p.z, out.y * p.z, 1.0 }, r - c.radius);
      three.Add({ out.x, out.y, 1.0 }, r - c.radius);
    }
    double moved = 0.0;
    if (const auto s = five.Solve(); tilts && s)
    {
      c.x += (*s)[0], c.y += (*s)[1], c.dx += (*s)[2], c.dy += (*s)[3], c.radius += (*s)[4];
      moved = std::abs((*s)[0]) + std::abs((*s)[1]) + std::abs((*s)[2]) + std::abs((*s)[3]);
    }
    else if (const auto t = three.Solve())
    {
      c.x += (*t)[0], c.y += (*t)[1], c.radius += (*t)[2];
      moved = std::abs((*t)[0]) + std::abs((*t)[1]);
    }
    if (moved < 1e-9)
      break;
  }
  return c;
}

/// The greatest radius around a place near the middle that holds none of these, all of them around
/// the middle: the least of their distances is nearly concave there, so that steps uphill find it.
double WidestCircle(const std::vector<glm::dvec2>& around)
{
  glm::dvec2 at(0.0);
  const auto radius = [&](const glm::dvec2& middle)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec2& p : around)
    {
      const glm::dvec2 off = p - middle;
      least = std::min(least, glm::dot(off, off));
    }
    return std::sqrt(least);
  };
  double best = radius(at);
  constexpr int Ways = 16;
  const double first = best;
  for (double step = 0.25 * first; step > 1e-3 * first;)
  {
    bool wider = false;
    for (int n = 0; n < Ways; ++n)
    {
      const double angle = n * glm::two_pi<double>() / Ways;
      const glm::dvec2 next = at + step * glm::dvec2(std::cos(angle), std::sin(angle));
      // A pin does not leave the hole that it is in.
      if (const double r = glm::length(next) < first ? radius(next) : 0.0; r > best)
      {
        best = r;
        at = next;
        wider = true;
      }
    }
    if (!wider)
      step *= 0.5;
  }
  return best;
}

class Probe
{
public:
  Probe(const TriangleTree& tree, const ClaimedHole& hole)
    : Tree(tree),
      Hole(hole),
      Axis(glm::normalize(hole.axis)),
      Reach(0.75 * hole.diameterMm + 0.5)
  {
    const glm::dvec3 any = std::abs(Axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    this->X = glm::normalize(glm::cross(Axis, any));
    this->Y = glm::cross(Axis, this->X);
  }

  HoleFit Measure()
  {
    const double middle = glm::dot(this->Tree.Middle() - this->Hole.point, this->Axis);
    const int count = static_cast<int>(std::ceil(this->Tree.Reach(this->Axis) / StepMm));
    for (int n = -count; n <= count; ++n)
      this->At(middle + n * StepMm);
    if (this->Fit.sections > 0)
      this->Take();
    return this->Fit;
  }

private:
  void At(double z)
  {
    if (z < this->Hole.lowMm - this->Hole.clearMm || z > this->Hole.highMm + this->Hole.clearMm)
      return;
    const glm::dvec3 center = this->Hole.point + z * this->Axis;
    if (!this->Tree.Inside(center, this->X))
    {
      if (z >= this->Hole.lowMm && z <= this->Hole.highMm)
        this->Section(z, center);
    }
    else if (!this->Fit.blockedAt)
      this->Fit.blockedAt = center;
  }

  void Section(double z, const glm::dvec3& center)
  {
    const std::size_t before = this->Wall.size();
    std::vector<glm::dvec3> straight;
    for (int n = 0; n < Rays; ++n)
    {
      const double angle = n * glm::two_pi<double>() / Rays;
      const glm::dvec3 out = std::cos(angle) * this->X + std::sin(angle) * this->Y;
      const auto hit = this->Tree.First(center, out, 0.0, this->Reach);
      if (!hit || glm::dot(hit->normal, out) >= -Facing)
        continue;
      this->Wall.emplace_back(hit->t * std::cos(angle), hit->t * std::sin(angle), z);
      if (glm::dot(hit->normal, out) < -FacingStraight)
        straight.push_back(this->Wall.back());
    }
    const std::size_t met = this->Wall.size() - before;
    this->Fit.touchedShare = std::max(this->Fit.touchedShare, double(met) / Rays);
    if (met < RaysOfASection)
    {
      this->Wall.resize(before);
      return;
    }
    ++this->Fit.sections;
    this->Bore.insert(this->Bore.end(), straight.begin(), straight.end());
  }

  void Take()
  {
    const auto [first, last] = std::minmax_element(this->Wall.begin(), this->Wall.end(),
      [](const glm::dvec3& a, const glm::dvec3& b) { return a.z < b.z; });
    const double middle = 0.5 * (first->z + last->z), height = last->z - first->z;
    for (glm::dvec3& p : this->Wall)
      p.z -= middle;
    for (glm::dvec3& p : this->Bore)
      p.z -= middle;
    // A mouth is around the axis, too, where the part's side is oblique; it turns no drill.
    const std::vector<glm::dvec3>& guiding =
      this->Bore.size() >= std::size_t(RaysOfASection) ? this->Bore : this->Wall;
    const Cylinder c = FitCylinder(guiding, height >= 0.5 * this->Hole.diameterMm);
    std::vector<double> off;
    std::vector<glm::dvec2> around;
    for (const glm::dvec3& p : this->Wall)
      around.push_back(c.Off(p));
    for (const glm::dvec3& p : guiding)
      off.push_back(std::abs(glm::length(c.Off(p)) - c.radius));
    const auto nth = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 95 / 100);
    std::nth_element(off.begin(), nth, off.end());
    this->Fit.guideMm = double(this->Fit.sections) * StepMm;
    this->Fit.diameterMm = 2.0 * c.radius;
    this->Fit.leastMm = 2.0 * WidestCircle(around);
    this->Fit.roundnessMm = *nth;
    this->Fit.tiltDegrees = glm::degrees(std::atan(std::hypot(c.dx, c.dy)));
    this->Fit.offsetMm = std::hypot(c.x, c.y);
    this->Fit.middle = this->Hole.point + c.x * this->X + c.y * this->Y + middle * this->Axis;
  }

  const TriangleTree& Tree;
  const ClaimedHole& Hole;
  glm::dvec3 Axis, X, Y;
  double Reach;
  std::vector<glm::dvec3> Wall; // all that a pin meets
  std::vector<glm::dvec3> Bore; // of that, what faces the axis straight
  HoleFit Fit;
};
} // namespace

HoleFit FitHole(const TriangleTree& tree, const ClaimedHole& hole)
{
  return Probe(tree, hole).Measure();
}

} // namespace hasp
