#pragma once
// Private to CellTracer: Embree's side of it.
#include "Isosurface/CellPacket.h"

#include <embree3/rtcore.h>

#include <atomic>

namespace hasp
{

/// Embree's device and scene over the boxes of the cells.
class CellTracer::Scene
{
public:
  Scene(std::shared_ptr<const ClusteredCells> cells, const std::string& device);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const ClusteredCells& Cells() const { return *this->Shared; }
  std::size_t Bytes() const;
  const glm::dmat3& DirectionToIndex() const { return this->ToIndex; } ///< from the world's, mm

  /// BeginWalk, and false if there are no cells.
  bool Enter(const CellRay& ray, CellWalkRay& walk, CellWalkEntry& entry) const;

  void Nearest(CellWalkRay& walk) const;
  bool Any(CellWalkRay& walk) const;

  /// The same for rays that lie close together: those that can hit anything, and their hits.
  CellPacket::Rays Enter(const PacketRays& rays, CellPacket& packet) const;
  void Nearest(CellPacket::Rays which, CellPacket& packet) const;
  CellPacket::Rays Any(CellPacket::Rays which, CellPacket& packet) const; ///< those that hit
  void PixelsOf(const CellPacket& packet, CellPacket::Rays which, const glm::dmat4& indexToClip,
    CellPixels& pixels) const;

  CellHit HitOf(const CellWalkRay& walk, const CellWalkEntry& entry) const;

private:
  struct Rays; // what Embree's calls carry to ours
  static void Bounds(const RTCBoundsFunctionArguments* arguments);
  static void Intersect(const RTCIntersectFunctionNArguments* arguments);
  static void Occlude(const RTCOccludedFunctionNArguments* arguments);
  static bool CountMemory(void* scene, ssize_t bytes, bool post);
  void Build();

  std::shared_ptr<const ClusteredCells> Shared;
  std::vector<CellBox> Boxes;
  glm::ivec3 CellCounts{ 0 }; ///< of the volume
  glm::dmat3 ToIndex;
  CellStore Store;
  CellPacketWalk WalkPacket;
  float Margin; ///< voxels by which Embree's boxes are larger: what float may round off
  std::atomic<std::int64_t> DeviceBytes{ 0 };
  RTCDevice Device = nullptr;
  RTCScene Tree = nullptr;
};

} // namespace hasp
