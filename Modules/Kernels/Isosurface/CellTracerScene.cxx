#include "Isosurface/CellTracerScene.h"
#include "Isosurface/RayRoot.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The box around the active cells of a cluster.
CellBox BoxOf(const CellCluster& cluster, std::uint32_t number)
{
  std::uint64_t plane = 0; // of all slices
  glm::ivec3 low(8), high(-1);
  for (int z = 0; z < 8; ++z)
    if (const std::uint64_t cells = cluster.active[z])
    {
      plane |= cells;
      low.z = std::min(low.z, z);
      high.z = z;
    }
  std::uint64_t columns = plane | plane >> 32U;
  columns |= columns >> 16U;
  columns = (columns | columns >> 8U) & 0xFFU;
  low.x = std::countr_zero(columns);
  high.x = static_cast<int>(std::bit_width(columns)) - 1;
  low.y = std::countr_zero(plane) / 8;
  high.y = (static_cast<int>(std::bit_width(plane)) - 1) / 8;
  return { cluster.Origin() + low, cluster.Origin() + high, number };
}

void Require(bool condition, const std::string& what)
{
  if (!condition)
    throw std::invalid_argument("CellTracer: " + what);
}

} // namespace

struct CellTracer::Scene::Rays
{
  RTCIntersectContext context; // first: Embree hands its address back
  CellWalkRay* single = nullptr;
  CellPacket* packet = nullptr;

