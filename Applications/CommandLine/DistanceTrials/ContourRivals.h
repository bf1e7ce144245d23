#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/TriangleMesh.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// A contour of sampled distances that does not know edges.
struct PlainContour
{
  std::string name;     ///< with version
  std::string absent{}; ///< why there is none
  /// values   mm, NEGATIVE INSIDE, of each sample of the grid
  std::function<TriangleMesh(const std::vector<float>& values, const GridGeometry& grid)> make{};
};

/// What a mesh Boolean made of a tree (RandomTree of these settings, meshes alone).
struct BooleanOutcome
{
  std::string ending{};   ///< empty: it came to its end; else "60 s", "signal 11" ...
  bool closed = false;    ///< each edge has two triangles
  bool manifold = false;  ///< and each point one fan, all turned the same way, all with an area
  long crossings = -1;    ///< pairs of triangles that meet; -1: not counted
  double volumeMm3 = 0.0; ///< signed
  double seconds = 0.0;   ///< of the Booleans alone
};
struct BooleanRival
{
  std::string name;
  std::string absent{};
  std::function<BooleanOutcome(std::uint32_t seed, int depth)> run{};
};

} // namespace hasp
