#include "PlatePath.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double FarthestMm = 3.0; // of a landmark from bone
constexpr double OnSurfaceMm = 1e-3;
constexpr double StepPerWidth = 1.0 / 6.0; // chords bend off by 0.3 % of the width where the
                                           // surface's radius is the width
constexpr std::size_t MostPlaces = 5000;

/// The curve's value at `t` of knots t[1] to t[2]: Barry and Goldman's pyramid.
glm::dvec3 CatmullRom(const glm::dvec3 (&p)[4], const double (&knot)[4], double t)
{
  const auto between = [&](const glm::dvec3& a, const glm::dvec3& b, int i, int j)
  { return ((knot[j] - t) * a + (t - knot[i]) * b) / (knot[j] - knot[i]); };
  const glm::dvec3 a = between(p[0], p[1], 0, 1), b = between(p[1], p[2], 1, 2),
                   c = between(p[2], p[3], 2, 3);
  return between(between(a, b, 0, 2), between(b, c, 1, 3), 1, 2);
}

/// "landmarks[2] and landmarks[3]"
std::string Pair(std::size_t n)
{
  return "landmarks[" + std::to_string(n) + "] and landmarks[" + std::to_string(n + 1) + "]";
}

std::string Short(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/// The curve from landmark n to the next, without its end, laid on the surface.
void AddPiece(std::vector<glm::dvec3>& line, const ImplicitSolid& surface,
  const std::vector<glm::dvec3>& marks, std::size_t n, double widthMm)
{
  const std::size_t last = marks.size() - 1;
  const glm::dvec3 p[4] = { n > 0 ? marks[n - 1] : 2.0 * marks[0] - marks[1], marks[n],
    marks[n + 1], n + 1 < last ? marks[n + 2] : 2.0 * marks[last] - marks[last - 1] };
  double knot[4] = {};
  for (int k = 1; k < 4; ++k)
    knot[k] = knot[k - 1] + std::sqrt(glm::distance(p[k - 1], p[k]));
  const double length = glm::distance(p[1], p[2]);
  const int steps = int(std::ceil(2.0 * length / (StepPerWidth * widthMm)));
  if (line.size() + std::size_t(steps) > 2 * MostPlaces)
    throw std::runtime_error("plate: it would be longer than " +
                             Short(double(MostPlaces) * StepPerWidth) + " of its widths");
  for (int s = 0; s < steps; ++s)
  {
    const glm::dvec3 at = CatmullRom(p, knot, knot[1] + (knot[2] - knot[1]) * s / steps);
    const auto laid = OnSurface(surface, at);
    if (!laid || glm::distance(*laid, at) > 0.5 * widthMm)
      throw std::runtime_error("plate: the curve between " + Pair(n) + " leaves bone by " +
                               (laid ? Short(glm::distance(*laid, at)) + " mm" : "more") +
                               ", at most half the width: give more landmarks there");
    line.push_back(*laid);
  }
}

/// Places as far apart along a line, at most stepMm.
std::vector<glm::dvec3> Resampled(const std::vector<glm::dvec3>& line, double stepMm)
{
  std::vector<double> at{ 0.0 };
  for (std::size_t n = 1; n < line.size(); ++n)
    at.push_back(at.back() + glm::distance(line[n - 1], line[n]));
  const auto pieces = std::size_t(std::max(1.0, std::ceil(at.back() / stepMm)));
  std::vector<glm::dvec3> places;
  for (std::size_t n = 0, k = 1; n <= pieces; ++n)
  {
    const double way = at.back() * double(n) / double(pieces);
    while (k + 1 < at.size() && at[k] < way)
      ++k;
    const double length = at[k] - at[k - 1];
    const double share = length > 0.0 ? std::min(1.0, (way - at[k - 1]) / length) : 0.0;
    places.push_back(glm::mix(line[k - 1], line[k], share));
  }
  return places;
}

/// Upright on a piece of the middle line, along the plate's mean direction there.
glm::dvec3 NormalOf(
  const ImplicitSolid& surface, const PlateRecipe& recipe, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 along = glm::normalize(b - a), middle = 0.5 * (a + b);
  const auto upright = [&](const glm::dvec3& normal)
  { return glm::normalize(normal - glm::dot(normal, along) * along); };
  const glm::dvec3 up = upright(glm::normalize(surface.SampleAt(a).gradient) +
                                glm::normalize(surface.SampleAt(middle).gradient) +
                                glm::normalize(surface.SampleAt(b).gradient));
  return upright(MeanNormal(surface, recipe, middle, along, up));
}
} // namespace

