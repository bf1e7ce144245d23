#pragma once
#include "Distance/ImplicitSolid.h"
#include "Evaluation/PartClaims.h"
#include "Grid/GridView.h"
#include "Grid/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// What is done to a part. All but the last two of the first row are things that happen to files
/// and printers, and not one of them shows in a picture.
enum class SeededDefect
{
  None,
  MeshHole,
  FlippedTriangle,
  SelfIntersection,
  ThinWall,
  WrongGap,
  NarrowSlot,
  SmallHole,
  Mirrored,
  InchForMm,
  LoosePiece
};
inline constexpr int SeededDefects = 10; ///< besides None

const char* SeededDefectName(SeededDefect defect);

/// A shell with a slot and two holes on a bone of its own, both drawn by a seed, anywhere and
/// anyhow turned.
struct SeededPart
{
  GridGeometry scan;              ///< of the bone
  std::vector<std::int16_t> grey; ///< HU-like, 300 a mm at the bone's surface, which is 226
  PartClaims claims;              ///< of the clean part
  TriangleMesh mesh;              ///< as read back: 32-bit floats, welded

  AnyGridView Bone() const { return GridView<const std::int16_t>{ this->grey.data(), this->scan }; }
};

/// The part of a seed; the same bone and claims for each defect. Where and how bad the defect is
/// follows from the seed, too: at least three times what the claims' tolerances let through of a
/// gap, slot or hole, and less than three fifths of the shell's thickness left. All cores.
SeededPart MakeSeededPart(std::uint32_t seed, SeededDefect defect);

} // namespace hasp
