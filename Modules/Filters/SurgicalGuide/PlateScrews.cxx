#include "PlateScrews.h"

#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double MostLeanDeg = 45.0;
constexpr double SeatSlackMm = 0.1; // of a head's seat: a scan's surface is not smoother

std::string ScrewName(std::size_t n)
{
  return "screws[" + std::to_string(n) + "]";
}

[[noreturn]] void Fail(const std::string& text, double value, const std::string& rest)
{
  std::ostringstream message;
  message.precision(3);
  message << "plate: " << text << " " << value << rest;
  throw std::runtime_error(message.str());
}

std::string AtLeast(double value)
{
  std::ostringstream text;
  text << ", must be " << value;
  return text.str();
}

/// Where a line that goes out of bone is so far from it.
glm::dvec3 AtHeight(const ImplicitSolid& surface, const glm::dvec3& from, const glm::dvec3& axis,
  double height, const std::string& name)
{
  double t = height;
  for (int step = 0; step < 200; ++step)
  {
    const double off = height - surface.At(from + t * axis);
    if (std::abs(off) < 1e-6)
      return from + t * axis;
    t += off / surface.Steepness();
  }
  throw std::runtime_error("plate: the axis of " + name + " does not come through the plate");
}

double SegmentDistance(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
  const auto toLine = [](const glm::dvec3& p, const glm::dvec3& from, const glm::dvec3& to)
  {
    const glm::dvec3 v = to - from;
    const double t = glm::clamp(glm::dot(p - from, v) / glm::dot(v, v), 0.0, 1.0);
    return glm::distance(p, from + t * v);
  };
  double least = std::min({ toLine(a, c, d), toLine(b, c, d), toLine(c, a, b), toLine(d, a, b) });
  const glm::dvec3 u = b - a, v = d - c, n = glm::cross(u, v), w = c - a;
  const double squared = glm::dot(n, n);
  if (squared > 1e-12)
  {
    const double s = glm::dot(glm::cross(w, v), n) / squared;
    const double t = glm::dot(glm::cross(w, u), n) / squared;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
      least = std::min(least, std::abs(glm::dot(w, n)) / std::sqrt(squared));
  }
  return least;
}

glm::dvec3 ShaftEnd(const PlateScrew& screw, const PlacedScrew& placed)
{
  return placed.inner - screw.lengthMm * placed.axis;
}

void CheckHold(const ImplicitSolid& bone, const PlateScrew& screw, const PlacedScrew& placed,
  const std::string& name)
{
  constexpr double stepMm = 0.1;
  const int steps = int(std::ceil(screw.lengthMm / stepMm));
  for (int n = 0; n <= steps; ++n)
    if (bone.At(glm::mix(placed.inner, ShaftEnd(screw, placed), double(n) / steps)) < 0.0)
      return;
  throw std::runtime_error("plate: " + name + " meets no bone");
}

/// See the header; by places around the axis.
void CheckSeat(const ImplicitSolid& surface, const PlateRecipe& recipe, const PlateScrew& screw,
  const PlacedScrew& placed, const std::string& name)
{
  constexpr int places = 24;
  const double depth = ScrewHeadDepth(screw), floor = recipe.thicknessMm - depth;
  const glm::dvec3 cone = placed.outer - depth * placed.axis; // where it ends in the bore
  const glm::dvec3 other =
    std::abs(placed.axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(placed.axis, other));
  const glm::dvec3 y = glm::cross(placed.axis, x);
  double lowest = 1e30, shortest = 1e30;
  for (int n = 0; n < places; ++n)
  {
    const double angle = glm::radians(360.0 * n / places);
    const glm::dvec3 aside = std::cos(angle) * x + std::sin(angle) * y;
    const auto height = [&](const glm::dvec3& at) { return surface.At(at) - recipe.gapMm; };
    lowest =
      std::min(lowest, recipe.thicknessMm - height(cone + 0.5 * screw.headDiameterMm * aside));
    shortest = std::min(shortest, height(cone + 0.5 * screw.diameterMm * aside));
  }
  if (lowest < -SeatSlackMm)
    Fail(name + "'s head stands out of the plate, which falls away beside it by", depth - lowest,
      " mm: move it, or let it lean less");
  if (shortest < 0.5 * floor - SeatSlackMm)
    Fail(name + "'s head leaves a bore of", shortest,
      " mm below it" + AtLeast(0.5 * floor) + ": move it, or let it lean less");
}

