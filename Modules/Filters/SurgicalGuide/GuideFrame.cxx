#include "GuideFrame.h"

#include "Distance/Csg.h"
#include "Distance/ImplicitShapes.h"
#include "Distance/SolidPrisms.h"
#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"
#include "WorkingGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{
/// How far along the third axis marked samples go inside the polygon or within `reach` of it; at
/// least `low`.
double Highest(const GridGeometry& ct, std::span<const std::uint8_t> marked, const glm::dmat3& axes,
  std::span<const glm::dvec2> polygon, double reach, double low)
{
  const glm::dmat3 step = glm::transpose(axes) * ct.IndexToWorldMatrix();
  const glm::dvec3 first = ct.origin * axes;
  std::size_t n = 0;
  for (int k = 0; k < ct.dims.z; ++k)
    for (int j = 0; j < ct.dims.y; ++j)
      for (int i = 0; i < ct.dims.x; ++i, ++n)
        if (marked[n])
          if (const glm::dvec3 p = first + step * glm::dvec3(i, j, k);
              p.z > low && PolygonDistance(glm::dvec2(p), polygon) <= reach)
            low = p.z;
  return low;
}

/// Low and high along the axes.
struct Span
{
  glm::dvec3 low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 high{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& local, const glm::dvec3& around)
  {
    this->low = glm::min(this->low, local - around);
    this->high = glm::max(this->high, local + around);
  }
};

/// How far below its middle a band may reach: as far as to its sides, and the shell there.
double Depth(const GuideRecipe& r, double radius)
{
  return std::hypot(radius, radius + r.gapMm + r.thicknessMm);
}

/// What makes a band of landmarks or of a stroke: (line, closed, radius).
using Sweep = std::function<SolidPointer(std::span<const glm::dvec3>, bool, double)>;

/// All within the radius as seen along the withdrawal direction, and not too far below or above.
Sweep Upright(const GuideRecipe& recipe)
{
  return [&recipe](std::span<const glm::dvec3> line, bool closed, double radius) -> SolidPointer
  {
    const glm::dvec3 up = recipe.withdrawal, foot = line.front();
    std::vector<glm::dvec3> flat;
    for (const glm::dvec3& p : line)
      flat.push_back(p - glm::dot(p - foot, up) * up);
    return MakeIntersection({ MakeExtrusion(MakeTube(flat, closed, radius), foot, up),
      MakeTube(line, closed, Depth(recipe, radius)) });
  };
}

/// Strokes over what the outline gives, one after the other; null if nothing is left of both.
SolidPointer WithStrokes(SolidPointer region, const GuideRecipe& recipe, const Sweep& sweep)
{
  for (const GuideStroke& stroke : recipe.strokes)
  {
    SolidPointer brush = sweep(stroke.points, false, stroke.radiusMm);
    if (!stroke.erased)
      region = region ? MakeUnion({ region, brush }) : brush;
    else if (region)
      region = MakeDifference(region, brush);
  }
  return region;
}

SolidPointer Band(const GuideRecipe& recipe, const Sweep& sweep)
{
  SolidPointer band;
  if (!recipe.landmarks.empty())
    band = sweep(recipe.landmarks, recipe.outline != GuideOutline::Open, 0.5 * recipe.widthMm);
  return WithStrokes(std::move(band), recipe, sweep);
}

/// Whether a part comes near what spans the guide: a box along `axes`. What is apart along an axis
/// of the part need not be looked for by samples later.
void CheckNear(const GuidePart& part, const char* verb, const Span& span, const glm::dmat3& axes)
{
  const glm::dvec3 middle = axes * (0.5 * (span.low + span.high)),
                   reach = 0.5 * (span.high - span.low);
  double apart = 0.0;
  for (int a = 0; a < 3; ++a)
    apart = std::max(apart, std::abs(glm::dot(middle - part.center, part.axes[a])) - part.half[a] -
                              glm::dot(glm::abs(part.axes[a] * axes), reach));
  if (apart > 0.0)
    throw std::runtime_error("guide: " + part.name + " does not " + verb +
                             " the guide: it is over " + std::to_string(int(apart)) +
                             " mm off the landmarks' band");
}
} // namespace

SolidPointer MakeGuideBand(const GuideRecipe& recipe)
{
  return Band(recipe, MakeTube);
}

GuideFrame MakeGuideFrame(const GuideRecipe& recipe, const GridGeometry& ct,
  std::span<const std::uint8_t> keep, const GuideParts& parts)
{
  const glm::dmat3 axes = AxesAlong(recipe.withdrawal);
  const double reach = 0.5 * recipe.widthMm;
  Span span;
  std::vector<glm::dvec2> polygon; // landmarks across the withdrawal direction
  for (const glm::dvec3& p : recipe.landmarks)
  {
    const glm::dvec3 local = p * axes; // transpose(axes) * p
    polygon.emplace_back(local.x, local.y);
    span.Add(local, { reach, reach, Depth(recipe, reach) });
  }
  const Sweep sweep = Upright(recipe);
  SolidPointer region;
  if (recipe.outline == GuideOutline::Filled)
  {
    region = MakeIntersection({ MakePrism(polygon, axes, reach),
      MakePlane(axes * glm::dvec3(0.0, 0.0, span.low.z), -recipe.withdrawal) });
    // Bone may bulge between the landmarks; its surface is less than a cell beyond its samples.
    const double top = span.high.z - Depth(recipe, reach);
    span.high.z = Highest(ct, keep, axes, polygon, reach, top) + glm::length(ct.spacing) + reach;
    region = WithStrokes(std::move(region), recipe, sweep);
  }
  else
    region = Band(recipe, sweep);
  for (const GuideStroke& stroke : recipe.strokes)
    for (const glm::dvec3& p : stroke.points)
      if (!stroke.erased)
        span.Add(p * axes, { stroke.radiusMm, stroke.radiusMm, Depth(recipe, stroke.radiusMm) });
  // Everything the guide's distance to bone can depend on, letters on it, and a rim outside.
  double margin = recipe.gapMm + recipe.thicknessMm + 3.0 * recipe.spacingMm;
  for (const GuideLabel& label : recipe.labels)
    margin =
      std::max(margin, recipe.gapMm + recipe.thicknessMm + label.depthMm + 3.0 * recipe.spacingMm);
  span.low -= margin;
  span.high += margin;
  for (const GuidePart& part : parts.taken)
    CheckNear(part, "meet", span, axes);
  for (const GuidePart& part : parts.added)
    CheckNear(part, "stand on", span, axes);
  for (const GuidePart& part : parts.added)
    for (int c = 0; c < 8; ++c)
    {
      const glm::dvec3 side(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
      span.Add(
        (part.center + part.axes * (side * part.half)) * axes, glm::dvec3(3.0 * recipe.spacingMm));
    }
  return { GridIn("guide", { span.low, span.high }, axes, recipe.spacingMm), std::move(region) };
}

} // namespace hasp
