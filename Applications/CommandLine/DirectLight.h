#pragma once
#include "IsosurfaceView.h"
#include "PictureErrors.h"

#include <memory>

namespace hasp
{

/// Light as it comes: ambient occlusion by rays of its own for each pixel, and a hard shadow. What
/// a light that adds up is measured against, and, with many rays, its truth.
struct DirectLightSettings
{
  int rays = 16; ///< a pixel, for ambient occlusion
  double darkeningMm = 25.0;
  glm::dvec3 towardsLight{ 0.0, 0.0, 1.0 }; ///< world, unit
};

/// The fastest direct way this build has: Embree's tree over active cells, primary and
/// shadow rays in packets, all rays and the shading on all cores. Pixels without a surface are
/// black. Threads: one.
class DirectLight
{
public:
  /// The view must outlive it. Extracts the cells and makes their tree.
  explicit DirectLight(const IsosurfaceView& view);
  ~DirectLight();

  /// Shades as the mappers do. `number`: of the frame; each has rays of its own.
  void Draw(const DirectLightSettings& settings, std::uint32_t number);
  const PictureTruth& Picture() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
