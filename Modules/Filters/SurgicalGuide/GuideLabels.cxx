#include "GuideLabels.h"

#include "Distance/Csg.h"
#include "Distance/SolidPrisms.h"
#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double LeastShare = 0.98;

/// The plane a label is written in, and the box that its letters stay in.
struct Page
{
  glm::dvec3 middle;
  glm::dmat3 axes; ///< right, up, outwards
  double halfWidth, halfHeight;
  double low, high; ///< along the third axis, of the wall below the letters

  glm::dvec3 At(double x, double y, double z) const
  {
    return this->middle + this->axes * glm::dvec3(x, y, z);
  }
};

[[noreturn]] void Refuse(std::size_t n, const std::string& why)
{
  throw std::runtime_error("guide: labels[" + std::to_string(n) + "] " + why);
}

/// The wall's normal: the mean of the bone's around the label's middle, over the letters' height.
glm::dvec3 WallNormal(const GuideLabel& label, const ImplicitSolid& bone)
{
  glm::dvec3 sum(0.0);
  for (int c = 0; c < 27; ++c)
    sum += bone
             .SampleAt(
               label.point + 0.5 * label.heightMm * glm::dvec3(c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1))
             .gradient;
  return sum / 27.0;
}

Page MakePage(const GuideRecipe& r, std::size_t n, const ImplicitSolid& bone)
{
  const GuideLabel& label = r.labels[n];
  const glm::dvec3 normal = WallNormal(label, bone);
  if (!(glm::length(normal) >= 0.3))
    Refuse(n, "has no wall below its point; move it onto the bone");
  const glm::dvec3 out = glm::normalize(normal);
  if (const double towards = std::abs(glm::dot(out, glm::normalize(label.right))); towards > 0.9)
  {
    std::ostringstream text;
    text << "is written towards the wall (cosine " << towards
         << ", at most 0.9); turn its right along the wall";
    Refuse(n, text.str());
  }
  const glm::dvec3 up = glm::normalize(glm::cross(out, label.right));
  Page page{ label.point, { glm::cross(up, out), up, out },
    0.5 * TextWidth(label.text.size(), label.heightMm), 0.5 * label.heightMm, 0.0, 0.0 };
  // The wall may bend away by half of what the letters reach to either side.
  const double bend = 0.5 * std::max(page.halfWidth, label.heightMm);
  page.low = -bend;
  page.high = bend + r.gapMm + r.thicknessMm + label.depthMm;
  return page;
}

/// Share of the strokes' places that have the bare shell below them.
double ShareOnShell(
  const Page& page, const ImplicitSolid& letters, const ImplicitSolid& bare, double spacing)
{
  std::size_t all = 0, on = 0;
  for (double y = -page.halfHeight; y <= page.halfHeight; y += spacing)
    for (double x = -page.halfWidth; x <= page.halfWidth; x += spacing)
      if (letters.At(page.At(x, y, 0.0)) < 0.0)
      {
        ++all;
        for (double z = page.low; z <= page.high; z += spacing)
          if (bare.At(page.At(x, y, z)) < 0.0)
          {
            ++on;
            break;
          }
      }
  return all > 0 ? double(on) / double(all) : 0.0;
}
} // namespace

SolidPointer MakeGuideLabel(
  const GuideRecipe& r, std::size_t n, const SolidPointer& bone, const ImplicitSolid& bare)
{
  const GuideLabel& label = r.labels[n];
  const Page page = MakePage(r, n, *bone);
  const double stroke = label.heightMm / 6.0;
  const SolidPointer letters =
    MakeExtrusion(MakeText(label.text, page.At(-page.halfWidth, -page.halfHeight, 0.0),
                    page.axes[0], page.axes[1], label.heightMm, stroke),
      page.middle, page.axes[2]);
  if (const double share = ShareOnShell(page, *letters, bare, r.spacingMm); share < LeastShare)
  {
    std::ostringstream text;
    text << "reaches beyond the guide: " << std::floor(100.0 * share)
         << " % of its letters lie on bare wall, at least " << 100.0 * LeastShare
         << " % must; make it shorter or smaller, or move it";
    Refuse(n, text.str());
  }
  const double wall = r.gapMm + r.thicknessMm;
  const SolidPointer box = MakeBox(page.At(0.0, 0.0, 0.5 * (page.low + page.high)), page.axes,
    { page.halfWidth + stroke, page.halfHeight + stroke, 0.5 * (page.high - page.low) });
  const SolidPointer layer = label.engraved
                               ? MakeShell(bone, wall - label.depthMm, wall + r.thicknessMm)
                               : MakeShell(bone, wall - 0.5 * r.thicknessMm, wall + label.depthMm);
  return MakeIntersection({ layer, box, letters });
}

} // namespace hasp
