#include "Isosurface/CellPacket.h"

namespace hasp
{

CellWalkRay CellPacket::Ray(int n) const
{
  CellWalkRay ray;
  const auto three = [&](const auto& values) { return decltype(ray.origin){ values[0][n], values[1][n], values[2][n], 0.0 }; };
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

} // namespace hasp
