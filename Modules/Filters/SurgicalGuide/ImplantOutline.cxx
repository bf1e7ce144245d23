#include "ImplantOutline.h"

#include "Distance/ImplicitShapes.h"
#include "Grid/ParallelFor.h"
#include "PlaceChecks.h"
#include "WorkingGrid.h"

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
constexpr double FarthestMm = 3.0; // of the outline from bone, as a guide's landmarks
constexpr double RingMm = 8.0;     // of bone around the outline
constexpr double DeepMm = 10.0;    // that the outer table may lie below the outline
constexpr double MostTiltDeg = 60.0;

std::string Named(std::size_t n)
{
  return "outline[" + std::to_string(n) + "]";
}

/// Twice its area, upright on it, the way its points go around (Newell).
glm::dvec3 AreaVector(const std::vector<glm::dvec3>& outline)
{
  glm::dvec3 area(0.0);
  for (std::size_t n = 1; n + 1 < outline.size(); ++n)
    area += glm::cross(outline[n] - outline[0], outline[n + 1] - outline[0]);
  return area;
}

double Turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const glm::dvec2 u = b - a, v = c - a;
  return u.x * v.y - u.y * v.x;
}

/// Whether two segments meet, but for one running on in the other's end.
bool Meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
  return Turn(a, b, c) * Turn(a, b, d) <= 0.0 && Turn(c, d, a) * Turn(c, d, b) <= 0.0 &&
         std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <=
           std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
         std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <=
           std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

void CheckOnBone(const std::vector<glm::dvec3>& outline, const ImplicitSolid& bone)
{
  for (std::size_t n = 0; n < outline.size(); ++n)
  {
    const double off = bone.At(outline[n]);
    if (std::abs(off) <= FarthestMm)
      continue;
    std::ostringstream text;
    text.precision(4);
    text << "implant: " << Named(n) << " (" << outline[n].x << ", " << outline[n].y << ", "
         << outline[n].z << ") is " << off << " mm from bone, must be within " << FarthestMm
         << " mm";
    throw std::runtime_error(text.str());
  }
}

void CheckSimple(const std::vector<glm::dvec2>& outline)
{
  const std::size_t count = outline.size();
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t m = n + 2; m < count; ++m)
      if ((m + 1) % count != n &&
          Meet(outline[n], outline[n + 1], outline[m], outline[(m + 1) % count]))
        throw std::runtime_error("implant: the outline meets itself, seen along the axis: after " +
                                 Named(n) + " and after " + Named(m) + "; go around the hole once");
}

void CheckClosed(
  const std::vector<glm::dvec3>& outline, const GridGeometry& grid, const ImplicitSolid& bone)
{
  const double step = grid.spacing.z, height = step * grid.Cells().z;
  for (std::size_t n = 0; n < outline.size(); ++n)
  {
    const std::size_t next = (n + 1) % outline.size();
    const glm::dvec3 a = (outline[n] - grid.origin) * grid.direction,
                     b = (outline[next] - grid.origin) * grid.direction;
    const int steps = int(std::ceil(glm::distance(a, b) / step));
    for (int s = 0; s < steps; ++s)
    {
      glm::dvec3 local = glm::mix(a, b, double(s) / steps);
      const auto at = [&] { return grid.origin + grid.direction * local; };
      const double from = local.z;
      double least = bone.At(at());
      for (local.z = 0.5 * step; local.z < height && least > 0.0; local.z += 0.5 * step)
        least = std::min(least, bone.At(at()));
      if (least <= 0.0)
        continue;
      local.z = from;
      std::ostringstream text;
      text.precision(4);
      text << "implant: the hole is open: there is no bone below the outline between " << Named(n)
           << " and " << Named(next) << ", at (" << at().x << ", " << at().y << ", " << at().z
           << "); go around all of it";
      throw std::runtime_error(text.str());
    }
  }
}
} // namespace

glm::dvec3 ImplantAxis(const ImplantRecipe& recipe, const glm::dvec3& head)
{
  const std::vector<glm::dvec3>& outline = recipe.outline;
  glm::dvec3 upright = AreaVector(outline), middle(0.0);
  double around = 0.0;
  for (std::size_t n = 0; n < outline.size(); ++n)
  {
    middle += outline[n] / double(outline.size());
    around += glm::distance(outline[n], outline[(n + 1) % outline.size()]);
  }
  if (!(glm::length(upright) > 0.01 * around * around)) // a circle: 0.16
    throw std::runtime_error("implant: the outline encloses next to nothing; go around the hole");
  upright = glm::normalize(glm::dot(upright, middle - head) < 0.0 ? -upright : upright);
  if (!recipe.axis)
    return upright;
  const glm::dvec3 axis = glm::normalize(*recipe.axis);
  const double tilt = glm::degrees(std::acos(glm::clamp(glm::dot(axis, upright), -1.0, 1.0)));
  if (tilt <= MostTiltDeg)
    return axis;
  std::ostringstream text;
  text.precision(4);
  text << "implant: the axis is " << tilt << " degrees from upright on the outline, out of the head"
       << ", must be within " << MostTiltDeg;
  throw std::runtime_error(text.str());
}

GridGeometry ImplantGrid(const ImplantRecipe& recipe, const glm::dvec3& axis)
{
  const glm::dmat3 axes = AxesAlong(axis);
  glm::dvec3 low(1e30), high(-1e30);
  for (const glm::dvec3& p : recipe.outline)
  {
    low = glm::min(low, p * axes);
    high = glm::max(high, p * axes);
  }
  low.z -= DeepMm + 2.0 * recipe.thicknessMm + recipe.clearanceMm;
  high.z += 0.5 * std::max(high.x - low.x, high.y - low.y);
  low -= RingMm;
  high += RingMm;
  return GridIn("implant", { low, high }, axes, recipe.spacingMm);
}

void CheckOutlineInVolume(const ImplantRecipe& recipe, const GridGeometry& volume)
{
  std::vector<NamedPlace> places;
  for (std::size_t n = 0; n < recipe.outline.size(); ++n)
    places.push_back({ Named(n), recipe.outline[n] });
  CheckInVolume("implant", volume, places, FarthestMm);
}

void CheckOutline(const ImplantRecipe& recipe, const GridGeometry& grid, const ImplicitSolid& bone)
{
  CheckOnBone(recipe.outline, bone);
  std::vector<glm::dvec2> seen;
  for (const glm::dvec3& p : recipe.outline)
    seen.push_back(glm::dvec2((p - grid.origin) * grid.direction));
  CheckSimple(seen);
  CheckClosed(recipe.outline, grid, bone);
}

ColumnLayer OutlineDepth(const ImplantRecipe& recipe, const GridGeometry& grid)
{
  ColumnLayer layer{ grid, std::vector<float>(std::size_t(grid.dims.x) * grid.dims.y) };
  std::vector<glm::dvec2> seen;
  for (const glm::dvec3& p : recipe.outline)
    seen.push_back(layer.Place(p));
  ParallelFor(0, std::int64_t(layer.values.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        layer.values[n] = float(-PolygonDistance(layer.Place(std::size_t(n)), seen));
    });
  return layer;
}

} // namespace hasp