PlacedScrew Place(
  const ImplicitSolid& surface, const PlatePath& path, const PlateRecipe& recipe, std::size_t n)
{
  const PlateScrew& screw = recipe.screws[n];
  const glm::dvec3 at = LaidOnBone(surface, ScrewName(n), screw.point);
  const std::size_t piece = path.Nearest(at);
  const glm::dvec3 normal = MeanNormal(
    surface, recipe, at, path.places[piece + 1] - path.places[piece], path.normals[piece]);
  const glm::dvec3 axis = screw.axis ? glm::normalize(*screw.axis) : normal;
  const double lean = glm::degrees(std::acos(glm::clamp(glm::dot(axis, normal), -1.0, 1.0)));
  if (lean > MostLeanDeg)
    Fail(ScrewName(n) + ".axis leans on the plate by", lean, " degrees, at most 45");
  PlacedScrew placed{ axis, {}, {} };
  placed.outer = AtHeight(surface, at, axis, recipe.gapMm + recipe.thicknessMm, ScrewName(n));
  placed.inner = AtHeight(surface, at, axis, recipe.gapMm, ScrewName(n));
  const double stretch = 1.0 / std::cos(glm::radians(lean));
  const double reach = recipe.gapMm + recipe.thicknessMm + recipe.widthMm;
  const double edge =
    0.5 * recipe.widthMm -
    std::max(path.Across(placed.outer, reach) + 0.5 * stretch * screw.headDiameterMm,
      path.Across(placed.inner, reach) + 0.5 * stretch * screw.diameterMm);
  if (edge < recipe.edgeDistanceMm - 1e-3)
    Fail(ScrewName(n) + " is", edge, " mm from the plate's edge" + AtLeast(recipe.edgeDistanceMm));
  CheckSeat(surface, recipe, screw, placed, ScrewName(n));
  return placed;
}

void CheckClash(
  const PlateRecipe& recipe, const std::vector<PlacedScrew>& placed, std::size_t a, std::size_t b)
{
  const PlateScrew &sa = recipe.screws[a], &sb = recipe.screws[b];
  const PlacedScrew &pa = placed[a], &pb = placed[b];
  const std::string names = ScrewName(a) + " and " + ScrewName(b) + " clash:";
  const double apart =
    std::min(glm::distance(pa.outer, pb.outer) - 0.5 * (sa.headDiameterMm + sb.headDiameterMm),
      glm::distance(pa.inner, pb.inner) - 0.5 * (sa.diameterMm + sb.diameterMm));
  if (apart < recipe.holeDistanceMm - 1e-3)
    Fail(names + " their holes are", apart, " mm apart" + AtLeast(recipe.holeDistanceMm));
  const double shafts = SegmentDistance(pa.inner, ShaftEnd(sa, pa), pb.inner, ShaftEnd(sb, pb)) -
                        0.5 * (sa.diameterMm + sb.diameterMm);
  if (shafts < 0.0)
    Fail(names + " their shafts overlap by", -shafts, " mm below the plate");
}
} // namespace

std::vector<PlacedScrew> PlaceScrews(const ImplicitSolid& bone, const ImplicitSolid& surface,
  const PlatePath& path, const PlateRecipe& recipe)
{
  std::vector<PlacedScrew> placed;
  for (std::size_t n = 0; n < recipe.screws.size(); ++n)
  {
    placed.push_back(Place(surface, path, recipe, n));
    CheckHold(bone, recipe.screws[n], placed[n], ScrewName(n));
    for (std::size_t m = 0; m < n; ++m)
      CheckClash(recipe, placed, m, n);
  }
  return placed;
}

SolidPointer MakeScrewHole(const PlateScrew& screw, const PlacedScrew& placed)
{
  // Beyond both faces, also where they lean or bend away from the axis.
  const glm::dvec3 top = placed.outer + 1.5 * screw.headDiameterMm * placed.axis;
  const glm::dvec3 bottom = placed.inner - 1.5 * screw.diameterMm * placed.axis;
  const SolidPointer bore = MakeCylinder(bottom, top, 0.5 * screw.diameterMm);
  if (screw.headDiameterMm == screw.diameterMm)
    return bore;
  const double cone = 0.5 * screw.headDiameterMm / std::tan(glm::radians(0.5 * screw.headAngleDeg));
  const glm::dvec3 tip = placed.outer - (screw.headDepthMm + cone) * placed.axis;
  return MakeUnion({ bore, MakeIntersection({ MakeCylinder(tip, top, 0.5 * screw.headDiameterMm),
                             MakeCone(tip, placed.axis, screw.headAngleDeg) }) });
}

} // namespace hasp
