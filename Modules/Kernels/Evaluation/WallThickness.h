#pragma once
#include "Evaluation/MeshSamples.h"
#include "Evaluation/TriangleTree.h"

#include <span>
#include <vector>

namespace hasp
{

/// What a ray finds that goes into the material at a place, against its normal.
struct Chord
{
  double mm = 0.0;          ///< to where it comes out; 0: it does not
  glm::dvec3 normal{ 0.0 }; ///< unit, out of the solid, where it does
};

/// One for each sample. Any thread; all cores; about 1 us a sample.
std::vector<Chord> MeasureChords(const TriangleTree& tree, std::span<const MeshSample> samples);

/// How thick a part's walls are. A wall is material between two sides that look away from each
/// other, within WallDegrees of opposite. Sides that meet at a greater angle are an edge, whose
/// thickness falls to 0 in any part.
struct WallThickness
{
  double wallMm2 = 0.0;           ///< of the mesh that is a side of a wall
  double leastMm = 0.0;           ///< of ThinnestPlace (ThinPlaces.h); 0: there are no walls
  glm::dvec3 leastAt{ 0.0 };      ///< middle of the wall there
  double p5Mm = 0.0, p50Mm = 0.0; ///< 5 and 50 % of the sides' area have less
  static constexpr double WallDegrees = 20.0;
};

/// Chords of sides that are opposite each other within WallDegrees. Limit: a groove whose sides are
/// steeper is seen by the chords of the other side alone where its floor is flat.
WallThickness MeasureWalls(std::span<const MeshSample> samples, std::span<const Chord> chords);

} // namespace hasp
