#pragma once
#include "Grid/Progress.h"
#include "Reduction/BakeFitBody.h"
#include "Reduction/FitTerms.h"
#include "Studies/FractureCaseMaker.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

enum class BrokenBone
{
  Mandible, ///< condyle, ramus, body; the cranium is only touched
  Head      ///< maxilla, zygoma, two pieces of the vault
};

struct ReductionCaseSettings
{
  BrokenBone bone = BrokenBone::Mandible;
  double spacingMm = 0.8; ///< of cubic voxels, [0.2, 2]
  /// Pieces go 8 mm and 8 degrees apart, without a crack: what broke had none.
  FractureCaseChoices damage{ .shiftMm = 8.0, .turnDegrees = 8.0, .crackMm = 0.0 };
  bool halfLevels = true; ///< surfaces where the scanner saw half; else at 226 HU
  FitBakeSettings bake{};
  std::uint64_t seed = 1; ///< of faces, moves and noise
};

/// A broken bone, scanned, and its pieces as bodies to be fitted.
struct ReductionCase
{
  std::string name;
  std::vector<std::string> names; ///< of the bodies
  std::vector<BakedFitBody> bodies;
  std::vector<RigidPose> trueBodyInWorld;         ///< where the bone was whole
  std::vector<bool> fixed;                        ///< scanned where it was
  std::vector<std::vector<std::size_t>> partners; ///< bodies of the same bone
  double bakedMs = 0.0;

  /// All others where they were: the partners' faces attract, the rest is touched.
  FitScene SceneWithout(std::size_t body) const;
  /// UniformStart about the middle of its surface.
  RigidPose StartOf(std::size_t body, double mm, double degrees, std::uint64_t seed) const;
};

/// A coarse pose of a body: evenly in volume within `mm` of the true one, turned by up to `degrees`
/// about any axis through `middle` (of its own axes).
RigidPose UniformStart(const RigidPose& trueBodyInWorld, const glm::dvec3& middle, double mm,
  double degrees, std::uint64_t seed);

/// Breaks the phantom and bakes all pieces. Throws as MakeFractureCase and BakeFitBody. All cores;
/// 5 to 20 s, and 60 bytes a voxel.
ReductionCase MakeReductionCase(
  const ReductionCaseSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp
