#pragma once
#include "Grid/GridView.h"
#include "IsosurfaceMethods.h"
#include "WorldRay.h"

#include <array>
#include <string>
#include <unordered_map>

namespace hasp
{

/// A ray through each pixel's centre, row by row from below.
std::vector<WorldRay> PixelRays(const IsosurfaceView& view);

/// What rays meet first, by FirstTrilinearHit. One thread at a time.
struct DepthTruth
{
  static constexpr int Beside = 16;
  struct Hit
  {
    glm::dvec3 position; ///< world, mm
    glm::dvec3 gradient; ///< a mm
  };
  AnyGridView grid;
  double isovalue; ///< a float's value, as the methods see it
  std::vector<WorldRay> rays;
  std::vector<std::optional<Hit>> hits;

  DepthTruth(const AnyGridView& grid, double isovalue, std::vector<WorldRay> rays);
  /// Of PixelRays.
  explicit DepthTruth(const IsosurfaceView& view);

  /// What the rays meet that lie 1e-4 voxel beside ray n, all round it. Found once, for all
  /// renderers whose errors are looked at; half a KiB a ray.
  const std::array<std::optional<glm::dvec3>, Beside>& HitsBeside(std::size_t n) const;

private:
  mutable std::unordered_map<std::size_t, std::array<std::optional<glm::dvec3>, Beside>> Found;
};

/// Distances along the rays between what is shown and the truth, voxels (of the smallest spacing).
struct DepthErrors
{
  /// Without rays that graze: facing < 0.2, or a step of 1e-4 voxel aside, or of 1e-6 of the cell's
  /// largest corner in isovalue, is magnified more than five times along the ray.
  double rms = 0.0, p99 = 0.0, max = 0.0;
  double maxAll = 0.0;     ///< with them
  std::size_t maxAt = 0;   ///< the ray of max
  std::size_t surface = 0; ///< rays that truly meet the surface
  std::size_t missed =
    0; ///< of them: nothing shown, or another sheet (more than a quarter voxel off)
  std::size_t invented = 0; ///< shown where the ray truly meets nothing
  /// Would be missed or invented, but is right for such a ray beside or such an isovalue: no float
  /// can decide. Counted in neither.
  std::size_t tangent = 0;
  double MissedShare() const
  {
    return this->surface ? double(this->missed + this->invented) / double(this->surface) : 0.0;
  }
  std::string Text() const; ///< the counts
};
DepthErrors MeasureDepth(const DepthTruth& truth, const SurfacePoints& shown);

/// For rivals whose surface is another one, triangles say: no ray is excused but those with facing
/// < 0.2.
DepthErrors MeasureRival(const DepthTruth& truth, const SurfacePoints& shown);

} // namespace hasp
