#ifndef SurfaceFragment_h
#define SurfaceFragment_h

#include "FragmentModels.h"                // for FragmentModel, FragmentWants
#include "Grid/Progress.h"                 // for ProgressFunction
#include "Grid/TriangleMesh.h"             // for TriangleMesh
#include "vtkHaspFiltersFragmentsModule.h" // for export macro

#include <string> // for warnings
#include <vector> // for warnings

/// From triangles to what a scene needs of a fragment: the sibling of FragmentModels for sherds,
/// dental scans and plates. Free of VTK but for the export macro.
namespace hasp
{

struct SurfaceFragmentSettings
{
  /// 0: the surface is closed, and the body is what it encloses. Else an open one is a sheet
  /// (Distance/SheetMesh.h), at least two spacings and at most 50 mm thick.
  double thicknessMm = 0.0;
  bool behind = true; ///< of a sheet: behind the face that its winding shows, else on both sides
  double spacingMm = 0.5;   ///< of the grid that it is measured on, [0.05, 10]
  double rangeMm = 0.0;     ///< of distance maps; 0: 16 spacings
  int shellPoints = 16'384; ///< of a pointshell, at most
  std::size_t mostSamples = std::size_t{ 200'000'000 }; ///< of the grid: 8 bytes each
};

struct SurfaceFragment
{
  /// In the surface's world, mm, as of a scan's fragment: `origin` is the middle of its box. Its
  /// surface is the closed mesh that was measured: welded, turned outwards.
  FragmentModel model;
  double volumeMm3 = 0.0;
  std::vector<std::string> warnings; ///< full sentences with numbers, no names
};

/// Distances are OpenVDB's (Distance/LevelSet.h): Euclidean to the triangles, and inside is what a
/// flood from outside does not reach, so that shells within the body and what meets itself are one
/// solid. Beyond the range they are clamped.
///
/// Throws std::invalid_argument, "surface: …", with what is wrong, its value and what to do: no
/// triangles, points that are not finite, a mesh that is open where no thickness is given (how many
/// border edges and holes, and where the first is), triangles wound against each other, a box of
/// less than 1 mm (metres?) or more than 4000 mm, settings out of range, a grid of too many samples
/// before it is taken; std::runtime_error in a build without HASP_ENABLE_OPENVDB; Cancelled.
/// Warnings: inside out (it is turned), edges of more than two triangles, several pieces, a sheet
/// of a mesh that is closed.
/// Any thread; all cores; the same with any number of them. O(area + samples of the box).
VTKHASPFILTERSFRAGMENTS_EXPORT SurfaceFragment BakeSurface(const TriangleMesh& mesh,
  const SurfaceFragmentSettings& settings, const FragmentWants& wants = AllOfFragment,
  const ProgressFunction& progress = {});

/// So many points as give one to each `pointMm2` of the body's surface, of which a sheet has two
/// faces: 1024 at least, and `most` at most unless that is less. Any thread; O(triangles).
VTKHASPFILTERSFRAGMENTS_EXPORT int ShellPointsOf(
  const TriangleMesh& mesh, double thicknessMm, double pointMm2, int most);

} // namespace hasp

#endif
