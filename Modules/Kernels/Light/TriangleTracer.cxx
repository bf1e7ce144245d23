#include "Light/TriangleTracer.h"

#include <embree3/rtcore.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

void Check(const LitMesh& given)
{
  const TriangleMesh& mesh = given.mesh;
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    if (!std::isfinite(mesh.points[n].x + mesh.points[n].y + mesh.points[n].z))
      throw std::invalid_argument(
        "TriangleTracer: point " + std::to_string(n) + " is not finite; leave its triangles out");
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n)
    for (int c = 0; c < 3; ++c)
      if (mesh.triangles[n][c] >= mesh.points.size())
        throw std::invalid_argument("TriangleTracer: triangle " + std::to_string(n) +
                                    " names point " + std::to_string(mesh.triangles[n][c]) +
                                    " of " + std::to_string(mesh.points.size()));
  for (const auto* values : { &given.normals, &given.colors })
    if (!values->empty() && values->size() != mesh.points.size())
      throw std::invalid_argument("TriangleTracer: " + std::to_string(values->size()) +
                                  " normals or colours for " + std::to_string(mesh.points.size()) +
                                  " points");
}

} // namespace

/// Embree's device and scene.
class TriangleTracer::Tree
{
public:
  Tree(const TriangleMesh& mesh, const glm::dvec3& middle)
  {
    this->Device = rtcNewDevice(nullptr);
    if (!this->Device)
      throw std::runtime_error(
        "Embree makes no device: error " + std::to_string(rtcGetDeviceError(nullptr)));
    rtcSetDeviceMemoryMonitorFunction(
      this->Device,
      [](void* tree, ssize_t bytes, bool)
      {
        static_cast<Tree*>(tree)->DeviceBytes += bytes;
        return true;
      },
      this);
    this->Scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.points.size()));
    auto* corners =
      static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
        RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (points && corners)
    {
      for (const glm::dvec3& point : mesh.points)
        for (int a = 0; a < 3; ++a)
          *points++ = static_cast<float>(point[a] - middle[a]);
      for (const glm::uvec3& triangle : mesh.triangles)
        for (int c = 0; c < 3; ++c)
          *corners++ = triangle[c];
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(this->Scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
    if (const RTCError error = rtcGetDeviceError(this->Device); error != RTC_ERROR_NONE)
    {
      this->Release();
      throw std::runtime_error("Embree makes no tree of " + std::to_string(mesh.triangles.size()) +
                               " triangles: error " + std::to_string(error));
    }
  }
  ~Tree() { this->Release(); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  std::size_t Bytes() const { return static_cast<std::size_t>(this->DeviceBytes.load()); }
  RTCScene Of() const { return this->Scene; }

private:
  void Release()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  std::atomic<std::int64_t> DeviceBytes{ 0 };
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
};

TriangleTracer::TriangleTracer(LitMesh mesh)
  : Given(std::move(mesh)),
    LowCorner(Infinity),
    HighCorner(-Infinity)
{
  Check(this->Given);
  for (const glm::uvec3& triangle : this->Given.mesh.triangles)
    for (int c = 0; c < 3; ++c)
    {
      this->LowCorner = glm::min(this->LowCorner, this->Given.mesh.points[triangle[c]]);
      this->HighCorner = glm::max(this->HighCorner, this->Given.mesh.points[triangle[c]]);
    }
  if (this->Given.mesh.triangles.empty())
    return;
  this->Middle = 0.5 * (this->LowCorner + this->HighCorner);
  this->StartClearance = 1e-6 * glm::length(this->HighCorner - this->LowCorner);
  this->Embree = std::make_unique<const Tree>(this->Given.mesh, this->Middle);
}

TriangleTracer::~TriangleTracer() = default;

std::size_t TriangleTracer::Bytes() const
{
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  return (this->Embree ? this->Embree->Bytes() : 0) + bytes(this->Given.mesh.points) +
         bytes(this->Given.mesh.triangles) + bytes(this->Given.normals) + bytes(this->Given.colors);
}

namespace
{

/// A ray from where it enters a box, in Embree's words; t of ours is moved + t of its.
bool Enter(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& middle,
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax, double& moved,
  RTCRay& ray)
{
  double from = tMin, to = tMax;
  const double margin = 1e-5 * glm::length(high - low);
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] == 0.0)
    {
      if (origin[a] < low[a] - margin || origin[a] > high[a] + margin)
        return false;
      continue;
    }
    const double u = (low[a] - margin - origin[a]) / direction[a],
                 v = (high[a] + margin - origin[a]) / direction[a];
    from = std::max(from, std::min(u, v));
    to = std::min(to, std::max(u, v));
  }
  if (!(from <= to) || !std::isfinite(from))
    return false;
  moved = from;
  const glm::vec3 at(origin + from * direction - middle), along(direction);
  if (!std::isfinite(at.x + at.y + at.z + along.x + along.y + along.z))
    return false;
  ray = { at.x, at.y, at.z, 0.0F, along.x, along.y, along.z, 0.0F, static_cast<float>(to - from),
    0xFFFFFFFFU, 0, 0 };
  return true;
}

} // namespace

