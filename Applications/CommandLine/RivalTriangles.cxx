#include "RivalTriangles.h"

#include "Grid/ParallelFor.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr std::int64_t Grain = 4096; // rays a task
constexpr float Infinity = std::numeric_limits<float>::infinity();

bool CountBytes(void* counter, ssize_t bytes, bool)
{
  *static_cast<std::atomic<ssize_t>*>(counter) += bytes;
  return true;
}

/// Buffers of the mesh that Embree shares and does not copy; one float more, for it reads 16 bytes.
struct Buffers
{
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;

  explicit Buffers(vtkPolyData* mesh)
  {
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      const double* x = mesh->GetPoint(p);
      this->positions.insert(this->positions.end(), { float(x[0]), float(x[1]), float(x[2]) });
    }
    this->positions.push_back(0.0F);
    vtkCellArray* triangles = mesh->GetPolys();
    for (vtkIdType n = 0; n < triangles->GetNumberOfCells(); ++n)
    {
      vtkIdType size;
      const vtkIdType* points;
      triangles->GetCellAtId(n, size, points);
      for (vtkIdType p = 0; p < 3; ++p)
        this->indices.push_back(std::uint32_t(points[p]));
    }
  }
  std::size_t Bytes() const { return 4 * (this->positions.size() - 1 + this->indices.size()); }
};

} // namespace

struct RivalTriangles::Internals
{
  explicit Internals(vtkPolyData* mesh) : buffers(mesh) {}
  ~Internals()
  {
    rtcReleaseScene(this->scene);
    rtcReleaseDevice(this->device);
  }

  Buffers buffers;
  std::atomic<ssize_t> bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

RivalTriangles::RivalTriangles(vtkPolyData* mesh) : Inside(std::make_unique<Internals>(mesh))
{
  Internals& in = *this->Inside;
  in.device = rtcNewDevice(nullptr);
  if (!in.device)
    throw std::runtime_error("Embree opens no device");
  rtcSetDeviceMemoryMonitorFunction(in.device, CountBytes, &in.bytes);
  const ssize_t before = in.bytes;
  in.scene = rtcNewScene(in.device);
  rtcSetSceneBuildQuality(in.scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = rtcNewGeometry(in.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
    in.buffers.positions.data(), 0, 12, in.buffers.positions.size() / 3);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
    in.buffers.indices.data(), 0, 12, in.buffers.indices.size() / 3);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(in.scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(in.scene);
  in.bytes -= before;
  if (rtcGetDeviceError(in.device) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the triangles' tree");
}

RivalTriangles::~RivalTriangles() = default;

std::string RivalTriangles::Name() const
{
  return "Embree " RTC_VERSION_STRING " triangles of vtkFlyingEdges3D's mesh, high build quality, "
         "robust flag off";
}

std::size_t RivalTriangles::TreeBytes() const
{
  return std::size_t(this->Inside->bytes.load());
}

std::size_t RivalTriangles::MeshBytes() const
{
  return this->Inside->buffers.Bytes();
}

namespace
{

RTCRay RayOf(const WorldRay& ray)
{
  RTCRay its{};
  its.org_x = float(ray.origin.x);
  its.org_y = float(ray.origin.y);
  its.org_z = float(ray.origin.z);
  its.dir_x = float(ray.direction.x);
  its.dir_y = float(ray.direction.y);
  its.dir_z = float(ray.direction.z);
  its.tfar = Infinity;
  its.mask = ~0U;
  return its;
}

void TraceOne(RTCScene scene, RTCIntersectContext* context, const WorldRay& ray, float& t)
{
  RTCRayHit hit{};
  hit.ray = RayOf(ray);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, context, &hit);
  t = hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? Infinity : hit.ray.tfar;
}

void TraceSixteen(
  RTCScene scene, RTCIntersectContext* context, std::span<const WorldRay> rays, float* t)
{
  alignas(64) RTCRayHit16 hits{};
  alignas(64) int valid[16];
  for (std::size_t n = 0; n < 16; ++n)
  {
    const WorldRay& ray = rays[std::min(n, rays.size() - 1)];
    valid[n] = n < rays.size() ? -1 : 0;
    hits.ray.org_x[n] = float(ray.origin.x);
    hits.ray.org_y[n] = float(ray.origin.y);
    hits.ray.org_z[n] = float(ray.origin.z);
    hits.ray.dir_x[n] = float(ray.direction.x);
    hits.ray.dir_y[n] = float(ray.direction.y);
    hits.ray.dir_z[n] = float(ray.direction.z);
    hits.ray.tfar[n] = Infinity;
    hits.ray.mask[n] = ~0U;
    hits.hit.geomID[n] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid, scene, context, &hits);
  for (std::size_t n = 0; n < rays.size(); ++n)
    t[n] = hits.hit.geomID[n] == RTC_INVALID_GEOMETRY_ID ? Infinity : hits.ray.tfar[n];
}

} // namespace

void RivalTriangles::Trace(
  std::span<const WorldRay> rays, std::span<float> t, Packets packets) const
{
  RTCScene scene = this->Inside->scene;
  ParallelFor(0, std::int64_t(rays.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = packets == Packets::Coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                   : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
      if (packets == Packets::One)
        for (std::int64_t n = first; n < last; ++n)
          TraceOne(scene, &context, rays[n], t[n]);
      else
        for (std::int64_t n = first; n < last; n += 16)
          TraceSixteen(
            scene, &context, rays.subspan(n, std::min<std::int64_t>(16, last - n)), &t[n]);
    });
}

void RivalTriangles::Occluded(std::span<const WorldRay> rays, std::span<float> t) const
{
  RTCScene scene = this->Inside->scene;
  ParallelFor(0, std::int64_t(rays.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
      for (std::int64_t n = first; n < last; ++n)
      {
        RTCRay ray = RayOf(rays[n]);
        rtcOccluded1(scene, &context, &ray);
        t[n] = ray.tfar < 0.0F ? 0.0F : Infinity; // Embree says so by -inf
      }
    });
}

} // namespace hasp
