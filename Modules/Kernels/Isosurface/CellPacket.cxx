#include "Isosurface/CellPacket.h"
#include "Isosurface/RayRoot.h"

#include <algorithm>
#include <bit>

namespace hasp
{

void PacketRays::Set(int n, const CellRay& ray)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->origin[axis][n] = ray.origin[axis];
    this->direction[axis][n] = ray.direction[axis];
  }
  this->tMin[n] = ray.tMin;
  this->tMax[n] = ray.tMax;
}

CellRay PacketRays::operator[](int n) const
{
  return { { this->origin[0][n], this->origin[1][n], this->origin[2][n] },
    { this->direction[0][n], this->direction[1][n], this->direction[2][n] }, this->tMin[n],
    this->tMax[n] };
}

CellWalkRay CellPacket::Ray(int n) const
{
  CellWalkRay ray;
  const auto three = [&](const auto& values) {
    return decltype(ray.origin){ values[0][n], values[1][n], values[2][n], 0.0 };
  };
  ray.origin = three(this->origin);
  ray.direction = three(this->direction);
  ray.inverse = three(this->inverse);
  ray.inverse[3] = this->end[n];
  ray.FinishDirection();
  ray.fromSurface = this->fromSurface >> n & 1U;
  ray.startInside = this->startInside >> n & 1U;
  ray.t = this->t[n];
  ray.cluster = static_cast<std::uint32_t>(this->cluster[n]);
  return ray;
}

void CellPacket::SetRay(int n, const CellWalkRay& ray)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->origin[axis][n] = ray.origin[axis];
    this->direction[axis][n] = ray.direction[axis];
    this->inverse[axis][n] = ray.inverse[axis];
    this->directionF[axis][n] = ray.directionF[axis];
    this->inverseF[axis][n] = ray.inverseF[axis];
    this->delta[axis][n] = ray.delta[axis];
  }
  this->end[n] = ray.End();
  const Rays bit = 1U << n;
  this->fromSurface = ray.fromSurface ? this->fromSurface | bit : this->fromSurface & ~bit;
  this->startInside = ray.startInside ? this->startInside | bit : this->startInside & ~bit;
  this->SetHit(n, ray);
}

void CellPacket::SetHit(int n, const CellWalkRay& ray)
{
  this->t[n] = ray.t;
  this->cluster[n] = static_cast<std::int32_t>(ray.cluster);
  this->place[n] = static_cast<std::int32_t>(ray.place);
  for (int c = 0; c < 4; ++c)
  {
    this->corners[c][n] = ray.low[c];
    this->corners[c + 4][n] = ray.high[c];
  }
  for (int axis = 0; axis < 3; ++axis)
    this->local[axis][n] = ray.local[axis];
}

namespace singly
{

CellPacket::Rays Pixels(const PictureRays& picture, const glm::ivec2& from, PacketRays& rays)
{
  CellPacket::Rays some = 0;
  for (int n = 0; n < CellPacket::Size; ++n)
  {
    const glm::ivec2 at = from + glm::ivec2(n % CellPacket::Side, n / CellPacket::Side);
    CellRay ray;
    some |= CellPacket::Rays(picture.Of(glm::dvec2(at) + 0.5, ray)) << n;
    rays.Set(n, ray);
  }
  return some;
}

CellPacket::Rays Begin(
  const PacketRays& rays, CellPacket::Rays which, const glm::ivec3& cells, CellPacket& packet)
{
  CellPacket::Rays meet = 0;
  for (; which != 0; which &= which - 1)
  {
    const int n = std::countr_zero(which);
    CellWalkRay ray;
    CellWalkEntry entry;
    if (!BeginWalk(rays[n], cells, ray, entry))
      continue;
    packet.SetRay(n, ray);
    meet |= 1U << n;
  }
  return meet;
}

CellPacket::Rays Walk(
  const CellStore& store, std::uint32_t n, CellPacket::Rays rays, CellPacket& packet)
{
  CellPacket::Rays nearer = 0;
  for (; rays != 0; rays &= rays - 1)
  {
    const int lane = std::countr_zero(rays);
    CellWalkRay ray = packet.Ray(lane);
    if (!store.walk(store, n, ray))
      continue;
    packet.SetHit(lane, ray);
    nearer |= 1U << lane;
  }
  return nearer;
}

void End(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  const auto four = [&](int first, int n)
  {
    const auto& c = packet.corners;
    return glm::vec4(c[first][n], c[first + 1][n], c[first + 2][n], c[first + 3][n]);
  };
  for (int n = 0; n < CellPacket::Size; ++n)
  {
    glm::vec3 local(0.0F);
    glm::vec4 gradient(0.0F, 0.0F, 0.0F, TracedPicture::NoDepth);
    if (hits >> n & 1U)
    {
      local = { packet.local[0][n], packet.local[1][n], packet.local[2][n] };
      const glm::ivec3 cell =
        CellAt(store.clusters[packet.cluster[n]], static_cast<std::uint32_t>(packet.place[n]));
      const glm::dvec4 clip = indexToClip * glm::dvec4(glm::dvec3(cell) + glm::dvec3(local), 1.0);
      gradient = { glsl::HaspTrilinearGradient(four(0, n), four(4, n), local),
        static_cast<float>(std::clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0)) };
    }
    pixels.places[n] = local;
    pixels.gradients[n] = gradient;
  }
  NameCells(store, packet, hits, pixels);
}

} // namespace singly

void NameCells(
  const CellStore& store, const CellPacket& packet, CellPacket::Rays hits, CellPixels& pixels)
{
  for (int n = 0; n < CellPacket::Size; ++n)
  {
    pixels.cells[n] = TracedPicture::Nothing;
    pixels.corners[n] = glm::ivec3(0);
    if ((hits >> n & 1U) == 0)
      continue;
    const CellCluster& cluster = store.clusters[packet.cluster[n]];
    const auto place = static_cast<std::uint32_t>(packet.place[n]);
    pixels.cells[n] = CellNumber(cluster, place);
    pixels.corners[n] = CellAt(cluster, place);
  }
}

#if !HASP_WITH_HIGHWAY
CellPacket::Rays PixelsOfPacket(
  const PictureRays& picture, const glm::ivec2& from, PacketRays& rays)
{
  return singly::Pixels(picture, from, rays);
}

CellPacket::Rays BeginCellPacket(
  const PacketRays& rays, const glm::ivec3& cells, CellPacket& packet)
{
  packet.fromSurface = packet.startInside = 0;
  return singly::Begin(rays, CellPacket::All, cells, packet);
}

CellPacketWalk ChooseCellPacketWalk(CornerType, CellPrecision)
{
  return &singly::Walk;
}

void EndCellPacket(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  singly::End(store, packet, hits, indexToClip, pixels);
}
#endif

} // namespace hasp
