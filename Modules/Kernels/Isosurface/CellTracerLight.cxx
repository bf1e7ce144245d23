#include "Isosurface/CellTracer.h"
#include "Isosurface/CellTracerScene.h"
#include "Isosurface/EvenPoints.h"
#include "Isosurface/Hemisphere.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

/// Towards a world direction.
CellRay RayFrom(
  const CellHit& hit, const glm::dmat3& toIndex, const glm::dvec3& direction, double distanceMm)
{
  return { hit.Position(), toIndex * direction, 0.0, distanceMm };
}

void Require(bool condition, const char* what, double value, const char* range)
{
  if (!condition)
    throw std::invalid_argument(
      std::string("CellTracer: ") + what + " " + std::to_string(value) + " must be " + range);
}

} // namespace

glm::dvec3 CellTracer::Outwards(const CellHit& hit) const
{
  const glm::dvec3 scaled =
    glm::dvec3(hit.gradient) /
    std::max({ std::abs(double(hit.gradient.x)), std::abs(double(hit.gradient.y)),
      std::abs(double(hit.gradient.z)), 1e-300 });
  const glm::dvec3 inwards = this->Cells().geometry.GradientToWorld(scaled);
  const double length = glm::length(inwards);
  return length > 0.0 ? (hit.fromInside ? inwards : -inwards) / length : glm::dvec3(0.0);
}

bool CellTracer::OccludedFrom(
  const CellHit& hit, const glm::dvec3& direction, double distance) const
{
  CellWalkRay walk;
  CellWalkEntry entry;
  if (!this->Embree->Enter(
        RayFrom(hit, this->Embree->DirectionToIndex(), direction, distance), walk, entry))
    return false;
  walk.fromSurface = true;
  walk.startInside = hit.fromInside;
  return this->Embree->Any(walk);
}

std::optional<CellHit> CellTracer::TraceFrom(
  const CellHit& hit, const glm::dvec3& direction, double distance) const
{
  CellWalkRay walk;
  CellWalkEntry entry;
  if (!this->Embree->Enter(
        RayFrom(hit, this->Embree->DirectionToIndex(), direction, distance), walk, entry))
    return std::nullopt;
  walk.fromSurface = true;
  walk.startInside = hit.fromInside;
  this->Embree->Nearest(walk);
  if (!walk.Hit())
    return std::nullopt;
  return this->Embree->HitOf(walk, entry);
}

float CellTracer::AmbientOcclusion(
  const CellHit& hit, const AmbientOcclusionSettings& settings, std::uint32_t seed) const
{
  Require(settings.rays >= 1, "rays", settings.rays, "at least 1");
  Require(settings.distanceMm > 0.0, "distance", settings.distanceMm, "above 0 mm");
  const glm::dmat3 frame = FrameAround(this->Outwards(hit));
  EvenPoints points(seed);
  int open = 0;
  for (int n = 0; n < settings.rays; ++n)
    open += !this->OccludedFrom(hit, frame * CosineWeighted(points.Next()), settings.distanceMm);
  return static_cast<float>(open) / static_cast<float>(settings.rays);
}

bool CellTracer::Open(const CellHit& hit, const glm::dvec2& sample, double distanceMm) const
{
  const glm::dmat3 frame = FrameAround(this->Outwards(hit));
  return !this->OccludedFrom(hit, frame * CosineWeighted(sample), distanceMm);
}

float CellTracer::Light(
  const CellHit& hit, const ShadowSettings& settings, std::uint32_t seed) const
{
  const double length = glm::length(settings.towardsLight);
  Require(
    length > 0.0 && std::isfinite(length), "length of towardsLight", length, "above 0, finite");
  Require(settings.rays >= 1, "rays", settings.rays, "at least 1");
  Require(settings.distanceMm > 0.0, "distance", settings.distanceMm, "above 0 mm");
  Require(settings.halfAngle >= 0.0 && settings.halfAngle <= glm::half_pi<double>(), "half angle",
    settings.halfAngle, "in [0, pi/2]");
  const glm::dvec3 towards = settings.towardsLight / length;
  const glm::dvec3 outwards = this->Outwards(hit);
  const auto reaches = [&](const glm::dvec3& d)
  { return glm::dot(d, outwards) > 0.0 && !this->OccludedFrom(hit, d, settings.distanceMm); };
  if (settings.halfAngle == 0.0)
    return reaches(towards) ? 1.0F : 0.0F;

  const glm::dmat3 frame = FrameAround(towards);
  const double cap = 1.0 - std::cos(settings.halfAngle); // even over the cap of the sphere
  EvenPoints points(seed);
  int lit = 0;
  for (int n = 0; n < settings.rays; ++n)
  {
    const glm::dvec2 p = points.Next();
    const double turn = glm::two_pi<double>() * p.x, z = 1.0 - cap * p.y,
                 r = std::sqrt(1.0 - z * z);
    lit += reaches(frame * glm::dvec3(r * std::cos(turn), r * std::sin(turn), z));
  }
  return static_cast<float>(lit) / static_cast<float>(settings.rays);
}

std::uint32_t CellTracer::Sees(std::span<const CellHit> hits, const glm::dvec4& light) const
{
  static_assert(PacketSize == CellPacket::Size);
  Require(hits.size() <= PacketSize, "number of hits", double(hits.size()), "at most 16");
  const double size = glm::length(light);
  Require(size > 0.0 && std::isfinite(size), "length of the light's direction or place", size,
    "above 0, finite");
  const GridGeometry& g = this->Cells().geometry;
  PacketRays rays{};
  CellPacket::Rays seen = 0, cast = 0, inside = 0;
  for (std::size_t n = 0; n < hits.size(); ++n)
  {
    const CellHit& hit = hits[n];
    glm::dvec3 way(light);
    double distance = std::numeric_limits<double>::infinity(), length = glm::length(way);
    if (light.w != 0.0)
    {
      way -= g.IndexToWorld(hit.Position());
      distance = length = glm::length(way);
    }
    const CellPacket::Rays bit = 1U << n;
    if (length == 0.0) // the light lies on the surface
      seen |= bit;
    else if (way /= length; glm::dot(way, this->Outwards(hit)) > 0.0)
    {
      rays.Set(static_cast<int>(n), RayFrom(hit, this->Embree->DirectionToIndex(), way, distance));
      cast |= bit;
      inside |= hit.fromInside ? bit : 0U;
    }
  }
  if (cast == 0)
    return seen;
  CellPacket packet;
  const CellPacket::Rays entered = cast & this->Embree->Enter(rays, packet);
  packet.fromSurface = entered;
  packet.startInside = inside;
  return seen | (cast & ~this->Embree->Any(entered, packet));
}

} // namespace hasp
