#pragma once
#include "IsosurfaceMethods.h"
#include "WorldRay.h"

#include <span>
#include <string>

namespace hasp
{

struct CellScene;

/// Clustered cells and their tracer (Kernels/Isosurface/CellTracer.h) for rays in world
/// coordinates. Needs Embree. Traces on all cores.
class CellRays
{
public:
  CellRays(const CellScene& scene, bool compact = false);
  ~CellRays();

  /// Into the tracer's own coordinates: not part of a time.
  void SetRays(std::span<const WorldRay> rays);
  /// The rays that were set, one call a ray.
  void Trace();
  /// What Trace met, world mm.
  SurfacePoints Points() const;

  std::size_t CellBytes() const;
  std::size_t TreeBytes() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
