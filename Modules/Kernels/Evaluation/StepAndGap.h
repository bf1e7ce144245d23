#pragma once
#include "Evaluation/SurfaceDifference.h"
#include "Grid/RigidPose.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace hasp
{

struct StepAndGapSettings
{
  double reachMm = 5.0; ///< faces farther apart than this are no fracture, nor are deeper overlaps;
                        ///< steps are looked for as high; (0, 50]
  double rimMm = 2.0;   ///< how far from the fracture line a step is measured, (0, 20]
  double facing = 0.7;  ///< least cosine between a face and what it faces, in (0, 1)
};

/// Figures along a fracture, mm, by area; all 0 if there are none of them.
struct FractureFigures
{
  double meanMm = 0.0;                         ///< with its sign
  double meanAbsMm = 0.0;                      ///< of the size alone
  double p5Mm = 0.0, p50Mm = 0.0, p95Mm = 0.0; ///< with sign
  double p50AbsMm = 0.0, p95AbsMm = 0.0;       ///< of the size alone
  double maxAbsMm = 0.0;
  glm::dvec3 maxAt{ 0.0 }; ///< world, on the first fragment
  double areaMm2 = 0.0;    ///< that was measured; of points the sum of their weights
  std::size_t samples = 0;
};

struct StepAndGap
{
  FractureFigures gap;  ///< POSITIVE APART, negative where the fragments lie in each other
  FractureFigures step; ///< positive where the second fragment's surface stands higher
};

/// Gap and step-off between two fragments that broke apart, from their closed meshes alone.
///
/// Gap: at each sample of the first fragment's face, the way along the face's normal to the other
/// face. Face is whose nearest place of the second fragment lies within reach and looks at it
/// (cosine of the normals below -facing), and whose normal meets such a triangle first: forwards
/// apart, backwards within.
/// Step-off: at each sample of the first fragment's other surface that lies s <= rimMm from a face
/// and not along it, the place of the second fragment straight across the line, s and the gap
/// beyond it: (b - a) . m with m halfway between the two normals, so that a ball's surface has none
/// however far from the line it is measured. Both sides of a plate of bone count, the far one too.
/// Limits: a face that slides is measured where the faces still overlap; edges rounder than rimMm
/// are partly taken for face; a step higher than rimMm is seen from one side alone. Steps need
/// faces: of fragments farther apart than reach nothing is said (samples 0). Swapping the fragments
/// changes figures by what the samples are apart.
///
/// Throws std::invalid_argument on settings out of range and poses as CheckedPose does. Any thread;
/// all cores, the same bits on any number of them.
StepAndGap MeasureStepAndGap(const MeasuredSurface& first, const RigidPose& firstToWorld,
  const MeasuredSurface& second, const RigidPose& secondToWorld,
  const StepAndGapSettings& settings = {});

/// One place of the unbroken bone on a fracture face, as each fragment has it, in its own place.
struct FacePair
{
  glm::dvec3 first{ 0.0 }, second{ 0.0 };
  glm::dvec3 normal{ 0.0 };  ///< unit, of the first fragment's face, out of it
  glm::dvec3 outward{ 0.0 }; ///< unit, of the bone's surface, on the line; {0} inside of the face
  double weight = 1.0;       ///< > 0
};

struct TrueStepAndGap
{
  FractureFigures gap;   ///< along the normal, POSITIVE APART
  FractureFigures step;  ///< along outward, of pairs that have one: positive where the second
                         ///< fragment stands higher
  FractureFigures slide; ///< across the normal, >= 0
};

/// The same of corresponding places, where truth is known: exact. Normals turn with the first
/// fragment. Throws std::invalid_argument without pairs, on what is not finite or not unit within
/// 1e-6, weights that are not above 0, and poses as CheckedPose does. Any thread; one core.
TrueStepAndGap MeasureTrueStepAndGap(
  std::span<const FacePair> pairs, const RigidPose& firstToWorld, const RigidPose& secondToWorld);

} // namespace hasp
