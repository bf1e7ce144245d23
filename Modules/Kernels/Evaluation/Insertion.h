#pragma once
#include "Evaluation/MeshSamples.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace hasp
{

struct InsertionSettings
{
  double isovalue = 226.0;               ///< bone is value >= isovalue
  double ignoreBelowMm3 = 0.0;           ///< smaller pieces of bone are none, >= 0
  glm::dvec3 direction{ 0.0, 0.0, 1.0 }; ///< the part lifts off along it; need not be unit, not 0
  double toleranceMm = 0.05;             ///< > 0: bone that is met less deeply is not counted
};

/// Can a part be lifted off the bone along a direction, and so be put on against it?
struct Insertion
{
  std::size_t samples = 0;  ///< of the part that were moved
  std::size_t blocked = 0;  ///< of them, that bone is in the way of
  double blockedMm2 = 0.0;  ///< of the part's surface
  double deepestMm = 0.0;   ///< how deep in bone a way goes; BeyondMm: that deep or deeper
  glm::dvec3 partAt{ 0.0 }; ///< place of the part on that way
  glm::dvec3 boneAt{ 0.0 }; ///< where it is in bone
  static constexpr double BeyondMm = 2.0;
};

/// Moves the part off, to the end of the volume: a ray from every sample that looks along the
/// direction, in steps of half the shortest spacing. Of the first piece of a ray that lies in bone,
/// the middle's depth is taken, by DistanceToIsosurface. Bone that is met no longer than a step
/// may be missed: it is at most step^2 / (8 r) deep where its surface is as round as a ball of
/// radius r.
/// What is in bone where the part lies is for the gap to say; it shows here as well.
/// Throws std::invalid_argument on settings out of range or a bad volume; Cancelled. Any thread;
/// all cores. Blocks of 8^3 cells without bone are passed at once, for 8 bytes each and one pass
/// over the volume.
Insertion MeasureInsertion(const AnyGridView& volume, std::span<const MeshSample> samples,
  const InsertionSettings& settings, const ProgressFunction& progress = {});

} // namespace hasp
