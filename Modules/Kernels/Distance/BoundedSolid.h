#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"

namespace hasp
{

/// A solid as a grid can hold it: cut flat by planes an eighth of a cell before the grid's border,
/// and smaller by 1e-6 of a cell, so that a face along grid points has a side: outside. Values are
/// divided by the solid's steepness: none changes by more than 1 mm a mm. Nothing is NaN or
/// infinite: what is NaN is outside.
/// Keeps references. Any thread.
class BoundedSolid
{
public:
  BoundedSolid(const ImplicitSolid& solid, const GridGeometry& grid);

  double At(const glm::dvec3& world) const noexcept;
  ImplicitSolid::Sample SampleAt(const glm::dvec3& world) const noexcept;
  ImplicitSolid::Sample FaceAt(std::uint32_t face, const glm::dvec3& world) const noexcept;
  double Cell() const { return this->Smallest; } ///< its shortest side, mm

private:
  ImplicitSolid::Sample Border(const glm::dvec3& world) const noexcept;

  ImplicitSolid::Sample Level(ImplicitSolid::Sample sample) const noexcept;

  const ImplicitSolid& Solid;
  const GridGeometry& Grid;
  double Smallest, Scale;
  glm::dvec3 Low, High; ///< of the planes, mm from the grid's origin along its axes
};

} // namespace hasp
