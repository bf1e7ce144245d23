#include "Distance/BlockContour.h"
#include "HeldShares.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace hasp
{

namespace
{
constexpr double CellShare = 0.00125; ///< of each corner, that a point in a tetrahedron keeps
constexpr double CellSteps = 1.0;     ///< of floats, that its parts are high, if possible
constexpr double FewestSteps = 0.05;  ///< below, and a tetrahedron may be turned over
constexpr double LeastCosine = 0.3;   ///< of a triangle to its face: below, it is turned
constexpr double FarWeight = 2.0;     ///< of the square of how far a fan is off
constexpr double SeenShare = 0.03;    ///< of a cell, that a center is in front of the line's parts
constexpr int MostSteps = 12;
} // namespace

/// The fan round the place nearest to `corner`, tried from where no tetrahedron of the fan's is
/// turned over. From the middle none is.
BlockContour::Fan BlockContour::FanAt(const Loop& loop, const glm::dvec3& corner)
{
  const auto place = [&](const glm::dvec4& share)
  {
    glm::dvec3 index(0.0);
    for (int n = 0; n < 4; ++n)
      index += share[n] * loop.index[n];
    return index;
  };
  const glm::dvec4 exact = Barycentric(loop.world, corner);
  const glm::dvec4 wanted = BackToSurface(this->Solid, loop.world,
    KeepInside(exact, loop.safe, CellShare), loop.safe, FarShare * this->Solid.Cell());
  const auto steps = [&](const glm::dvec3& index)
  { return LeastHeight(this->Rounded(index), loop.shell) / this->Limits.step; };
  glm::dvec3 best = place(wanted);
  double most = steps(best);
  const bool kept = wanted != exact || most < CellSteps;
  for (double way = 0.015625; way <= 1.0; way *= 2.0)
    for (const glm::dvec4& to : { loop.safe, glm::dvec4(0.25) })
      if (most < CellSteps)
      {
        const glm::dvec3 next = place(wanted + way * (to - wanted));
        if (const double high = steps(next); high > most)
          best = next, most = high;
      }
  if (most < FewestSteps)
    throw std::runtime_error("sharp contour: 32-bit floats are too coarse for this surface; move "
                             "the grid towards 0, or make its spacing larger");
  Fan fan{ best, most, kept, 0.0, {} };
  this->Fit(loop, fan);
  return fan;
}

/// Where a fan is furthest off, and how much of it looks away from the faces that it stands for.
void BlockContour::Fit(const Loop& loop, Fan& fan) const
{
  const glm::dvec3 center = this->Rounded(fan.center);
  const std::size_t count = loop.points.size();
  for (std::size_t n = 0; n < count; ++n)
  {
    const glm::dvec3 &a = this->Points[loop.points[n]],
                     &b = this->Points[loop.points[(n + 1) % count]];
    const glm::dvec3 at = (a + b + center) / 3.0;
    const ImplicitSolid::Sample sample = this->Solid.SampleAt(at);
    fan.furthest.Offer(at, sample.value);
    fan.furthest.Offer(this->Solid, 0.5 * (a + center));
    fan.turned += this->Turned({ center, a, b }, sample.gradient);
  }
}

/// How much of a triangle looks away from the faces that it stands for, squares of cells.
double BlockContour::Turned(const std::array<glm::dvec3, 3>& t, const glm::dvec3& gradient) const
{
  const double cell = this->Solid.Cell();
  const double side = glm::determinant(this->Grid.direction) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 normal = side * glm::cross(t[1] - t[0], t[2] - t[0]);
  return std::max(LeastCosine * glm::length(normal) - glm::dot(normal, gradient), 0.0) /
         (cell * cell);
}

/// The fan round the corner or crease of the line's faces.
BlockContour::Fan BlockContour::FirstFan(const Loop& loop)
{
  return this->FanAt(
    loop, FindCorner(this->Solid, loop.world, loop.places,
            loop.creaseCount > 0 ? loop.creases / double(loop.creaseCount) : loop.start,
            this->Limits.tolerance));
}

/// Where that is turned, as where faces meet beside the tetrahedron, the best of all that faces of
/// the line offer.
void BlockContour::Improve(const Loop& loop, Fan& fan)
{
  this->OfferFaces(loop, fan);
  if (fan.turned > MostTurned)
    this->OfferSteps(loop, fan);
}

/// Takes a fan round a place instead, if it is better.
void BlockContour::Offer(const Loop& loop, const glm::dvec3& corner, Fan& best)
{
  const auto cost = [&](const Fan& fan)
  {
    const double off = fan.furthest.value / this->Solid.Cell();
    return fan.turned + FarWeight * off * off;
  };
  const Fan fan = this->FanAt(loop, corner);
  if (fan.steps >= CellSteps && cost(fan) < cost(best))
    best = fan;
}

/// The middle, and places of each face of the line, and of each crease of two.
void BlockContour::OfferFaces(const Loop& loop, Fan& best)
{
  glm::dvec3 middle(0.0);
  for (int n = 0; n < 4; ++n)
    middle += loop.safe[n] * loop.world[n];
  this->Offer(loop, middle, best);
  std::vector<std::uint32_t> faces;
  for (const FacePlace& place : loop.places)
    if (std::find(faces.begin(), faces.end(), place.face) == faces.end())
      faces.push_back(place.face);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i; j < faces.size(); ++j)
    {
      std::vector<FacePlace> places;
      glm::dvec3 start(0.0);
      for (const FacePlace& place : loop.places)
        if (place.face == faces[i] || place.face == faces[j])
          places.push_back(place), start += place.at;
      this->Offer(loop,
        FindCorner(
          this->Solid, loop.world, places, start / double(places.size()), this->Limits.tolerance),
        best);
    }
}

/// Steps on the surface, each to the front of the part of the line that is seen worst.
void BlockContour::OfferSteps(const Loop& loop, Fan& best)
{
  const double cell = this->Solid.Cell();
  const double side = glm::determinant(this->Grid.direction) < 0.0 ? -1.0 : 1.0;
  const std::size_t count = loop.points.size();
  glm::dvec3 center = this->Grid.IndexToWorld(best.center);
  for (int step = 0; step < MostSteps && best.turned > MostTurned; ++step)
  {
    glm::dvec3 move(0.0);
    double worst = 0.0;
    for (std::size_t n = 0; n < count; ++n)
    {
      const glm::dvec3 &a = this->Points[loop.points[n]],
                       &b = this->Points[loop.points[(n + 1) % count]];
      const glm::dvec3 in =
        side * glm::cross(this->Solid.SampleAt((a + b + center) / 3.0).gradient, b - a);
      const double length = glm::length(in);
      const double lack = SeenShare * cell * length - glm::dot(center - a, in);
      if (lack > worst)
        worst = lack, move = lack * in / (length * length);
    }
    if (worst == 0.0)
      return;
    center += move;
    const ImplicitSolid::Sample sample = this->Solid.SampleAt(center);
    this->Offer(loop, center -= sample.value * sample.gradient, best);
  }
}

} // namespace hasp
