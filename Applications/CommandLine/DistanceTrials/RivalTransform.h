#pragma once
#include "Grid/GridGeometry.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hasp
{

/// What transforms are given. Lives as long as runs do.
struct TransformInput
{
  GridGeometry grid;
  std::vector<float> coverage;
  std::vector<std::uint8_t> mask; ///< coverage of 0.5 and more
  int threads = 1;
};

/// A transform of others on its input, which it has in its own form already.
class RivalRun
{
public:
  virtual ~RivalRun() = default;
  virtual void Run() = 0; ///< what is timed
  /// mm, NEGATIVE INSIDE, of the last run; infinite, or as far as its band is, where it says
  /// nothing.
  virtual std::vector<float> Distances() const = 0;
};

/// A transform of others, at the settings that are best here. A library that is not there gives
/// `absent`, and no run.
struct RivalTransform
{
  std::string key;  ///< "itk": of rows' ids
  std::string name; ///< with version and settings
  std::string absent{};
  bool band = false;  ///< near the surface alone: within 3 voxels at least
  bool exact = false; ///< Euclidean distance to the mask, as SignedEuclideanDistance
  std::function<std::unique_ptr<RivalRun>(const TransformInput&)> make{};
};

/// ITK's SignedMaurerDistanceMapImageFilter (HASP_ENABLE_ITK).
RivalTransform MaurerRival();
/// OpenVDB (HASP_ENABLE_OPENVDB): fogToSdf of coverage; volumeToMesh, meshToSignedDistanceField out
/// to `bandVoxels`.
RivalTransform FogRival();
RivalTransform MeshRival(int bandVoxels);

} // namespace hasp
