#pragma once
#include "Grid/TriangleMesh.h"
#include "PlateScrews.h"
#include "PosedBone.h"

namespace hasp
{

/// What a plate is made of: everything but its mesh, which SharpContour makes of the solid on the
/// grid.
struct PlateSolid
{
  SolidPointer solid;
  GridGeometry grid; ///< axes of the world
  PlatePath path;
  std::vector<PlacedScrew> screws;
};

/// The tree of vtkHaspPlateFilter, free of VTK: see there for what is made.
///
///   bevelled(ribbon along the landmarks) - holes
///
/// The ribbon is what lies between gapMm and gapMm + thicknessMm of bone (PosedBone.h), bridged,
/// and within widthMm / 2 of the path seen along its normal (MakeRibbon). Throws
/// std::invalid_argument (recipe, volume, labels) and std::runtime_error (no such plate can be
/// made), naming the landmark, screw or fragment; Cancelled. Any thread; all cores.
PlateSolid MakePlateSolid(
  const BoneScan& scan, const PlateRecipe& recipe, const ProgressFunction& progress = {});

/// The same on bone that is a solid already.
PlateSolid MakePlateOn(SolidPointer bone, SolidPointer surface, const PlateRecipe& recipe);

/// A plate ready to be written: one closed piece.
struct BuiltPlate
{
  TriangleMesh mesh;
  PlateSolid made;
};
BuiltPlate BuildPlate(
  const BoneScan& scan, const PlateRecipe& recipe, const ProgressFunction& progress = {});

} // namespace hasp
