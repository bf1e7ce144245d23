#ifndef BoneTouch_h
#define BoneTouch_h

#include "Grid/GridView.h"                     // for AnyGridView
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <glm/vec3.hpp>

#include <optional> // for places

/// Bone under a finger, in a scan or in a fragment's voxels alone; free of VTK but for the export
/// macro. All: any thread; microseconds.
namespace hasp
{

struct TouchedBone
{
  glm::dvec3 place{ 0.0 };  ///< on the isosurface, world mm
  glm::dvec3 normal{ 0.0 }; ///< unit, out of the bone
};

/// The bone's surface next to a place: the nearest crossing of the isovalue on lines through it,
/// along the grey values' gradient and 26 directions, each `reachMm` long. Within a tenth of the
/// spacing of the nearest point where the surface is flat over a sample or two. Nothing: none so
/// near, or the scan ends there.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::optional<TouchedBone> TouchBone(
  const AnyGridView& scan, double isovalue, const glm::dvec3& place, double reachMm);

/// Out of the bone, unit: against the grey values' gradient, of samples one spacing away each way.
/// Nothing where the scan ends or grey values are flat.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::optional<glm::dvec3> BoneNormal(
  const AnyGridView& scan, const glm::dvec3& place);

/// Whether the trilinear value there is at least the isovalue; false outside the scan.
VTKHASPFILTERSSURGICALGUIDE_EXPORT bool IsInBone(
  const AnyGridView& scan, double isovalue, const glm::dvec3& place);

/// The middle of a bone that was touched from outside: half way between where a line enters bone
/// first and where it leaves it last within `reachMm`. `into` unit. Nothing: no bone there, or the
/// scan ends before.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::optional<glm::dvec3> MiddleOfBone(const AnyGridView& scan,
  double isovalue, const glm::dvec3& place, const glm::dvec3& into, double reachMm);

} // namespace hasp

#endif
