#ifndef MirrorGhost_h
#define MirrorGhost_h

#include "Grid/GridView.h"                     // for AnyGridView
#include "Grid/Progress.h"                     // for ProgressFunction
#include "Grid/TriangleMesh.h"                 // for TriangleMesh
#include "Planning/ImplantRecipe.h"            // for MirrorPlane
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <cstdint>  // for masks
#include <optional> // for planes
#include <span>     // for masks
#include <vector>   // for distances

/// Bone beside its own mirror image; free of VTK but for the export macro. World = patient LPS, mm.
namespace hasp
{

struct MirrorGhostSettings
{
  /// None: the plane of best symmetry is found (FitMirrorPlane).
  std::optional<MirrorPlane> plane;
  double spacingMm = 1.0; ///< of the grid that bone is measured on, [0.3, 3]
  double matchedMm = 2.0; ///< what is nearer to bone than this is matched, > 0
};

/// The mirrored surface, and how far it is from the real one.
struct MirrorGhost
{
  MirrorPlane plane;  ///< its normal looks to the patient's left, x >= 0
  bool found = false; ///< it was searched for
  TriangleMesh mesh;  ///< closed, turned outwards
  /// The residual symmetry map: of each point of the mesh to the real bone's surface, mm, NEGATIVE
  /// INSIDE real bone.
  std::vector<float> signedDistanceMm;
  ///@{
  /// Of the sizes of these, by the area that points stand for.
  double medianMm = 0.0, p95Mm = 0.0;
  double matchedShare = 0.0; ///< of the area: within matchedMm, [0, 1]
  ///@}
};

/// keep   one byte a sample of `grey`: bone is value >= isovalue, there; empty: everywhere
/// Distances are those of CoverageDistance on a grid that holds bone and ghost.
/// Throws std::invalid_argument, "mirror: …", for settings out of their ranges, a plane whose
/// normal is not unit within 1e-3, and over 2e8 points, before memory is taken; std::runtime_error
/// if there is no bone, or none that is like its mirror image where the plane is searched;
/// Cancelled. Any thread; all cores. About 25 bytes and 0.5 us of CPU time a point of the grid.
VTKHASPFILTERSSURGICALGUIDE_EXPORT MirrorGhost MakeMirrorGhost(const AnyGridView& grey,
  double isovalue, std::span<const std::uint8_t> keep = {},
  const MirrorGhostSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
