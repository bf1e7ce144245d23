#pragma once
#include "Distance/ImplicitSolid.h"
#include "Planning/Osteotomy.h"

#include <glm/mat3x3.hpp>

namespace hasp
{

/// A blade and its own coordinates: x along it, y across, z along its normal, mm from its middle.
/// Immutable. Any thread.
class Blade
{
public:
  explicit Blade(const Osteotomy& osteotomy); ///< a valid one

  glm::dvec3 Local(const glm::dvec3& world) const;
  glm::dvec3 World(const glm::dvec3& local) const;
  /// Unit columns: along, across, normal.
  const glm::dmat3& Axes() const { return this->Directions; }
  /// Half its sides.
  const glm::dvec3& Half() const { return this->HalfSides; }
  SolidPointer Box() const;
  /// Upright, in the world.
  ImplicitSolid::Box Bounds() const;

  /// Whether the straight way from a to b leads through the box; then `inside` is the middle of
  /// what does. World mm.
  bool Meets(const glm::dvec3& a, const glm::dvec3& b, glm::dvec3& inside) const;

private:
  glm::dvec3 Middle, HalfSides;
  glm::dmat3 Directions;
};

/// A blade and what it takes: `tool` is its box, less what is nearer to bone that is to stay whole.
struct CutTool
{
  Blade blade;
  SolidPointer region; ///< what of the box is taken; null: all
  SolidPointer tool;

  bool Takes(const glm::dvec3& world) const;
  /// Whether a straight way leads through the tool.
  bool Blocks(const glm::dvec3& a, const glm::dvec3& b) const;
};

} // namespace hasp
