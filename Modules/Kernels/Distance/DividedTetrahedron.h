#pragma once
#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace hasp
{

/// How it is known that a contour does not meet itself, also when its points were rounded.
///
/// The surface divides each tetrahedron of the grid that it passes into smaller ones, and each of
/// their triangles in the same way for both tetrahedra beside it. Where no small tetrahedron is
/// turned over when the points move to where floats can hold them, the map that takes the grid,
/// divided, to where its points are now is one to one (its border stays, so its degree is 1:
/// Lipman 2014, Bijective mappings of meshes with boundary); so the surface, which is made of sides
/// of small tetrahedra, is embedded as well as it was before.

/// A triangle of the grid's tetrahedra through which the surface passes, from one side to another.
struct CrossedTriangle
{
  glm::dvec3 lone{}, ends[2]{}; ///< corners: that on a side of the surface by itself, the others
  glm::dvec3 crossing[2]{};     ///< of the sides from `lone` to them
  glm::dvec3 bend[2]{};         ///< of the surface's line, on its way from crossing[0]
  int bends = 0;
  bool inside = false;   ///< lone is
  bool diagonal = false; ///< what remains with four corners is cut from ends[0], or from ends[1]
};

/// A part of the boundary of a tetrahedron, or of the surface in it.
struct ShellTriangle
{
  std::array<glm::dvec3, 3> at; ///< counter-clockwise seen from outside of it
  bool inside;                  ///< this part is inside of the solid
};
using Shell = std::vector<ShellTriangle>;

/// Appends what the line cuts a triangle into, 3 to 7 parts: counter-clockwise as lone, ends[0],
/// ends[1], or turned.
void Divide(const CrossedTriangle& triangle, bool turned, Shell& shell);

/// Chooses the better diagonal and returns the least height of the parts of a triangle, mm;
/// negative if one is turned over.
double ChooseDiagonal(CrossedTriangle& triangle) noexcept;

/// The least height of the tetrahedra from a center to all triangles of a shell round it, mm;
/// negative if one is turned over.
double LeastHeight(const glm::dvec3& center, std::span<const ShellTriangle> shell) noexcept;

/// The same where a surface, counter-clockwise seen from outside of the solid, cuts a tetrahedron
/// in two, and each part has its own center.
double LeastHeight(
  std::span<const ShellTriangle> shell, std::span<const std::array<glm::dvec3, 3>> surface);

} // namespace hasp