  explicit Rays(CellWalkRay& ray) : single(&ray)
  {
    this->Begin(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  }
  explicit Rays(CellPacket& rays) : packet(&rays)
  {
    this->Begin(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  }

  static const Rays& Of(const RTCIntersectContext* context)
  {
    return *reinterpret_cast<const Rays*>(context);
  }

private:
  void Begin(RTCIntersectContextFlags flags)
  {
    rtcInitIntersectContext(&this->context);
    this->context.flags = flags;
  }
};

CellTracer::Scene::Scene(std::shared_ptr<const ClusteredCells> cells, const std::string& device)
  : Shared(std::move(cells))
{
  Require(this->Shared != nullptr, "there are no cells");
  const ClusteredCells& c = *this->Shared;
  c.geometry.Validate();
  const glm::ivec3 last = this->CellCounts = c.geometry.Cells();
  this->ToIndex = glm::transpose(c.geometry.direction);
  for (int axis = 0; axis < 3; ++axis)
    this->ToIndex[axis] /= c.geometry.spacing;
  Require(c.levels.size() == (c.precision == CellPrecision::Compact ? 128 : 0),
    "the cells have " + std::to_string(c.levels.size()) +
      " levels; compact ones have 128 and exact ones none");
  this->Boxes.reserve(c.clusters.size());
  for (std::size_t n = 0; n < c.clusters.size(); ++n)
  {
    const CellCluster& cluster = c.clusters[n];
    const std::size_t bits = static_cast<std::size_t>(cluster.CornerCount()) * cluster.Width();
    Require(cluster.CellCount() > 0, "cluster " + std::to_string(n) + " has no cells");
    Require(cluster.firstWord + (bits + 31) / 32 + 2 <= c.corners.size(),
      "cluster " + std::to_string(n) + " has corners beyond the stream of " +
        std::to_string(c.corners.size()) + " words");
    this->Boxes.push_back(BoxOf(cluster, static_cast<std::uint32_t>(n)));
  }
  for (const CellBox& box : this->Boxes)
    Require(glm::all(glm::lessThan(box.High(), last)),
      "cluster " + std::to_string(box.cluster) + " reaches beyond the volume");

  this->Store = { ChooseCellWalk(c.cornerType, c.precision), c.clusters.data(), c.corners.data(),
    this->Boxes.data(), c.isovalue, {} };
  if (c.precision == CellPrecision::Compact)
    for (int code = 0; code < 256; ++code)
      this->Store.levels.push_back(code & 128 ? -c.levels[code & 127] : c.levels[code & 127]);
  this->WalkPacket = ChooseCellPacketWalk(c.cornerType, c.precision);
  this->Margin = 1e-6F * static_cast<float>(std::max({ 64, last.x, last.y, last.z }));

  this->Device = rtcNewDevice(device.empty() ? nullptr : device.c_str());
  if (this->Device == nullptr)
    throw std::runtime_error(
      "CellTracer: Embree gives no device, error " + std::to_string(rtcGetDeviceError(nullptr)));
  rtcSetDeviceMemoryMonitorFunction(this->Device, &Scene::CountMemory, this);
  this->Build();
}

CellTracer::Scene::~Scene()
{
  rtcReleaseScene(this->Tree);
  rtcReleaseDevice(this->Device);
}

void CellTracer::Scene::Build()
{
  this->Tree = rtcNewScene(this->Device);
  rtcSetSceneFlags(this->Tree, RTC_SCENE_FLAG_NONE);
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(this->Boxes.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, &Scene::Bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, &Scene::Intersect);
  rtcSetGeometryOccludedFunction(geometry, &Scene::Occlude);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Tree, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(this->Tree);
  if (const RTCError error = rtcGetDeviceError(this->Device); error != RTC_ERROR_NONE)
  {
    rtcReleaseScene(this->Tree);
    rtcReleaseDevice(this->Device);
    throw std::runtime_error("CellTracer: Embree could not build its tree over " +
                             std::to_string(this->Boxes.size()) + " boxes, error " +
                             std::to_string(error));
  }
}

bool CellTracer::Scene::CountMemory(void* scene, ssize_t bytes, bool)
{
  static_cast<Scene*>(scene)->DeviceBytes += bytes;
  return true;
}

std::size_t CellTracer::Scene::Bytes() const
{
  return static_cast<std::size_t>(this->DeviceBytes.load()) + this->Boxes.size() * sizeof(CellBox) +
         this->Store.levels.size() * sizeof(float);
}

void CellTracer::Scene::Bounds(const RTCBoundsFunctionArguments* arguments)
{
  const auto& scene = *static_cast<const Scene*>(arguments->geometryUserPtr);
  const CellBox& box = scene.Boxes[arguments->primID];
  const glm::vec3 low = glm::vec3(box.Low()) - scene.Margin;
  const glm::vec3 high = glm::vec3(box.High() + 1) + scene.Margin;
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = low.x;
  bounds.lower_y = low.y;
  bounds.lower_z = low.z;
  bounds.upper_x = high.x;
  bounds.upper_y = high.y;
  bounds.upper_z = high.z;
}

namespace
{

/// The rays of our packet that Embree asks for, and where each lies in its own: where the CPU has
/// no 16 lanes it makes packets of 8, 4 or 1 of them, in another order.
struct AskedRays
{
  CellPacket::Rays rays = 0;
  unsigned at[CellPacket::Size];

  AskedRays(RTCRayN* theirs, const int* valid, unsigned count)
  {
    for (unsigned n = 0; n < count; ++n)
      if (valid[n] != 0)
      {
        const unsigned id = RTCRayN_id(theirs, count, n);
        this->rays |= 1U << id;
        this->at[id] = n;
      }
  }
};

} // namespace

void CellTracer::Scene::Intersect(const RTCIntersectFunctionNArguments* arguments)
{
  const auto& scene = *static_cast<const Scene*>(arguments->geometryUserPtr);
  const Rays& ours = Rays::Of(arguments->context);
  const unsigned count = arguments->N, box = arguments->primID;
  const auto keep = [&](unsigned n, double t)
  {
    RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, count), count, n) = static_cast<float>(t);
    RTCHitN_geomID(RTCRayHitN_HitN(arguments->rayhit, count), count, n) = arguments->geomID;
  };
  if (ours.packet == nullptr)
  {
    if (scene.Store.walk(scene.Store, box, *ours.single))
      keep(0, ours.single->t);
    return;
  }
  const AskedRays asked(RTCRayHitN_RayN(arguments->rayhit, count), arguments->valid, count);
  for (auto nearer = scene.WalkPacket(scene.Store, box, asked.rays, *ours.packet); nearer != 0;
       nearer &= nearer - 1)
  {
    const int n = std::countr_zero(nearer);
    keep(asked.at[n], ours.packet->t[n]);
  }
}

void CellTracer::Scene::Occlude(const RTCOccludedFunctionNArguments* arguments)
{
  const auto& scene = *static_cast<const Scene*>(arguments->geometryUserPtr);
  const Rays& ours = Rays::Of(arguments->context);
  const unsigned count = arguments->N, box = arguments->primID;
  const auto block = [&](unsigned n)
  { RTCRayN_tfar(arguments->ray, count, n) = -std::numeric_limits<float>::infinity(); };
  if (ours.packet == nullptr)
  {
    if (scene.Store.walk(scene.Store, box, *ours.single))
      block(0);
    return;
  }
  const AskedRays asked(arguments->ray, arguments->valid, count);
  for (auto blocked = scene.WalkPacket(scene.Store, box, asked.rays, *ours.packet); blocked != 0;
       blocked &= blocked - 1)
    block(asked.at[std::countr_zero(blocked)]);
}

bool CellTracer::Scene::Enter(const CellRay& ray, CellWalkRay& walk, CellWalkEntry& entry) const
{
  return !this->Boxes.empty() && BeginWalk(ray, this->CellCounts, walk, entry);
}

