#pragma once
#include "Grid/PhantomAnatomy.h"

namespace hasp
{

/// How much of a flat surface's far side a scanner sees at a depth below the surface.
struct SurfaceStep
{
  explicit SurfaceStep(const PhantomSettings& settings);

  /// depth      mm, > 0 inside
  /// outward    unit normal of the surface
  /// In [0,1]; exactly 0 and 1 from reachMm on.
  double operator()(double depth, const glm::dvec3& outward) const;

  double reachMm;

private:
  bool blurred;
  double edgeMm;
  glm::dvec3 blurMm;
  double sliceMm;
};

/// What the scanner looks at: solids painted over each other, in this order, each a value in HU.
/// Any thread.
struct PhantomScene
{
  struct Paint
  {
    std::size_t solid;
    double insetMm; ///< painted where it is deeper than this below the solid's surface
    double value;   ///< HU
  };
  explicit PhantomScene(const PhantomSettings& settings);

  /// HU before noise. O(shapes).
  double Value(const glm::dvec3& point) const;

  /// A smaller scene with the same values, bit for bit, at all points of a ball. No paints are left
  /// where all points are `base`.
  PhantomScene Near(const glm::dvec3& center, double radius) const;

  SurfaceStep step;
  double base; ///< HU, under all paints
  std::vector<AnalyticSolid> solids;
  std::vector<Paint> paints;
};

} // namespace hasp
