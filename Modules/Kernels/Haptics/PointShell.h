#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/ResourceUse.h"
#include "Haptics/ContactPoints.h"

#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// A point of a surface and its outward normal (unit), world, mm.
struct SurfacePoint
{
  glm::vec3 position;
  glm::vec3 normal;
};

struct PointShellSettings
{
  int points = 65'536; ///< in all levels together, at most
  int coarsest = 256;  ///< points of level 0; each level has four times as many as the one before
  std::uint32_t seed = 1;
};

/// A body's surface as points, in levels: level n is the first LevelEnd(n) points of one order in
/// which every prefix is spread evenly over the surface (Barbic and James 2008), so a step that
/// runs out of time has done whole levels. Within what a level adds, points are in clusters of 16,
/// a whole vector each, in the order of a balanced k-d tree: a Morton order cut at medians, so that
/// neighbours in memory are neighbours in space and no cluster straddles a jump of the curve (its
/// balls are half as large as Morton's). Static; immutable.
///
/// Another number of points is another order: prefixes of one length are alike, not the same.
///
/// A point of level n stands for SurfaceArea / LevelEnd(n): contact stiffness per area does not
/// depend on how many points were evaluated.
/// Threads: any, once made. Memory: 26 B a point.
class PointShell
{
public:
  /// The zero surface of a signed distance, NEGATIVE INSIDE, in the grid's world. Places candidates
  /// on the surface in each cell that it crosses, evenly per area; orders them by elimination.
  /// origin: of the body's own axes, world (its centre of rotation). No surface: a shell without
  /// points. Throws std::invalid_argument on an invalid geometry or setting; Cancelled. O(samples +
  /// points log points).
  static std::shared_ptr<const PointShell> OfSurface(const GridView<const float>& distances,
    const glm::dvec3& origin, const PointShellSettings& settings = {},
    const ProgressFunction& progress = {});
  /// Of given points, which stand for `surfaceArea` mm^2 together, evenly; positions relative to
  /// `origin`. Throws std::invalid_argument if one is not finite or a normal not unit within 1e-3.
  static std::shared_ptr<const PointShell> OfPoints(std::span<const SurfacePoint> points,
    double surfaceArea, const glm::dvec3& origin, const PointShellSettings& settings = {});

  int Levels() const noexcept;                      ///< 0 without points
  std::uint32_t LevelEnd(int level) const noexcept; ///< points in levels 0 to `level`, no padding
  /// What `level` adds, padded; the area of a point is that of this level being the last.
  ContactPoints Level(int level) const noexcept;
  std::span<const PointCluster> Clusters(int level) const noexcept; ///< of Level(level)'s points
  double SurfaceArea() const noexcept;                              ///< mm^2
  float Radius() const noexcept; ///< of the ball around the origin that holds all points, mm
  void ListResources(ResourceList& list) const;

private:
  struct Internals;
  explicit PointShell(std::unique_ptr<Internals> made);
  std::unique_ptr<Internals> Inside;

public:
  ~PointShell();
};

} // namespace hasp