namespace
{

template <typename Ray>
void SetRay(Ray& ray, const CellWalkRay& walk)
{
  ray.org_x = static_cast<float>(walk.origin[0]);
  ray.org_y = static_cast<float>(walk.origin[1]);
  ray.org_z = static_cast<float>(walk.origin[2]);
  ray.dir_x = walk.directionF[0];
  ray.dir_y = walk.directionF[1];
  ray.dir_z = walk.directionF[2];
  ray.tnear = 0.0F;
  ray.tfar = static_cast<float>(walk.End()) * 1.000001F;
  ray.time = 0.0F;
  ray.mask = ~0U;
  ray.id = 0;
  ray.flags = 0;
}

void SetRays(RTCRay16& ray, int* valid, CellPacket::Rays which, const CellPacket& packet)
{
  for (int n = 0; n < CellPacket::Size; ++n)
  {
    const bool on = which >> n & 1U;
    valid[n] = on ? -1 : 0;
    ray.org_x[n] = static_cast<float>(packet.origin[0][n]);
    ray.org_y[n] = static_cast<float>(packet.origin[1][n]);
    ray.org_z[n] = static_cast<float>(packet.origin[2][n]);
    ray.dir_x[n] = packet.directionF[0][n];
    ray.dir_y[n] = packet.directionF[1][n];
    ray.dir_z[n] = packet.directionF[2][n];
    ray.tnear[n] = 0.0F;
    ray.tfar[n] = on ? static_cast<float>(packet.end[n]) * 1.000001F
                     : -std::numeric_limits<float>::infinity(); // not all of Embree asks `valid`
    ray.time[n] = 0.0F;
    ray.mask[n] = ~0U;
    ray.id[n] = static_cast<unsigned>(n);
    ray.flags[n] = 0;
  }
}

} // namespace

void CellTracer::Scene::Nearest(CellWalkRay& walk) const
{
  Rays rays(walk);
  RTCRayHit ray;
  SetRay(ray.ray, walk);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(this->Tree, &rays.context, &ray);
}

bool CellTracer::Scene::Any(CellWalkRay& walk) const
{
  Rays rays(walk);
  RTCRay ray;
  SetRay(ray, walk);
  rtcOccluded1(this->Tree, &rays.context, &ray);
  return ray.tfar < 0.0F;
}

CellPacket::Rays CellTracer::Scene::Enter(const PacketRays& rays, CellPacket& packet) const
{
  return this->Boxes.empty() ? 0 : BeginCellPacket(rays, this->CellCounts, packet);
}

void CellTracer::Scene::Nearest(CellPacket::Rays which, CellPacket& packet) const
{
  Rays rays(packet);
  alignas(64) int valid[CellPacket::Size];
  RTCRayHit16 ray;
  SetRays(ray.ray, valid, which, packet);
  std::fill_n(ray.hit.geomID, CellPacket::Size, RTC_INVALID_GEOMETRY_ID);
  rtcIntersect16(valid, this->Tree, &rays.context, &ray);
}

CellPacket::Rays CellTracer::Scene::Any(CellPacket::Rays which, CellPacket& packet) const
{
  Rays rays(packet);
  alignas(64) int valid[CellPacket::Size];
  RTCRay16 ray;
  SetRays(ray, valid, which, packet);
  rtcOccluded16(valid, this->Tree, &rays.context, &ray);
  CellPacket::Rays met = 0;
  for (int n = 0; n < CellPacket::Size; ++n)
    met |= CellPacket::Rays(ray.tfar[n] < 0.0F) << n;
  return met & which;
}

void CellTracer::Scene::PixelsOf(const CellPacket& packet, CellPacket::Rays which,
  const glm::dmat4& indexToClip, CellPixels& pixels) const
{
  CellPacket::Rays hits = 0;
  for (int n = 0; n < CellPacket::Size; ++n)
    hits |= CellPacket::Rays(packet.t[n] < Infinity) << n;
  EndCellPacket(this->Store, packet, hits & which, indexToClip, pixels);
}

CellHit CellTracer::Scene::HitOf(const CellWalkRay& walk, const CellWalkEntry& entry) const
{
  const CellCluster& cluster = this->Shared->clusters[walk.cluster];
  CellHit hit{};
  hit.t = (entry.moved + walk.t) / entry.length;
  hit.number = CellNumber(cluster, walk.place);
  hit.cell = CellAt(cluster, walk.place);
  hit.local = { walk.local[0], walk.local[1], walk.local[2] };
  hit.gradient = glsl::HaspTrilinearGradient({ walk.low[0], walk.low[1], walk.low[2], walk.low[3] },
    { walk.high[0], walk.high[1], walk.high[2], walk.high[3] }, hit.local);
  const glm::vec3 direction(walk.directionF[0], walk.directionF[1], walk.directionF[2]);
  hit.fromInside = glm::dot(hit.gradient, direction) < 0.0F;
  return hit;
}

} // namespace hasp
