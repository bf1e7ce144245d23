#pragma once
#include "Distance/ImplicitSolid.h"

#include <openvdb/openvdb.h>

namespace hasp
{

/// Anatomy as a solid out of a level set: MakeGridSolid's sibling for narrow bands, in
/// Hasp::KernelLevelSet.
///
/// levelSet   such as LevelSetOf gives: class GRID_LEVEL_SET, mm, NEGATIVE INSIDE, axes upright on
///            each other, spacings may differ. Shared, not copied, and read by all threads: nobody
///            may change it any more.
/// Within the band, trilinear between its values. Beyond, the sign and the background's value,
/// which is a bound: no surface is nearer. Outside the box of what is inside, two voxels larger, it
/// is the greater of that and the distance to the box. One face: the isosurface.
///
/// Steepness is measured, as of MakeGridSolid. Throws std::invalid_argument if the grid is null, of
/// another class, without anything inside, has a background below a voxel's diagonal (the band
/// would miss samples around the surface), values that are not finite, or changes by more than 3 mm
/// a mm: grey values, or a band with a hole in it. O(band) to make, O(1) to ask: eight look-ups.
SolidPointer MakeLevelSetSolid(openvdb::FloatGrid::ConstPtr levelSet);

} // namespace hasp