std::optional<TriangleHit> TriangleTracer::Trace(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const
{
  RTCRayHit ray;
  double moved = 0.0;
  if (!this->Embree || !Enter(this->LowCorner, this->HighCorner, this->Middle, origin, direction,
                         tMin, tMax, moved, ray.ray))
    return std::nullopt;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(this->Embree->Of(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return std::nullopt;
  TriangleHit hit{ moved + double(ray.ray.tfar), ray.hit.primID, { ray.hit.u, ray.hit.v } };
  // Embree's t is a float's; the plane of the triangle says it to the last digits.
  const glm::dvec3 normal = this->Normal(hit.triangle);
  const double along = glm::dot(direction, normal);
  if (std::abs(along) > 1e-3 * glm::length(direction))
    hit.t = glm::dot(this->Given.mesh.points[this->Given.mesh.triangles[hit.triangle].x] - origin,
              normal) /
            along;
  return hit;
}

bool TriangleTracer::Occluded(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const
{
  RTCRay ray;
  double moved = 0.0;
  if (!this->Embree || !Enter(this->LowCorner, this->HighCorner, this->Middle, origin, direction,
                         tMin, tMax, moved, ray))
    return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(this->Embree->Of(), &context, &ray);
  return ray.tfar < 0.0F;
}

glm::dvec3 TriangleTracer::Normal(std::uint32_t triangle) const
{
  const glm::uvec3& corners = this->Given.mesh.triangles[triangle];
  const auto& points = this->Given.mesh.points;
  const glm::dvec3 across =
    glm::cross(points[corners.y] - points[corners.x], points[corners.z] - points[corners.x]);
  const double length = glm::length(across);
  return length > 0.0 ? across / length : glm::dvec3(0.0);
}

glm::dvec3 TriangleTracer::ShadingNormal(const TriangleHit& hit) const
{
  if (this->Given.normals.empty())
    return this->Normal(hit.triangle);
  const glm::uvec3& corners = this->Given.mesh.triangles[hit.triangle];
  const glm::dvec3 normal =
    glm::dvec3(this->Given.normals[corners.x]) * (1.0 - double(hit.at.x) - double(hit.at.y)) +
    glm::dvec3(this->Given.normals[corners.y]) * double(hit.at.x) +
    glm::dvec3(this->Given.normals[corners.z]) * double(hit.at.y);
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : this->Normal(hit.triangle);
}

std::optional<glm::vec3> TriangleTracer::Color(const TriangleHit& hit) const
{
  if (this->Given.colors.empty())
    return std::nullopt;
  const glm::uvec3& corners = this->Given.mesh.triangles[hit.triangle];
  return this->Given.colors[corners.x] * (1.0F - hit.at.x - hit.at.y) +
         this->Given.colors[corners.y] * hit.at.x + this->Given.colors[corners.z] * hit.at.y;
}

} // namespace hasp
