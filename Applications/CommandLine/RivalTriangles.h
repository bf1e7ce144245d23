#pragma once
#include "WorldRay.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

class vtkPolyData;

namespace hasp
{

/// Embree's own triangles, static scene, high build quality, robust flag off: the rival of the
/// cells' tracer. RENDER thread; traces on all cores.
class RivalTriangles
{
public:
  enum class Packets
  {
    One,      ///< rtcIntersect1
    Coherent, ///< rtcIntersect16 with the flag for coherent rays
    Incoherent
  };

  explicit RivalTriangles(vtkPolyData* mesh);
  ~RivalTriangles();

  std::string Name() const;
  /// The way to the first triangle of each ray, infinite where there is none.
  void Trace(std::span<const WorldRay> rays, std::span<float> t, Packets packets) const;
  /// Infinite where a ray meets nothing, else anything less: rtcOccluded1.
  void Occluded(std::span<const WorldRay> rays, std::span<float> t) const;
  /// What Embree holds, as its own monitor counts, and the mesh it is given: float positions,
  /// 32-bit indices.
  std::size_t TreeBytes() const;
  std::size_t MeshBytes() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
