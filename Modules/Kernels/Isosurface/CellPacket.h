#pragma once
// Private to CellTracer: rays that walk together, one a lane.
#include "Isosurface/CellWalk.h"

namespace hasp
{

/// The CellRays of a packet, [axis][ray].
struct alignas(64) PacketRays
{
  static constexpr int Size = 16;
  double origin[3][Size], direction[3][Size], tMin[Size], tMax[Size];

  void Set(int n, const CellRay& ray);
  CellRay operator[](int n) const;
};

/// Rays on their way: CellWalkRay's numbers, [axis][ray]. What has no ray is left undefined.
struct alignas(64) CellPacket
{
  static constexpr int Size = PacketRays::Size;
  static constexpr int Side = 4; ///< of one of a picture, pixels
  using Rays = std::uint32_t;    ///< a bit a ray
  static constexpr Rays All = (1U << Size) - 1U;

  double origin[3][Size], direction[3][Size], inverse[3][Size], end[Size];
  float directionF[3][Size], inverseF[3][Size];
  std::int32_t delta[3][Size];

  double t[Size]; ///< of the nearest hits
  std::int32_t cluster[Size], place[Size];
  float corners[8][Size], local[3][Size];

  Rays fromSurface, startInside;

  /// One of them, to walk by itself.
  CellWalkRay Ray(int n) const;
  void SetRay(int n, const CellWalkRay& ray); ///< all of it
  void SetHit(int n, const CellWalkRay& ray); ///< its nearest hit
};

/// A packet's part of a TracedPicture.
struct alignas(64) CellPixels
{
  glm::vec4 gradients[CellPacket::Size];
  glm::vec3 places[CellPacket::Size];
  std::uint32_t cells[CellPacket::Size];
  glm::ivec3 corners[CellPacket::Size];
};

/// The rays of the pixels from `from` on, Side a row; which of them the picture's planes leave.
CellPacket::Rays PixelsOfPacket(
  const PictureRays& picture, const glm::ivec2& from, PacketRays& rays);

/// BeginWalk for the rays of a packet; which of them meet the volume.
CellPacket::Rays BeginCellPacket(
  const PacketRays& rays, const glm::ivec3& cells, CellPacket& packet);

/// CellWalk for the rays given; which of them it was nearer for.
using CellPacketWalk = CellPacket::Rays (*)(
  const CellStore& store, std::uint32_t n, CellPacket::Rays rays, CellPacket& packet);
CellPacketWalk ChooseCellPacketWalk(CornerType type, CellPrecision precision);

/// Those given have a nearest hit, the others nothing.
void EndCellPacket(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels);

/// The numbers and places of the cells hit.
void NameCells(
  const CellStore& store, const CellPacket& packet, CellPacket::Rays hits, CellPixels& pixels);

/// What the functions above do side by side, in the CPU's widest instructions: one ray after the
/// other, with the same results bit for bit. Where the CPU has none, they do this themselves.
namespace singly
{
CellPacket::Rays Pixels(const PictureRays& picture, const glm::ivec2& from, PacketRays& rays);
CellPacket::Rays Begin(
  const PacketRays& rays, CellPacket::Rays which, const glm::ivec3& cells, CellPacket& packet);
CellPacket::Rays Walk(
  const CellStore& store, std::uint32_t n, CellPacket::Rays rays, CellPacket& packet);
void End(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels);
} // namespace singly

} // namespace hasp
