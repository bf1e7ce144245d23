#pragma once
// Private to LightCache: from the pixels of a traced picture back to hits.
#include "Isosurface/CellTracer.h"
#include "Isosurface/LightBlocks.h"

namespace hasp
{

/// What light needs to know of a picture. Threads: any, while picture and tracer live.
class LightView
{
public:
  static constexpr int FinestUnits = 1 << 19; ///< along the volume's longest side
  static constexpr int Levels = 19;

  /// pixelsACorner: the distance of lattice corners that PlaceOf chooses, about.
  LightView(const CellTracer& tracer, const PictureView& view, const TracedPicture& picture,
    double pixelsACorner);

  /// Millimetres of a unit of LightBlocks: a step of level 0.
  static double UnitOf(const GridGeometry& geometry);

  /// What the pixel's ray met; it must have met something.
  CellHit HitOf(std::size_t pixel) const;
  LightPlace PlaceOf(const CellHit& hit) const;

private:
  const CellTracer* Tracer;
  const TracedPicture* Picture;
  glm::dvec4 Eye; ///< in index coordinates; w is 0 where rays are parallel, never negative
  glm::dvec4 ClipW;
  double Unit;            ///< mm
  double UnitsACornerByW; ///< distance of corners, by the clip coordinate w
};

} // namespace hasp
