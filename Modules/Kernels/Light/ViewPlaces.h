#pragma once
// Private to SceneLightCache: where on lattices the light of a view's pixels is kept.
#include "Isosurface/LightBlocks.h"
#include "Light/LitScene.h"

namespace hasp
{

/// Lattices of the world, fixed while light is kept in them.
struct LightLattice
{
  static constexpr int FinestUnits = 1 << 19; ///< along an axis
  static constexpr int Levels = 19;

  glm::dvec3 low{ 0.0 };
  double unit = 0.0; ///< mm; 0: there is none

  /// Room for a scene twice as large in all directions.
  static LightLattice Around(const LitScene::Box& box);
  bool Holds(const LitScene::Box& box) const;
};

/// Threads: any.
class ViewPlaces
{
public:
  /// view: of the world. pixelsACorner: the distance of lattice corners that At chooses, about.
  ViewPlaces(const PictureView& view, const LightLattice& lattice, double pixelsACorner);
  LightPlace At(const glm::dvec3& position, const glm::dvec3& normal) const;

private:
  LightLattice Lattice;
  glm::dvec4 ClipW;
  double UnitsACornerByW;
};

} // namespace hasp
