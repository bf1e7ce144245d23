#include "Distance/LevelSet.h"

#include "MeshChecks.h"
#include "SolidChecks.h"

#include <openvdb/tools/MeshToVolume.h>

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>

namespace hasp
{

namespace
{
constexpr double MostVoxels = 1 << 20; // from 0: 32-bit floats then tell eighths of a voxel

void Check(const TriangleMesh& mesh, double spacing, double bandVoxels)
{
  RequirePositive("level set", "spacing", spacing);
  if (!(bandVoxels >= 1.74 && bandVoxels <= 1000.0))
    throw std::invalid_argument(
      "level set: a band of " + SolidNumber(bandVoxels) + " voxels; it must be in [1.74, 1000]");
  if (mesh.triangles.empty())
    throw std::invalid_argument("level set: a mesh without triangles; give a closed one");
  RequireClosedMesh("level set", mesh);
  for (const glm::dvec3& p : mesh.points)
    if (const glm::dvec3 away = glm::abs(p) / spacing;
        std::max({ away.x, away.y, away.z }) > MostVoxels)
      throw std::invalid_argument("level set: a point " +
                                  SolidNumber(std::max({ away.x, away.y, away.z })) +
                                  " voxels from 0, at most 2^20; give a larger spacing");
}

/// Points in voxels, as OpenVDB asks for them.
class MeshInVoxels
{
public:
  MeshInVoxels(const TriangleMesh& mesh, double spacing) : Mesh(mesh), PerVoxel(1.0 / spacing) {}
  std::size_t polygonCount() const { return this->Mesh.triangles.size(); }
  std::size_t pointCount() const { return this->Mesh.points.size(); }
  std::size_t vertexCount(std::size_t) const { return 3; }
  void getIndexSpacePoint(std::size_t n, std::size_t v, openvdb::Vec3d& position) const
  {
    const glm::dvec3 p = this->Mesh.points[this->Mesh.triangles[n][int(v)]] * this->PerVoxel;
    position = { p.x, p.y, p.z };
  }

private:
  const TriangleMesh& Mesh;
  double PerVoxel;
};

/// OpenVDB reports shares from the thread that called it alone; its others ask whether to stop.
class Interrupter
{
public:
  explicit Interrupter(const ProgressFunction& progress) : Progress(progress) {}
  void start(const char* = nullptr) {}
  void end() {}
  bool wasInterrupted(int percent = -1)
  {
    if (percent >= 0 && this->Progress && !this->Stop)
      this->Stop = !this->Progress(0.01 * std::min(percent, 99));
    return this->Stop;
  }
  bool Stopped() const { return this->Stop; }

private:
  const ProgressFunction& Progress;
  std::atomic<bool> Stop{ false };
};
} // namespace

openvdb::FloatGrid::Ptr LevelSetOf(
  const TriangleMesh& mesh, double spacing, double bandVoxels, const ProgressFunction& progress)
{
  Check(mesh, spacing, bandVoxels);
  ReportProgress(progress, 0.0);
  Interrupter interrupter(progress);
  const auto transform = openvdb::math::Transform::createLinearTransform(spacing);
  const auto width = static_cast<float>(bandVoxels);
  auto grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
    interrupter, MeshInVoxels(mesh, spacing), *transform, width, width);
  if (interrupter.Stopped())
    throw Cancelled();
  ReportProgress(progress, 1.0);
  return grid;
}

} // namespace hasp