std::size_t PlatePath::Nearest(const glm::dvec3& point) const
{
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t n = 0; n + 1 < this->places.size(); ++n)
    if (const double d = glm::distance(point, 0.5 * (this->places[n] + this->places[n + 1]));
        d < least)
    {
      least = d;
      nearest = n;
    }
  return nearest;
}

double PlatePath::Across(const glm::dvec3& point, double reachMm) const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n + 1 < this->places.size(); ++n)
  {
    const glm::dvec3 a = this->places[n], along = this->places[n + 1] - a, v = point - a;
    const double height = glm::dot(v, this->normals[n]);
    if (std::abs(height) > reachMm)
      continue;
    const double t = glm::clamp(glm::dot(v, along) / glm::dot(along, along), 0.0, 1.0);
    least = std::min(least, glm::length(v - height * this->normals[n] - t * along));
  }
  return least;
}

glm::dvec3 MeanNormal(const ImplicitSolid& surface, const PlateRecipe& recipe, const glm::dvec3& at,
  const glm::dvec3& along, const glm::dvec3& up)
{
  constexpr int half = 4;
  const double step = 0.5 * recipe.widthMm / half;
  const glm::dvec3 forth = step * glm::normalize(along), side = glm::cross(up, forth);
  const glm::dvec3 middle = at + (recipe.gapMm + recipe.thicknessMm) * up;
  glm::dvec3 sum(0.0);
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j)
    {
      const glm::dvec3 out =
        surface.SampleAt(middle + double(i) * forth + double(j) * side).gradient;
      if (i * i + j * j <= half * half && glm::dot(out, up) > 0.0)
        sum += glm::normalize(out);
    }
  return glm::dot(sum, sum) > 0.0 ? glm::normalize(sum) : up;
}

std::optional<glm::dvec3> OnSurface(const ImplicitSolid& surface, const glm::dvec3& point)
{
  glm::dvec3 x = point;
  for (int step = 0; step < 50; ++step)
  {
    const ImplicitSolid::Sample s = surface.SampleAt(x);
    if (std::abs(s.value) <= 1e-3 * OnSurfaceMm)
      return x;
    const double steep = glm::dot(s.gradient, s.gradient);
    if (!(steep > 1e-6))
      return {};
    x -= s.value / std::max(steep, 0.25) * s.gradient; // shorter where two surfaces are as near
  }
  if (std::abs(surface.At(x)) <= OnSurfaceMm)
    return x;
  return {};
}

glm::dvec3 LaidOnBone(const ImplicitSolid& bone, const std::string& name, const glm::dvec3& point)
{
  const auto laid = OnSurface(bone, point);
  if (laid && glm::distance(*laid, point) <= FarthestMm)
    return *laid;
  throw std::runtime_error("plate: " + name + " is " +
                           Short(laid ? glm::distance(*laid, point) : std::abs(bone.At(point))) +
                           " mm from bone, must be within " + Short(FarthestMm));
}

PlatePath MakePlatePath(const ImplicitSolid& surface, const PlateRecipe& recipe)
{
  std::vector<glm::dvec3> marks;
  for (std::size_t n = 0; n < recipe.landmarks.size(); ++n)
    marks.push_back(
      LaidOnBone(surface, "landmarks[" + std::to_string(n) + "]", recipe.landmarks[n]));
  std::vector<glm::dvec3> line;
  for (std::size_t n = 0; n + 1 < marks.size(); ++n)
  {
    if (glm::distance(marks[n], marks[n + 1]) < 1e-3 * recipe.widthMm)
      throw std::runtime_error("plate: " + Pair(n) + " come to lie on one place of bone");
    AddPiece(line, surface, marks, n, recipe.widthMm);
  }
  line.push_back(marks.back());
  PlatePath path;
  for (const glm::dvec3& at : Resampled(line, StepPerWidth * recipe.widthMm))
    if (const auto laid = OnSurface(surface, at);
        laid && (path.places.empty() || *laid != path.places.back()))
      path.places.push_back(*laid);
  if (path.places.size() < 2)
    throw std::runtime_error("plate: the landmarks come to lie on one place of bone");
  for (std::size_t n = 0; n + 1 < path.places.size(); ++n)
    path.normals.push_back(NormalOf(surface, recipe, path.places[n], path.places[n + 1]));
  return path;
}

} // namespace hasp
