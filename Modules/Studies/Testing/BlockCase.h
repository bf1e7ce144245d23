#pragma once
#include "Studies/FracturedBlocks.h"
#include "Studies/ReductionCases.h"

/// A block in three as a broken bone: the lower half stands, the two upper ones were scanned above
/// their places and aside.
inline hasp::ReductionCase BlockCase()
{
  const hasp::FracturedBlocks blocks = hasp::MakeFracturedBlocks({ .pieces = 3,
    .sideMm = { 28, 16, 18 },
    .spacingMm = 0.6,
    .points = 1024,
    .coarsest = 64,
    .seed = 5 });
  hasp::ReductionCase broken;
  broken.name = "block";
  broken.names = { "lower", "left", "right" };
  broken.fixed = { true, false, false };
  broken.partners = { {}, { 0, 2 }, { 0, 1 } };
  for (std::size_t n = 0; n < blocks.pieces.size(); ++n)
  {
    const hasp::BlockPiece& piece = blocks.pieces[n];
    const glm::dvec3 away(n == 2 ? 5.0 : n == 1 ? -5.0 : 0.0, 0.0, n > 0 ? 8.0 : 0.0);
    broken.bodies.push_back(
      { piece.whole.body, piece.map, piece.shell, piece.whole.bodyInWorld.position + away });
    broken.trueBodyInWorld.push_back(piece.whole.bodyInWorld);
  }
  return broken;
}
