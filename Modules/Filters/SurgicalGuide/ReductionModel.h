#ifndef ReductionModel_h
#define ReductionModel_h

#include "Grid/Progress.h"                     // for ProgressFunction
#include "Grid/RigidPose.h"                    // for where fragments are put
#include "Grid/TriangleMesh.h"                 // for TriangleMesh
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <span> // for fragments

/// Fragments where a plan puts them, as models to be printed. Free of VTK but for the export macro.
namespace hasp
{

/// A fragment, and the pose that takes it from where it was scanned to where it shall be.
struct PosedMesh
{
  const TriangleMesh* mesh = nullptr; ///< closed, as CutFragments gives it; not kept
  RigidPose pose;                     ///< its orientation is unit within 1e-3
};

/// The mesh moved: one object of a model of several, closed where the fragment is. Its points are
/// those of 32-bit floats, as files of parts keep them.
/// Throws std::invalid_argument for a pose that is not finite or not unit.
VTKHASPFILTERSSURGICALGUIDE_EXPORT TriangleMesh PlacedMesh(const PosedMesh& fragment);

/// All fragments as one body, whether they overlap, touch or lie apart: a closed 2-manifold that
/// does not meet itself, for printers that want one. What lies in two fragments counts once;
/// hollows stay.
///
/// spacingMm   of the grid that it is sampled on, (0, 5]; a third of the thinnest wall is enough
/// Method: MeshCoverage of all triangles together is the coverage of the union, also of fragments
/// that share a face; then CoverageDistance (DistanceOfMesh) and SharpContour.
/// Resampled, and so not sharp: faces are true to 0.02 spacings, edges rounded by up to 0.8
/// (CoverageDistance.h says more), volumes of boxes of 20 spacings within 1 % (TestReductionModel).
/// Limits: gaps and walls thinner than a spacing may close or break; so may bodies that meet in a
/// line or a point alone.
/// Throws std::invalid_argument without fragments; on a fragment with a pose that is none, or that
/// is empty, not closed or inside out (each error begins with its place in `fragments`, from 0:
/// "fragments[2] ..."); on spacingMm out of its range, and a grid of more than 2e8 points;
/// std::runtime_error where nothing is left of it; Cancelled. Any thread; all cores, the same bits
/// on any number of them. About 0.4 us of CPU time and 25 bytes a point of the grid around all of
/// them.
VTKHASPFILTERSSURGICALGUIDE_EXPORT TriangleMesh UniteFragments(
  std::span<const PosedMesh> fragments, double spacingMm, const ProgressFunction& progress = {});

} // namespace hasp

#endif
