#pragma once
#include "Distance/SurfaceElements.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp
{

/// The inner loops of surface elements, written once (ElementLanes-inl.h) and compiled for each
/// instruction set by Highway, and for one number at a time. Lanes do not depend on each other:
/// results do not depend on what is computed side by side. Any thread; nothing throws, no memory is
/// taken. Lengths as in SurfaceElements.
struct ElementLanes
{
  static constexpr float Least = 0.03F, Most = 0.97F; ///< coverage outside tells no plane
  static constexpr int Side = 16;                     ///< voxels of a brick
  static constexpr int Reach = 5; ///< voxels to each side in which an element is looked for
  static constexpr int Padding = 16;

  /// One row of coverage, with the rows that share faces with it (itself where the grid ends).
  struct Row
  {
    const float* here; ///< here[-1] and here[length] are read, and up to Padding more
    const float* faces[4];
    int length;
  };
  /// Which voxels around a brick have elements: bit x of [z][y], all from -Reach on.
  struct Bits
  {
    std::uint32_t row[Side + 2 * Reach][Side + 2 * Reach];
  };
  using Element = SurfaceElements::Element;

  const char* name;

  /// Marks in `bits` the voxels of a row that give an element, as coverage or as a trilinear
  /// surface of 0.5, and writes -beyond or +beyond to `sides`, if that is not null, by value. False
  /// if a value of coverage is not in [0,1], or one of the other is NaN.
  bool (*scanRow)(const Row& row, bool coverage, std::uint32_t* bits, float* sides, float beyond);

  /// Inward unit gradients (Sobel) of elements [first, last) into `to`, as normals; measures
  /// edges.
  EdgeFacts (*gradients)(const SurfaceElements& surface, const float* coverage, std::size_t first,
    std::size_t last, Element* to);

  /// Of elements [first, last), whose gradients are there: normals smoothed over neighbours, and
  /// the planes that cut off the coverage, into `to`.
  void (*planes)(const SurfaceElements& surface, const float* coverage, std::size_t first,
    std::size_t last, Element* to);

  /// The same for elements on the trilinear surface of 0.5, whatever the values: planes at its
  /// foot.
  void (*isoPlanes)(const SurfaceElements& surface, const float* values, std::size_t first,
    std::size_t last, Element* to);

  /// Of elements [first, last), whose planes are there: normals that agree with where the planes
  /// around lie, and their planes, into `to`.
  void (*polish)(const SurfaceElements& surface, const float* coverage, std::size_t first,
    std::size_t last, Element* to);

  /// Foot points, normals and curvature of what elements [first, last) span with their neighbours,
  /// into `to`.
  void (*refine)(const SurfaceElements& surface, const float* coverage, std::size_t first,
    std::size_t last, Element* to);

  /// Lists the voxels of a brick with an element's voxel within `most`, each packed with the steps
  /// there: x, y, z, then steps + Reach, four bits each from bit 0. Room in `list` for Side^3 +
  /// Padding. Returns how many; the list goes on with copies of its last entry.
  int (*listNear)(const SurfaceElements& surface, const Bits& bits, float most, std::int32_t* list);

  /// Signed distances of the voxels that listNear listed; `origin` is the brick's first voxel.
  void (*near)(const SurfaceElements& surface, const float* coverage, const glm::ivec3& origin,
    const std::int32_t* list, int count, float* distances);

  /// Replaces those distances of a row, mm, that are `from` or more from 0 by distances to refined
  /// elements, with the same sign; `seeds` are the nearest elements' voxels.
  void (*farRow)(const SurfaceElements& surface, const Element* refined, int y, int z,
    const std::uint32_t* seeds, float from, float* distances);
};

/// The widest that this machine runs.
const ElementLanes& BestElementLanes();

/// All that this machine runs, widest first; the last is one number at a time. For tests.
std::vector<ElementLanes> AllElementLanes();

} // namespace hasp
